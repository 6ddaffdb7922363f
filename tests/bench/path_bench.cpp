// A path of a million lines: the picture of it, which the worker makes, and a frame that shows such a picture
// moved along; drawn by ImGui and GL in the frame it would take them 110 ms and more.
#include <array>
#include <cmath>

#include <benchmark/benchmark.h>

#include "gui/surface/offscreen.h"
#include "gui/surface/path_picture.h"
#include "tests/gui/lib/gl_canvas.h"

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

/// As large as the canvas has it drawn: with a margin, for a hand that moves it.
drawing::PathView with_margin(drawing::PathView view) {
  const double per_px = view.per_px().x;
  view.resize(canvas_width + 2 * 256, canvas_height + 2 * 200);
  view.zoom({view.width_px() / 2, view.height_px() / 2}, view.per_px().x / per_px);
  return view;
}

gui::Picture picture_of(const drawing::ToolPath& path, const drawing::PathView& view) {
  return gui::path_picture(std::array{gui::PathLayer{&path, plain()}}, view);
}

void million_lines_picture(benchmark::State& state) {
  const drawing::ToolPath path = small_curves();
  drawing::PathView view = whole(path);
  view.zoom({canvas_width / 2, canvas_height / 2}, static_cast<double>(state.range(0)));
  const drawing::PathView larger = with_margin(view);
  for (auto _ : state) benchmark::DoNotOptimize(picture_of(path, larger));
}
BENCHMARK(million_lines_picture)->ArgName("zoom")->Arg(1)->Arg(4)->Arg(32)->Unit(benchmark::kMillisecond);

/// The same drawing on the flank of a hill, from a corner.
drawing::ToolPath on_a_hill() {
  drawing::ToolPath path = small_curves();
  path.bounds = {};
  for (drawing::Point3& p : path.points) {
    p.z = 60 * std::sin(p.x / 130) * std::sin(p.y / 70);
    path.bounds.add(p);
  }
  return path;
}
drawing::PathView from_a_corner(const drawing::ToolPath& path) {
  const drawing::Projection projection(path.bounds, drawing::views::iso, true);
  return drawing::PathView(path.bounds, projection, canvas_width, canvas_height, true);
}

void million_lines_in_perspective(benchmark::State& state) {
  const drawing::ToolPath path = on_a_hill();
  drawing::PathView view = from_a_corner(path);
  view.zoom({canvas_width / 2, canvas_height / 2}, static_cast<double>(state.range(0)));
  const drawing::PathView larger = with_margin(view);
  for (auto _ : state) benchmark::DoNotOptimize(picture_of(path, larger));
}
BENCHMARK(million_lines_in_perspective)
    ->ArgName("zoom")
    ->Arg(1)
    ->Arg(4)
    ->Arg(32)
    ->Unit(benchmark::kMillisecond);

void few_of_a_million(benchmark::State& state) {
  const drawing::ToolPath path = on_a_hill();
  for (auto _ : state) benchmark::DoNotOptimize(coarser(path, 2500));
}
BENCHMARK(few_of_a_million)->Unit(benchmark::kMillisecond);

/// While it is turned: as the path canvas draws it then.
void frame_with_few_lines(benchmark::State& state) {
  const drawing::ToolPath path = on_a_hill(), few = coarser(path, 2500);
  drawing::PathView view = from_a_corner(path);
  gui::Offscreen surface;
  const auto gl = gui::GlCanvas::open();
  double now = 0, turn = 0;
  for (auto _ : state) {
    turn += 2;
    view.look(view.projection().turned({turn, 30}), path.bounds.centre());
    surface.frame(now += 1.0 / 60, [&](gui::Ui&) {
      ImDrawList* list = ImGui::GetBackgroundDrawList();
      for (const drawing::ToolPath::Run& run : few.runs) {
        for (std::size_t i = run.first; i < run.first + run.size; ++i) {
          const drawing::Point px = view.to_px(few.points[i]);
          list->PathLineTo(ImVec2(static_cast<float>(px.x), static_cast<float>(px.y)));
        }
        list->PathStroke(IM_COL32_WHITE, 0, 2);
      }
    });
    if (gl) gl->draw(surface.screen());
  }
  state.SetLabel(gl ? "gl" : "none");
}
BENCHMARK(frame_with_few_lines)->Unit(benchmark::kMillisecond)->UseRealTime();

void frame_with_picture(benchmark::State& state) {
  const drawing::ToolPath path = small_curves();
  const auto picture = std::make_shared<const gui::Picture>(picture_of(path, with_margin(whole(path))));
  gui::Offscreen surface;
  const auto gl = gui::GlCanvas::open();
  double now = 0;
  float moved = 0;
  for (auto _ : state) {
    surface.frame(now += 1.0 / 60, [&](gui::Ui& ui) {
      moved += 3;
      ImDrawList* list = ImGui::GetBackgroundDrawList();
      list->PushClipRect(ImVec2(50, 50), ImVec2(1250, 850));
      list->AddImage(ui.pictures.show(picture), ImVec2(-206 + moved, -150),
                     ImVec2(1506 + moved * 1.1f, 1050 + moved));
      list->PopClipRect();
    });
    if (gl) gl->draw(surface.screen());
  }
  state.SetLabel(gl ? "gl" : "none");
}
BENCHMARK(frame_with_picture)->Unit(benchmark::kMillisecond)->UseRealTime();

void frame_without(benchmark::State& state) {
  gui::Offscreen surface;
  const auto gl = gui::GlCanvas::open();
  double now = 0;
  for (auto _ : state) {
    surface.frame(now += 1.0 / 60, [](gui::Ui&) {});
    if (gl) gl->draw(surface.screen());
  }
  state.SetLabel(gl ? "gl" : "none");
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
