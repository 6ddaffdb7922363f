#include "panels/path/path_backdrop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "gui/model/tab.h"
#include "panels/path/path_trace.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::size_t drawn_after = 500;  // the picture is redrawn after so many new points of the trace
constexpr int older_after_s = 5;  // the trace is redrawn after this time, because its parts fade with age
constexpr std::size_t most_coarse = 2500;   // points per frame
constexpr std::size_t times_redrawn = 200;  // redraws during a complete path

PathLook look_of(const Ui& ui) {
  PathLook look;
  look.tool_on = ui[Tone::ink], look.tool_off = ui[Tone::ink3];
  look.on_width = 2 * ui.hair(), look.off_width = ui.hair();
  look.dash = ui.px(5), look.dash_gap = ui.px(4);
  look.arrow_every = ui.px(110), look.arrow = ui.px(9);
  return look;
}

PathLook still_to_do(PathLook look, const Ui& ui) {
  look.tool_on = ui[Tone::ink3], look.on_width = 1.5f * ui.hair();
  return look;
}

/// The margin keeps the border of the picture out of view while the user pans.
drawing::PathView with_margin(const drawing::PathView& view) {
  constexpr double share = 0.25, most_px = 256;
  const auto wider = [=](double px) { return px + 2 * std::floor(std::min(share * px, most_px)); };
  drawing::PathView wide = view;
  wide.resize(wider(view.width_px()), wider(view.height_px()));
  wide.zoom({wide.width_px() / 2, wide.height_px() / 2}, wide.per_px().x / view.per_px().x);
  return wide;
}

}  // namespace

static int latest_source(const drawing::ToolPath& trace) {
  return trace.runs.empty() ? 0 : trace.runs.back().source;
}

ImVec2 on_screen(const Rect& in, drawing::Point px) {
  const auto within = [](double v) { return static_cast<float>(std::clamp(v, -1e5, 1e5)); };
  return ImVec2(in.min.x + within(px.x), in.min.y + within(px.y));
}

/// Whether the done part is drawn far enough. On a long path it advances in steps that are too small to be
/// seen.
static bool as_far(const std::optional<std::size_t>& shown, const std::optional<std::size_t>& done,
                   const PathSubject& s) {
  if (!shown || !done) return shown == done;
  const std::size_t step = 1 + (s.path ? s.path->runs.size() : 0) / times_redrawn;
  return *done >= *shown && *done < *shown + step;
}

bool PathBackdrop::still_shows(const Wanted& w, const PathLook& look) const {
  const PathSubject& s = w.subject;
  const std::size_t traced = w.trace.points.size();
  const int until = latest_source(w.trace);
  return shown_.path == s.path && shown_.commanded == s.commanded && shown_.of == w.view &&
         shown_.look == look && as_far(shown_.done, w.done, s) && traced >= shown_.traced &&
         traced < shown_.traced + drawn_after && until < shown_.traced_until + older_after_s;
}

void PathBackdrop::follow(Frame& f, const Wanted& w) {
  const PathSubject& s = w.subject;
  const PathLook look = look_of(f.ui);
  if (still_shows(w, look) || under_way_) return;
  if (w.turning) return f.ui.wake_in(0);
  PathLook meant = look;
  meant.tool_on = meant.tool_off = f.ui[Tone::trace], meant.on_width = f.ui.hair(), meant.arrow_every = 0;
  std::array<PathLook, TraceAges::count> of_trace;
  for (std::size_t age = 0; age < TraceAges::count; ++age)
    of_trace[age].tool_on = trace_colour(f.ui, age), of_trace[age].on_width = trace_width(f.ui, age);
  under_way_ = true;
  const SharedPath coarse = shown_.path == s.path ? shown_.coarse : nullptr;
  Shown next{nullptr,
             s.path,
             s.commanded,
             coarse,
             w.view,
             with_margin(w.view),
             w.done,
             look,
             w.trace.points.size(),
             latest_source(w.trace)};
  f.tab.desk().work.worker().run_short(
      [next, trace = w.trace, meant, to_do = still_to_do(look, f.ui), of_trace]() mutable {
        static const drawing::ToolPath none;
        const auto path_of = [](const SharedPath& path) { return path ? path.get() : &none; };
        const std::size_t all = path_of(next.path)->runs.size(), done = next.done.value_or(all);
        std::array<PathLayer, 3 + TraceAges::count> layers{{{path_of(next.commanded), meant},
                                                            {path_of(next.path), to_do, done, all},
                                                            {path_of(next.path), next.look, 0, done}}};
        const TraceAges ages = ages_of(trace);
        for (std::size_t age = 0; age < TraceAges::count; ++age)
          layers[3 + age] = {&trace, of_trace[age], ages.begin[age],
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
  f.ui.wake_in(0);  // without a thread the next frame draws it
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
