#include "panels/path/path_backdrop.h"

#include <algorithm>
#include <array>
#include <utility>

#include "gui/model/tab.h"
#include "panels/path/path_trace.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::size_t drawn_after = 500;   // so many new points of the trace
constexpr int older_after_s = 5;           // of its way: what has become older is drawn as that
constexpr std::size_t most_coarse = 2500;  // points in a frame

PathLook look_of(const Ui& ui) {
  PathLook look;
  look.tool_on = ui[Tone::ink], look.tool_off = ui[Tone::ink3];
  look.on_width = 2 * ui.hair(), look.off_width = ui.hair();
  look.dash = ui.px(5), look.dash_gap = ui.px(4);
  look.arrow_every = ui.px(110), look.arrow = ui.px(9);
  return look;
}

}  // namespace

ImVec2 on_screen(const Rect& in, drawing::Point px) {
  const auto within = [](double v) { return static_cast<float>(std::clamp(v, -1e5, 1e5)); };
  return ImVec2(in.min.x + within(px.x), in.min.y + within(px.y));
}

void PathBackdrop::follow(Frame& f, const PathSubject& s, const drawing::ToolPath& trace,
                          const drawing::PathView& view, bool turning) {
  const PathLook look = look_of(f.ui);
  const std::size_t traced = trace.points.size();
  const int until = trace.runs.empty() ? 0 : trace.runs.back().source;
  const bool there = shown_.path == s.path && shown_.commanded == s.commanded && shown_.view == view &&
                     shown_.look == look && traced >= shown_.traced && traced < shown_.traced + drawn_after &&
                     until < shown_.traced_until + older_after_s;
  if (there || under_way_) return;
  if (turning) return f.ui.wake_in(0);
  PathLook meant = look;
  meant.tool_on = meant.tool_off = f.ui[Tone::trace], meant.on_width = f.ui.hair(), meant.arrow_every = 0;
  std::array<PathLook, TraceAges::count> of_trace;
  for (std::size_t age = 0; age < TraceAges::count; ++age)
    of_trace[age].tool_on = trace_colour(f.ui, age), of_trace[age].on_width = trace_width(f.ui, age);
  under_way_ = true;
  const SharedPath coarse = shown_.path == s.path ? shown_.coarse : nullptr;
  Shown next{nullptr, s.path, s.commanded, coarse, view, look, traced, until};
  f.tab.desk().worker().run(
      [next, trace, meant, of_trace]() mutable {
        static const drawing::ToolPath none;
        const auto layer = [](const SharedPath& path, const PathLook& drawn) {
          return PathLayer{path ? path.get() : &none, drawn};
        };
        std::array<PathLayer, 2 + TraceAges::count> layers{layer(next.commanded, meant),
                                                           layer(next.path, next.look)};
        const TraceAges ages = ages_of(trace);
        for (std::size_t age = 0; age < TraceAges::count; ++age)
          layers[2 + age] = {&trace, of_trace[age], ages.begin[age],
                             age + 1 < TraceAges::count ? ages.begin[age + 1] : trace.runs.size()};
        next.picture = std::make_shared<const Picture>(path_picture(layers, next.view));
        if (next.path && !next.coarse && !next.view.flat())
          next.coarse = std::make_shared<const drawing::ToolPath>(coarser(*next.path, most_coarse));
        return next;
      },
      [this](Shown done) {
        under_way_ = false;
        shown_ = std::move(done);
      },
      alive_);
  f.ui.wake_in(0);  // without a thread it is done with the next frame
}

void PathBackdrop::draw(Frame& f, const Rect& in, const PathSubject& s, const drawing::PathView& view) const {
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (fits(view)) {
    const drawing::PathView& of = shown_.view;
    const ImVec2 min = on_screen(in, view.moved_px(of, {0, 0})),
                 max = on_screen(in, view.moved_px(of, {of.width_px(), of.height_px()}));
    return list->AddImage(f.ui.pictures.show(shown_.picture), min, max);
  }
  if (!shown_.coarse || shown_.path != s.path) return;
  for (const drawing::ToolPath::Run& run : shown_.coarse->runs) {
    for (std::size_t i = run.first; i < run.first + run.size; ++i)
      list->PathLineTo(on_screen(in, view.to_px(shown_.coarse->points[i])));
    list->PathStroke(run.tool_on ? shown_.look.tool_on : shown_.look.tool_off, 0,
                     run.tool_on ? shown_.look.on_width : shown_.look.off_width);
  }
}

}  // namespace hw::panels
