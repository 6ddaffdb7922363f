#include "panels/blocks/block_teach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/index.h"
#include "core/sequence/places_before.h"
#include "gui/model/tab.h"

namespace hw::panels {

using namespace gui;
namespace seq = sequence;
namespace {

constexpr std::string_view not_seen = "The positions of the axes are not known now.";
constexpr std::string_view start_is_unknown =
    "Put a move to a place before this block: its start is unknown.";

/// The present position in the unit of the sequence. nullopt: it is stale or unknown.
std::optional<double> stands_at(const Frame& f, const seq::Sequence& s, int axis) {
  if (axis < 0 || ix(axis) >= s.axes.size()) return std::nullopt;
  const int place = f.catalog.find_axis(s.axes[ix(axis)].name);
  if (place < 0 || !f.connected()) return std::nullopt;
  const AxisState& state = f.now.axes[ix(place)];
  if (!state.position_known || is_stale(state.seen_at, f.clock, f.now.poll_period)) return std::nullopt;
  return static_cast<double>(state.commanded().value) / s.axes[ix(axis)].per_unit;
}

/// The targets of the axes that the block names, or of all axes while it names none.
seq::Places targets(const Frame& f, const seq::Sequence& s, const seq::Places& named) {
  const bool untouched =
      std::all_of(named.begin(), named.end(), [](const auto& to) { return !to || *to == 0; });
  seq::Places all;
  for (std::size_t a = 0; a < s.axes.size() && a < all.size(); ++a)
    if (named[a] || untouched) all[a] = stands_at(f, s, static_cast<int>(a));
  return all;
}

/// The angle from the beginning of the arc, in its present direction.
double degrees_to(const seq::Arc& arc, double from_x, double from_y, double x, double y) {
  const double turn = std::atan2(y - arc.y, x - arc.x) - std::atan2(from_y - arc.y, from_x - arc.x);
  double degrees = std::fmod(turn / std::numbers::pi * 180, 360);
  if (arc.degrees >= 0 && degrees <= 0) degrees += 360;
  if (arc.degrees < 0 && degrees >= 0) degrees -= 360;
  return std::round(degrees * 1000) / 1000;
}

}  // namespace

std::array<Lesson, 2> BlockTeach::lessons(const seq::Step::Body& body) {
  using What = Lesson::What;
  const Lesson here{"blocks/here", "Take here", What::place};
  if (const auto* move = std::get_if<seq::Move>(&body))
    return {move->relative ? Lesson{"blocks/here", "Take here", What::distance} : here};
  if (const auto* some = std::get_if<seq::MoveOnInput>(&body))
    return {some->kind == seq::MoveOnInput::Kind::move ? here : Lesson{}};
  if (std::holds_alternative<seq::Contour>(body)) return {here};
  if (const auto* arc = std::get_if<seq::Arc>(&body)) {
    const bool circle = std::fabs(arc->degrees) == 360;
    return {Lesson{"blocks/here", "Centre here", What::centre},
            circle ? Lesson{} : Lesson{"blocks/here_end", "End here", What::end}};
  }
  return {};
}

const seq::Places& BlockTeach::begins_at(const seq::Editor& editor, const seq::StepPath& path) {
  if (version_ != editor.version() || of_ != path) {
    version_ = editor.version(), of_ = path;
    begins_at_ = places_before(editor.sequence(), path);
  }
  return begins_at_;
}

std::string_view BlockTeach::why_not(const Frame& f, const seq::Editor& editor, const seq::StepPath& path,
                                     Lesson::What what) {
  const seq::Sequence& s = editor.sequence();
  const seq::Step* step = editor.at(path);
  if (!step) return not_seen;
  const seq::Places& from = begins_at(editor, path);
  if (const auto* move = std::get_if<seq::Move>(&step->body)) {
    const seq::Places now = targets(f, s, move->to);
    bool any = false, any_known = false;
    for (std::size_t a = 0; a < now.size(); ++a)
      any = any || now[a], any_known = any_known || (now[a] && from[a]);
    if (!any) return not_seen;
    return what == Lesson::What::distance && !any_known ? start_is_unknown : std::string_view();
  }
  if (const auto* some = std::get_if<seq::MoveOnInput>(&step->body))
    return stands_at(f, s, some->axis) ? std::string_view() : not_seen;
  const seq::Plane* plane = seq::plane_of(step->body);
  if (!plane || !stands_at(f, s, plane->right) || !stands_at(f, s, plane->up)) return not_seen;
  const bool begins = from[ix(plane->right)] && from[ix(plane->up)];
  return what == Lesson::What::end && !begins ? start_is_unknown : std::string_view();
}

std::optional<seq::Step::Body> BlockTeach::teach(const Frame& f, const seq::Editor& editor,
                                                 const seq::StepPath& path, Lesson::What what) {
  if (!why_not(f, editor, path, what).empty()) return std::nullopt;
  const seq::Sequence& s = editor.sequence();
  const seq::Places& from = begins_at(editor, path);
  seq::Step::Body body = editor.at(path)->body;
  if (auto* move = std::get_if<seq::Move>(&body)) {
    const seq::Places now = targets(f, s, move->to);
    for (std::size_t a = 0; a < now.size(); ++a)
      if (now[a] && (!move->relative || from[a])) move->to[a] = move->relative ? *now[a] - *from[a] : *now[a];
    return body;
  }
  if (auto* some = std::get_if<seq::MoveOnInput>(&body)) return some->to = *stands_at(f, s, some->axis), body;
  const auto [right, up] = *seq::plane_of(body);
  const double x = *stands_at(f, s, right), y = *stands_at(f, s, up);
  if (auto* contour = std::get_if<seq::Contour>(&body)) {
    contour->x = x, contour->y = y;
  } else if (auto* arc = std::get_if<seq::Arc>(&body)) {
    if (what == Lesson::What::end)
      arc->degrees = degrees_to(*arc, *from[ix(right)], *from[ix(up)], x, y);
    else
      arc->x = x, arc->y = y;
  }
  return body;
}

}  // namespace hw::panels
