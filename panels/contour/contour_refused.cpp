// Describes a list that leads past a limit, and offers to shift it so that it fits.
#include <algorithm>
#include <array>
#include <utility>

#include "gui/model/tab.h"
#include "panels/contour/contour.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

/// The shift that brings the list inside the limits. nullopt: it is longer than the allowed range.
std::optional<Steps> Contour::shift_inside(const Frame& f) const {
  const Travel& travel = f.now.axes[past_->axis.index].travel;
  std::optional<Steps> least, greatest;
  for (const AxisTarget& place : worked_.places) {
    if (place.axis != past_->axis) continue;
    least = least ? std::min(*least, place.value) : place.value;
    greatest = greatest ? std::max(*greatest, place.value) : place.value;
  }
  if (!least) return {};
  const Steps by = past_->nearest - (past_->side == Sign::plus ? *greatest : *least);
  const bool fits = travel.past(Sign::minus, *least + by) <= Steps(0) &&
                    travel.past(Sign::plus, *greatest + by) <= Steps(0);
  return fits ? std::optional(by) : std::nullopt;
}

void Contour::shift(const Frame& f, Steps by) {
  const auto shifted = [by](NumberField& field, const ContourUnit& unit) {
    if (const auto steps = unit.steps(field)) unit.put(field, *steps + static_cast<double>(by.value));
  };
  if (stairs_shown_) {
    shifted(stairs_.stop_at, stairs_.unit);
    for (Stair& stair : stairs_.rows) shifted(stair.until, stairs_.unit);
  } else {
    const bool right =
        f.catalog.axes[past_->axis.index].name == names_.axes[static_cast<std::size_t>(contour_.first)];
    shifted(right ? contour_.x : contour_.y, contour_.unit);
    for (Piece& piece : contour_.pieces)
      if (piece.kind != PieceKind::output) shifted(right ? piece.x : piece.y, contour_.unit);
  }
  edited();
}

void Contour::draw_refused(Frame& f, const Rect& beside) {
  if (worked_.places != refused_places_) past_.reset();  // the list was changed
  if (!past_) return;
  const auto by = shift_inside(f);
  const ContourUnit& unit =
      stairs_shown_ ? stairs_.unit : contour_.unit;  // the unit in which the list is typed
  const DisplayUnit typed{unit.name, unit.per_step, unit.decimals, true};
  const Path label("Shift it by {}", format_with_unit(by.value_or(Steps()), typed).view());
  const std::array<Action, 1> actions = {Action{.id = "contour/nearest", .label = label}};
  const Refusal what{
      .id = "contour/refused", .about = "Run", .words = refused_, .actions = {actions.data(), by ? 1u : 0u}};
  card_.begin(f, what, beside);
  const RefusalTouch done = card_.end();
  if (done.action == 0) shift(f, *by);
  if (done.action == 0 || done.closed) past_.reset();
}

}  // namespace hw::panels
