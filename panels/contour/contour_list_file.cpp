// Reads the lists of the contour panel from a file and writes them to one.
#include <algorithm>

#include "gui/model/tab.h"
#include "panels/contour/contour.h"

namespace hw::panels {

using namespace gui;

Result<sequence::Sequence> Contour::shown_list() const {
  const ContourUnit& unit = stairs_shown_ ? stairs_unit_ : unit_;
  return (stairs_shown_ ? staircase() : contour()).map([&](sequence::Sequence&& s) {
    return in_unit(std::move(s), unit.per_step, unit.name);
  });
}

/// If the file names an axis or output that this controller lacks, the list stays as it is.
void Contour::opened(Frame& f, const sequence::Sequence& s) {
  const bool stairs = std::holds_alternative<sequence::SpeedStairs>(s.steps.front().body);
  if (!(stairs ? take_staircase(s) : take_contour(s)))
    return f.toast(Severity::fault,
                   "The file names an axis or an output that this controller does not have. The list here is "
                   "as it was.");
  stairs_shown_ = stairs;
  (stairs ? stairs_unkept_ : contour_unkept_) = false;
  changed_ = true;
}

bool Contour::take_contour(const sequence::Sequence& s) {
  const auto& c = std::get<sequence::Contour>(s.steps.front().body);
  const auto place_of = [](const auto& list, const auto& wanted) {
    const auto found = std::find(list.begin(), list.end(), wanted);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
  };
  const int right = place_of(axis_names_, s.axes[0].name), up = place_of(axis_names_, s.axes[1].name);
  if (right < 0 || up < 0) return false;
  std::vector<Piece> pieces;
  for (const sequence::Step& step : c.steps) {
    Piece& p = pieces.emplace_back();
    if (const auto* output = std::get_if<sequence::Output>(&step.body)) {
      p.kind = PieceKind::output, p.on = output->on;
      p.output = place_of(outputs_, output->output);
      if (p.output < 0) return false;
    } else if (const auto* arc = std::get_if<sequence::Arc>(&step.body)) {
      p.kind = PieceKind::arc;
      unit_.put(p.x, arc->x), unit_.put(p.y, arc->y), p.degrees.set(arc->degrees, 3);
    } else {
      const auto& line = std::get<sequence::Move>(step.body);
      unit_.put(p.x, line.to[0].value_or(0)), unit_.put(p.y, line.to[1].value_or(0));
    }
  }
  pieces_ = std::move(pieces);
  first_ = right, second_ = up, ramp_ = c.ends_ramped;
  unit_.put(x_, c.x), unit_.put(y_, c.y), unit_.put_long(lead_in_, c.lead_in);
  if (c.own && c.own->high > 0) unit_.put_long(speed_, c.own->high);
  return true;
}

bool Contour::take_staircase(const sequence::Sequence& s) {
  const auto& stairs = std::get<sequence::SpeedStairs>(s.steps.front().body);
  const auto axis = std::find(axis_names_.begin(), axis_names_.end(), s.axes[0].name);
  if (axis == axis_names_.end()) return false;
  stair_axis_ = static_cast<int>(axis - axis_names_.begin());
  stairs_.clear();
  for (const auto& stair : stairs.stairs) {
    Stair& made = stairs_.emplace_back();
    stairs_unit_.put(made.until, stair.until), stairs_unit_.put_long(made.speed, stair.speed);
  }
  stairs_unit_.put(stop_at_, stairs.stop_at);
  return true;
}

}  // namespace hw::panels
