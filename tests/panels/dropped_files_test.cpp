// What becomes of files that are dropped on the window.
#include <gmock/gmock.h>

#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"
#include "panels/panel_list.h"
#include "tests/core/session/folder.h"
#include "tests/gui/stage.h"
#include "tests/panels/drawing_stage.h"
#include "tests/panels/must.h"
#include "transports/open.h"

namespace hw::panels {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class DroppedFiles : public testing::Test {
 protected:
  test::Folder folder;
  IoContext io;
  VirtualScheduler time{io};
  gui::Console console{panel_list(), gui::Outside(time, make_wire_opener(), [] {})};
  gui::Stage stage{[this](gui::Ui& ui) {
                     time.run_until(Instant(from_seconds(stage.now_s)));
                     console.draw(ui);
                   },
                   1440, 900};

  ~DroppedFiles() override {
    console.close_all();
    time.run_until(time.now() + std::chrono::seconds(10), [this] { return console.closing() == 0; });
  }
  gui::Tab& open(const char* address) {
    console.attach(stage.surface.screen().keyboard());
    const auto tab = console.open(address);
    EXPECT_TRUE(tab) << tab.error().sentence();
    stage.frames(120);
    return **tab;
  }
  void drop(const std::vector<std::filesystem::path>& files) {
    std::vector<std::string> names;
    for (const auto& file : files) names.push_back(file.string());
    console.drop(names);
    stage.frames(30);
  }
  std::string drawing(const char* name) { return folder.put(name, std::string(square_and_text)).string(); }
  std::vector<std::string> reported() {
    std::vector<std::string> all;
    for (const auto& toast : console.toasts().list()) all.push_back(toast.text);
    return all;
  }
};

TEST_F(DroppedFiles, OfTwoDrawingsTheFirstIsOpenedAndTheOtherNamed) {
  open("pmx-4ex-sa@emulator");
  drop({drawing("a.dxf"), drawing("b.DXF")});
  EXPECT_THAT(reported(),
              ElementsAre("b.DXF was not opened: Drawing takes one file at a time, and opens a.dxf."));
  EXPECT_EQ(stage.hand.value("drawing/size").value_or("(none)"), "20.000 x 10.000 mm");
}

TEST_F(DroppedFiles, ADrawingAndAProgramAreBothOpened) {
  gui::Tab& tab = open("pmx-4ex-sa@emulator");
  drop({folder.put("a.prg", "X1000\nEND\n"), drawing("a.dxf")});
  MUST(stage.hand.click("tab/program"));
  stage.frames(10);
  EXPECT_EQ(tab.desk().programs.texts.text(0), "X1000\nEND\n");
  MUST(stage.hand.click("tab/drawing"));
  stage.frames(10);
  EXPECT_EQ(stage.hand.value("drawing/size").value_or("(none)"), "20.000 x 10.000 mm");
  EXPECT_THAT(reported(), IsEmpty());
}

TEST_F(DroppedFiles, ADrawingForASingleAxisIsNoProgram) {
  gui::Tab& tab = open("dmx-k-sa@emulator");
  drop({drawing("a.dxf")});
  EXPECT_THAT(reported(),
              ElementsAre("a.dxf was not opened: it needs the tab Drawing, which this controller does "
                          "not have."));
  EXPECT_EQ(tab.desk().programs.texts.text(0), "");
}

TEST_F(DroppedFiles, AFolderIsNamedAsOne) {
  open("pmx-4ex-sa@emulator");
  for (const char* name : {"parts", "parts.dxf", "parts.toml"}) {
    std::filesystem::create_directory(folder.path() / name);
    console.toasts().dismiss_all();
    drop({folder.path() / name});
    EXPECT_THAT(reported(), ElementsAre(HasSubstr(std::string(name) + " is a folder.")));
  }
}

TEST_F(DroppedFiles, AFileThatIsNoDrawingReportsWhy) {
  open("pmx-4ex-sa@emulator");
  drop({folder.put("photo.dxf", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16))});
  EXPECT_THAT(reported(), ElementsAre(HasSubstr("photo.dxf")));
  EXPECT_THAT(reported(), ElementsAre(HasSubstr("Is it a DXF file?")));
}

TEST_F(DroppedFiles, ASequenceIsOpenedAsBlocks) {
  gui::Tab& tab = open("pmx-4ex-sa@emulator");
  drop({folder.put("a.toml",
                   "handwheel_sequence = 1\nunit = \"mm\"\naxes = [ { name = \"X\", per_unit = 100 } ]\n"
                   "steps = [ { do = \"comment\", text = \"hello\" } ]\n")});
  EXPECT_EQ(tab.desk().blocks.editor.sequence().steps.size(), 1u);
  EXPECT_THAT(reported(), IsEmpty());
}

}  // namespace
}  // namespace hw::panels
