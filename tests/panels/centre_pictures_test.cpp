// Pictures of the centre panels with a real catalog and language, to be looked at:
// build/pictures/centre-*.png.
#include <filesystem>

#include "core/device/registry.h"
#include "panels/program/program.h"
#include "panels/setup/setup.h"
#include "panels/terminal.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

struct Shape {
  const char* name;
  int width, program_height, terminal_height;
  float scale;
  gui::Tier tier;
  bool dark;
};
constexpr Shape shapes[] = {{"wide-dark", 864, 456, 300, 1, gui::Tier::wide, true},
                            {"wide-light", 864, 456, 300, 1, gui::Tier::wide, false},
                            {"medium", 704, 452, 116, 1, gui::Tier::medium, true},
                            {"narrow", 720, 266, 266, 2, gui::Tier::narrow, false}};

constexpr const char* plate_scan =
    "; plate scan: 20 rows, camera flash on output 1\nS1M2000, A1M2       ; across at 5 mm/s\n"
    "S2M1000             ; rows at 2.5 mm/s\nIA1M0               ; start at the left edge\n"
    "LM0                 ; each row from here\nI1M4800             ; across, 12 mm\n"
    "PA5                 ; flash 0.5 s\nS2M1000\nI2M400              ; next row, 1 mm\nL-20                "
    "; 20 rows, back and forth\n";

std::string path_of(const char* panel, const Shape& shape) {
  const std::filesystem::path folder = HW_BINARY_DIR "/pictures";
  std::filesystem::create_directories(folder);
  return (folder / ("centre-" + std::string(panel) + "-" + shape.name + ".png")).string();
}

struct Device {
  const DeviceType& type = device_types().front();
  Catalog catalog = *type.make_catalog({});
};

TEST(CentrePictures, Program) {
  const Device d;
  for (const Shape& shape : shapes) {
    Program panel;
    test::PanelStage s(panel, shape.width, shape.program_height, shape.scale, shape.tier, shape.dark,
                       d.catalog, &d.type.language());
    gui::ProgramTexts& texts = s.tab.desk().programs.texts;
    texts.opened(0, "/home/somebody/plate-scan.vxm", TextFile{plate_scan});
    texts.loaded(0, plate_scan, s.tab.clock());
    s.stage.frames(2);
    ASSERT_TRUE(s.stage.hand.key("F5"));
    s.stage.frames(3);
    std::string edited = plate_scan;
    edited.replace(edited.find("S2M1000\nI2M"), 7, "S2M8000");
    texts.set_text(0, edited);
    s.now.program.run = RunState::running, s.now.program.owned = true, s.now.program.slot = 0;
    s.now.program.command = 5;
    s.stage.frames(3);
    EXPECT_TRUE(s.stage.surface.screenshot(path_of("program", shape)));
  }
}

TEST(CentrePictures, Setup) {
  const Device d;
  for (const Shape& shape : shapes) {
    panels::Setup panel;
    test::PanelStage s(panel, shape.width, shape.program_height + shape.terminal_height, shape.scale,
                       shape.tier, shape.dark, d.catalog, &d.type.language());
    s.now.params[0].value = 4;
    s.now.params[0].stored = false;
    s.now.unsaved_setup = true;
    s.stage.frames(3);
    const ParamInfo& number = s.catalog.params[static_cast<std::size_t>(s.catalog.find_param("Bx"))];
    ASSERT_TRUE(s.stage.hand.type("setup/" + number.mnemonic, "20\n"));
    s.stage.frames(3);
    EXPECT_TRUE(s.stage.surface.screenshot(path_of("setup", shape)));
  }
}

TEST(CentrePictures, Terminal) {
  const Device d;
  for (const Shape& shape : shapes) {
    Terminal panel;
    test::PanelStage s(panel, shape.width, shape.terminal_height, shape.scale, shape.tier, shape.dark,
                       d.catalog, &d.type.language(), d.type.explain);
    s.tab.desk().records.traffic.set_clock(gui::DayClock{std::chrono::hours(14) + std::chrono::minutes(2)});
    double at = 4.951;
    const auto wire = [&](Way way, TrafficKind kind, const char* bytes) {
      TrafficEntry e;
      e.at = Instant(from_seconds(at += 0.007)), e.way = way, e.kind = kind, e.bytes = bytes;
      s.tab.desk().records.traffic.append(e);
    };
    for (const char* line : {"PM-0\r", "S1M2000\r", "A1M2\r", "S2M1000\r", "IA1M0\r", "LM0\r", "L-20\r"})
      wire(Way::sent, TrafficKind::transfer, line);
    wire(Way::sent, TrafficKind::intent, "M\r");
    wire(Way::received, TrafficKind::intent, "229\r");
    wire(Way::sent, TrafficKind::intent, "R\r");
    for (int i = 0; i < 2916; ++i) {
      wire(Way::sent, TrafficKind::poll, i % 3 ? "X" : "V");
      wire(Way::received, TrafficKind::poll, i % 3 ? "+0003120\r" : "B");
    }
    wire(Way::received, TrafficKind::unparsed, "\x81\xFE");
    wire(Way::sent, TrafficKind::intent, "X");
    wire(Way::received, TrafficKind::intent, "+0003120\r");
    s.type("terminal/command", "S1M");
    s.stage.frames(3);
    EXPECT_TRUE(s.stage.surface.screenshot(path_of("terminal", shape)));
  }
}

}  // namespace
}  // namespace hw::panels
