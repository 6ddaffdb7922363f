// Reads the lists of the contour panel from a file and writes them to one.
#include <algorithm>
#include <cmath>

#include "gui/model/tab.h"
#include "panels/contour/contour.h"

namespace hw::panels {

using namespace gui;

Result<sequence::Sequence> Contour::shown_list() const {
  const ContourUnit& unit = stairs_shown_ ? stairs_.unit : contour_.unit;
  return (stairs_shown_ ? staircase() : contour()).map([&](sequence::Sequence&& s) {
    return in_unit(std::move(s), unit.per_step, unit.name);
  });
}

/// In a file a unit has the direction of the steps.
Result<sequence::Sequence> Contour::list_for_file() const {
  const ContourUnit& unit = stairs_shown_ ? stairs_.unit : contour_.unit;
  return (stairs_shown_ ? staircase() : contour()).map([&](sequence::Sequence&& s) {
    return in_unit(std::move(s), std::abs(unit.per_step), unit.name);
  });
}

/// If the file names an axis or output that this controller lacks, the list stays as it is.
void Contour::opened(Frame& f, const sequence::Sequence& s) {
  const bool stairs = std::holds_alternative<sequence::SpeedStairs>(s.steps.front().body);
  if (!(stairs ? take_staircase(s) : take_contour(s)))
    return f.toast(Severity::fault,
                   "The file names an axis or an output that this controller does not have. The list here is "
                   "unchanged.");
  stairs_shown_ = stairs;
  (stairs ? stairs_.unkept : contour_.unkept) = false;
  changed_ = true;
}

bool Contour::take_contour(const sequence::Sequence& s) {
  const auto& c = std::get<sequence::Contour>(s.steps.front().body);
  const auto place_of = [](const auto& list, const auto& wanted) {
    const auto found = std::find(list.begin(), list.end(), wanted);
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
  };
  const int right = place_of(names_.axes, s.axes[0].name), up = place_of(names_.axes, s.axes[1].name);
  if (right < 0 || up < 0) return false;
  std::vector<Piece> pieces;
  for (const sequence::Step& step : c.steps) {
    Piece& p = pieces.emplace_back();
    if (const auto* output = std::get_if<sequence::Output>(&step.body)) {
      p.kind = PieceKind::output, p.on = output->on;
      p.output = place_of(names_.output_numbers, output->output);
      if (p.output < 0) return false;
    } else if (const auto* arc = std::get_if<sequence::Arc>(&step.body)) {
      p.kind = PieceKind::arc;
      contour_.unit.put(p.x, arc->x), contour_.unit.put(p.y, arc->y), p.degrees.set(arc->degrees, 3);
    } else {
      const auto& line = std::get<sequence::Move>(step.body);
      contour_.unit.put(p.x, line.to[0].value_or(0)), contour_.unit.put(p.y, line.to[1].value_or(0));
    }
  }
  contour_.pieces = std::move(pieces);
  contour_.first = right, contour_.second = up, contour_.ramp = c.ends_ramped;
  contour_.unit.put(contour_.x, c.x), contour_.unit.put(contour_.y, c.y),
      contour_.unit.put_long(contour_.lead_in, c.lead_in);
  if (c.own && c.own->high > 0) contour_.unit.put_long(contour_.speed, c.own->high);
  return true;
}

bool Contour::take_staircase(const sequence::Sequence& s) {
  const auto& stairs = std::get<sequence::SpeedStairs>(s.steps.front().body);
  const auto axis = std::find(names_.axes.begin(), names_.axes.end(), s.axes[0].name);
  if (axis == names_.axes.end()) return false;
  stairs_.axis = static_cast<int>(axis - names_.axes.begin());
  stairs_.rows.clear();
  for (const auto& stair : stairs.stairs) {
    Stair& made = stairs_.rows.emplace_back();
    stairs_.unit.put(made.until, stair.until), stairs_.unit.put_long(made.speed, stair.speed);
  }
  stairs_.unit.put(stairs_.stop_at, stairs.stop_at);
  return true;
}

}  // namespace hw::panels
