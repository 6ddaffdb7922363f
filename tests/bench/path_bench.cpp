// A path of a million lines: the picture of it, which the worker makes, and a frame that shows such a picture
// moved along; drawn by ImGui and GL in the frame it would take them 110 ms and more.
#include <array>
#include <cmath>

#include <benchmark/benchmark.h>

#include "gui/offscreen.h"
#include "gui/path_picture.h"

namespace hw {
namespace {

constexpr int million = 1'000'000;
constexpr double canvas_width = 1200, canvas_height = 800;

/// A drawing as they are: many small curves all over the table.
drawing::ToolPath small_curves() {
  drawing::ToolPath path;
  drawing::Point at{0, 0};
  for (int i = 0; i < million; ++i) {
    const double turn = i * 0.05, row = i / 20'000 * 4.0;
    const drawing::Point to{(i % 20'000) * 0.02 + std::cos(turn), row + std::sin(turn)};
    path.go(at, to, i % 97 != 0, i);
    at = to;
  }
  return path;
}
gui::PathLook plain() { return {IM_COL32_WHITE, IM_COL32(150, 150, 150, 255), 2, 1, 5, 4}; }
drawing::PathView whole(const drawing::ToolPath& path) {
  return drawing::PathView(path.bounds, canvas_width, canvas_height, true);
}

gui::Picture picture_of(const drawing::ToolPath& path, const drawing::PathView& view) {
  return gui::path_picture(std::array{gui::PathLayer{&path, plain()}}, view);
}

void million_lines_picture(benchmark::State& state) {
  const drawing::ToolPath path = small_curves();
  drawing::PathView view = whole(path);
  view.zoom({canvas_width / 2, canvas_height / 2}, static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(picture_of(path, view));
}
BENCHMARK(million_lines_picture)->ArgName("zoom")->Arg(1)->Arg(4)->Arg(32)->Unit(benchmark::kMillisecond);

void frame_with_picture(benchmark::State& state) {
  const drawing::ToolPath path = small_curves();
  const auto picture = std::make_shared<const gui::Picture>(picture_of(path, whole(path)));
  gui::Offscreen surface(1440, 900, 1, true, gui::Renderer::gl);
  double now = 0;
  float moved = 0;
  for (auto _ : state) {
    surface.frame(now += 1.0 / 60, [&](gui::Ui& ui) {
      moved += 3;
      ImGui::GetBackgroundDrawList()->AddImage(ui.pictures.show(picture), ImVec2(50 + moved, 50),
                                               ImVec2(1250 + moved * 1.1f, 850 + moved));
    });
    surface.draw_with_gl();
  }
  state.SetLabel(std::string(surface.renderer()));
}
BENCHMARK(frame_with_picture)->Unit(benchmark::kMillisecond)->UseRealTime();

void frame_without(benchmark::State& state) {
  gui::Offscreen surface(1440, 900, 1, true, gui::Renderer::gl);
  double now = 0;
  for (auto _ : state) {
    surface.frame(now += 1.0 / 60, [](gui::Ui&) {});
    surface.draw_with_gl();
  }
  state.SetLabel(std::string(surface.renderer()));
}
BENCHMARK(frame_without)->Unit(benchmark::kMillisecond)->UseRealTime();

void nearest_of_a_million(benchmark::State& state) {
  const drawing::ToolPath path = small_curves();
  const drawing::PathView view = whole(path);
  for (auto _ : state) benchmark::DoNotOptimize(nearest(path, view, {321, 456}, 8));
}
BENCHMARK(nearest_of_a_million)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace hw
