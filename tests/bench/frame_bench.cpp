// One frame of the whole console outside of GL, with four live controllers, and with five and five thousand
// blocks; what a frame at rest takes from the heap; and the anchor: ImGui's own demo window with a table of
// 600 cells and 60 buttons, in the same run.
#include <ctime>

#include <benchmark/benchmark.h>

#include "core/device/registry.h"
#include "core/sequence/editor.h"
#include "core/session/session.h"
#include "core/time/virtual_scheduler.h"
#include "gui/model/tab.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"
#include "gui/surface/automation.h"
#include "gui/surface/offscreen.h"
#include "panels/panel_list.h"
#include "tests/bench/allocations.h"
#include "transports/open.h"

namespace hw {
namespace {

const ImVec2 window_size(1440, 900);
constexpr Duration frame_time{16'666'667};

struct Screenful {
  explicit Screenful(const char* address = "vxm@emulator,motors=4", int controllers = 4) {
    count_imgui_allocations();
    for (int i = 0; i < controllers; ++i) (void)console.open(address);
    run(600);  // connected, and everything that is made once is made
  }
  ~Screenful() {
    console.close_all();
    while (console.closing() > 0) time.run_for(frame_time);
  }
  void pass() { time.run_for(frame_time); }
  void draw() {
    surface.screen().frame(seconds(time.now()), window_size, [this](gui::Ui& ui) { console.draw(ui); });
  }
  void run(int frames) {
    for (; frames > 0; --frames) pass(), draw();
  }

  IoContext io{1};
  VirtualScheduler time{io};
  gui::Offscreen surface{1440, 900, 1, true};
  gui::Console console{panels::panel_list(), gui::Outside(time, make_wire_opener(), [] {})};
};

double processor_s() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void time_frames(benchmark::State& state, Screenful& screen) {
  std::uint64_t taken = 0;
  for (auto _ : state) {
    screen.pass();
    const auto taken_before = allocations();
    const double began = processor_s();
    screen.draw();
    state.SetIterationTime(processor_s() - began);
    taken += allocations() - taken_before;
  }
  state.counters["allocations_per_frame"] =
      static_cast<double>(taken) / static_cast<double>(state.iterations());
}

void console_frame_moving(benchmark::State& state) {
  Screenful screen;
  for (const auto& tab : screen.console.tabs())
    tab->send(intent::JogStart(AxisId{0}, Sign::plus, Pps(2000), false));
  screen.run(60);
  time_frames(state, screen);
}
BENCHMARK(console_frame_moving)->UseManualTime()->Unit(benchmark::kMicrosecond);

void console_frame_at_rest(benchmark::State& state) {
  Screenful screen;
  time_frames(state, screen);
}
BENCHMARK(console_frame_at_rest)->UseManualTime()->Unit(benchmark::kMicrosecond);

void connection_page_at_rest(benchmark::State& state) {
  Screenful screen;
  screen.console.show_page("connect");
  screen.run(60);
  time_frames(state, screen);
}
BENCHMARK(connection_page_at_rest)->UseManualTime()->Unit(benchmark::kMicrosecond);

/// Blocks as they are looked at: the first move is chosen and its fields are open.
struct BlocksShown : Screenful {
  explicit BlocksShown(int count) : Screenful("pmx-4ex-sa@emulator", 1) {
    sequence::Editor& editor = blocks();
    sequence::Sequence s = editor.sequence();
    s.steps = {{sequence::Speed{{20'000, 100, 100}}}};
    for (int i = 1; i < count; ++i) s.steps.push_back({move_to(i)});
    editor.load(std::move(s));
    console.show_panel("blocks");
    run(60);
    (void)hand.click("blocks/2");
    run(600);
  }
  static sequence::Move move_to(int place) {
    sequence::Move move;
    move.to[0] = place % 1000, move.to[1] = place % 7;
    return move;
  }
  sequence::Editor& blocks() { return console.tabs().front()->desk().blocks.editor; }
  gui::Automation hand{surface, [this] { pass(), draw(); }, [this] { return seconds(time.now()); }};
};

void blocks_at_rest(benchmark::State& state) {
  BlocksShown shown(static_cast<int>(state.range(0)));
  time_frames(state, shown);
}
BENCHMARK(blocks_at_rest)->Arg(5)->Arg(5000)->UseManualTime()->Unit(benchmark::kMicrosecond);

/// The frame in which one of them is changed, by a hand as fast as the frames.
void blocks_typed_in(benchmark::State& state) {
  BlocksShown shown(static_cast<int>(state.range(0)));
  int place = 0;
  for (auto _ : state) {
    shown.pass();
    const double began = processor_s();
    shown.blocks().replace({1}, BlocksShown::move_to(++place));
    shown.draw();
    state.SetIterationTime(processor_s() - began);
  }
}
BENCHMARK(blocks_typed_in)->Arg(5)->Arg(5000)->UseManualTime()->Unit(benchmark::kMicrosecond);

void cells_and_buttons() {
  ImGui::Begin("table");
  if (ImGui::BeginTable("cells", 10)) {
    for (int i = 0; i < 600; ++i) {
      ImGui::TableNextColumn();
      ImGui::Text("%d", i * 37);
    }
    ImGui::EndTable();
  }
  for (int i = 0; i < 60; ++i) {
    ImGui::PushID(i);
    ImGui::Button("button");
    if (i % 10 != 9) ImGui::SameLine();
    ImGui::PopID();
  }
  ImGui::End();
}

void imgui_demo_frame(benchmark::State& state) {
  ImGuiContext* const before = ImGui::GetCurrentContext();
  ImGui::SetCurrentContext(ImGui::CreateContext());
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = window_size;
  unsigned char* pixels = nullptr;
  int w = 0, h = 0;
  io.Fonts->GetTexDataAsRGBA32(&pixels, &w, &h);
  for (auto _ : state) {
    io.DeltaTime = 1.0f / 60;
    ImGui::NewFrame();
    ImGui::ShowDemoWindow();
    ImGui::SetNextWindowSize(ImVec2(900, 800), ImGuiCond_Once);
    cells_and_buttons();
    ImGui::Render();
  }
  ImGui::DestroyContext();
  ImGui::SetCurrentContext(before);
}
BENCHMARK(imgui_demo_frame)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace hw
