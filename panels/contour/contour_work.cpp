// Turns the fields of the contour panel into a sequence, a text of the controller, and a drawing.
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "core/sequence/places_before.h"
#include "core/sequence/speed_stairs.h"
#include "gui/model/tab.h"
#include "panels/contour/contour.h"

namespace hw::panels {

using namespace gui;
namespace {

tl::unexpected<Fault> no_number(std::string what) {
  return fail(FaultKind::text, what + " is not a number.", "Nothing was sent.");
}

/// Rewords messages about the steps of a sequence for the rows of this list.
std::string in_rows(std::string_view what) {
  constexpr std::string_view of_step = "Step 1.", of_all = "Step 1 (";
  if (what.starts_with(of_step)) return fmt::format("Piece {}", what.substr(of_step.size()));
  const std::size_t kind = what.starts_with(of_all) ? what.find("): ") : what.npos;
  std::string rest(kind == what.npos ? what : what.substr(kind + 3));
  if (!rest.empty()) rest[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(rest[0])));
  return rest;
}

}  // namespace

Result<sequence::Sequence> Contour::contour() const {
  const auto speed = contour_.unit.steps_long(contour_.speed),
             lead = contour_.unit.steps_long(contour_.lead_in);
  const auto x = contour_.unit.steps(contour_.x), y = contour_.unit.steps(contour_.y);
  if (!speed || *speed < 1) return no_number("The speed");
  if (!x || !y) return no_number("The begin");
  if (!lead || *lead < 0) return no_number("The lead-in");
  if (contour_.first == contour_.second)
    return fail(FaultKind::text, "Choose two different axes for the contour.", "Nothing was sent.");
  sequence::Contour c;
  c.x = *x, c.y = *y;
  c.lead_in = *lead, c.ends_ramped = contour_.ramp;
  c.own = sequence::Speeds{*speed};
  for (std::size_t i = 0; i < contour_.pieces.size(); ++i) {
    const Piece& p = contour_.pieces[i];
    if (p.kind == PieceKind::output) {
      if (names_.output_numbers.empty()) return no_number("An output");
      c.steps.push_back({sequence::Output{names_.output_numbers[static_cast<std::size_t>(p.output)], p.on}});
      continue;
    }
    const auto px = contour_.unit.steps(p.x), py = contour_.unit.steps(p.y);
    if (!px || !py) return no_number(fmt::format("A position of piece {}", i + 1));
    if (p.kind == PieceKind::arc) {
      const auto degrees = p.degrees.value();
      if (!degrees) return no_number(fmt::format("The angle of piece {}", i + 1));
      c.steps.push_back({sequence::Arc{*px, *py, *degrees, {}}});
    } else {
      sequence::Move line;
      line.to[0] = *px, line.to[1] = *py;
      c.steps.push_back({line});
    }
  }
  sequence::Sequence s;
  for (const int axis : {contour_.first, contour_.second})
    s.axes.push_back({std::string(names_.axes[static_cast<std::size_t>(axis)])});
  s.steps = {{std::move(c)}};
  return s;
}

Result<sequence::Sequence> Contour::staircase() const {
  sequence::SpeedStairs stairs;
  const auto stop = stairs_.unit.steps(stairs_.stop_at);
  if (!stop) return no_number("The stop position");
  stairs.stop_at = *stop;
  for (std::size_t i = 0; i < stairs_.rows.size(); ++i) {
    const auto until = stairs_.unit.steps(stairs_.rows[i].until);
    const auto speed = stairs_.unit.steps_long(stairs_.rows[i].speed);
    if (!until || !speed) return no_number(fmt::format("A number of stair {}", i + 1));
    stairs.stairs.push_back({*until, *speed});
  }
  sequence::Sequence s;
  s.axes = {{std::string(names_.axes[static_cast<std::size_t>(stairs_.axis)])}};
  s.steps = {{std::move(stairs)}};
  return s;
}

/// Works only after a change, so that a panel at rest computes and allocates nothing.
void Contour::work_out(Frame& f) {
  const Steps stands = f.now.axes[static_cast<std::size_t>(stairs_.axis)].commanded();
  if (stairs_shown_ && stands != worked_.from && !f.now.any_axis_moving()) changed_ = true;
  const auto shown = [&](int axis) {
    return from_steps(Steps(1), f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(axis)}));
  };
  const drawing::Point scale{shown(contour_.first), shown(contour_.second)};
  if (std::exchange(scale_, scale) != scale) changed_ = true;
  if (!std::exchange(changed_, false)) return;
  worked_.from = stands;
  worked_.problem.clear(), worked_.text.clear(), worked_.facts.clear(), worked_.stair_x.clear(),
      worked_.stair_y.clear(), worked_.places.clear();
  worked_.path = nullptr;
  if (!language_)
    return worked_.problem.assign("The language of this controller cannot write contours."), void();
  const auto plan = stairs_shown_ ? staircase() : contour();
  const auto written = plan.and_then([&](const sequence::Sequence& of) {
    return draw_step(of.steps.front()).and_then([&] { return write(of, f.catalog); });
  });
  if (!written) return worked_.problem.assign(in_rows(written.error().what)), void();
  add_places(*plan, f.catalog);
  worked_.text = written->text;
  const ProgramReport report = language_->analyse(worked_.text, 0);
  for (const Problem& p : report.problems)
    if (p.error) return worked_.problem.assign(fmt::format("Line {}: {}", p.line + 1, p.sentence)), void();
}

/// Words of a refusal use the unit that the user typed.
Result<SequenceText> Contour::write(const sequence::Sequence& plan, const Catalog& catalog) const {
  auto written = language_->write(plan, catalog);
  const double per_step = (stairs_shown_ ? stairs_.unit : contour_.unit).per_step;
  if (written || per_step == 0 || per_step == 1) return written;
  const auto shown = shown_list();
  auto refused = shown ? language_->write(*shown, catalog) : std::move(written);
  return refused ? std::move(written) : std::move(refused);
}

Result<> Contour::draw_step(const sequence::Step& step) {
  if (const auto* stairs = std::get_if<sequence::SpeedStairs>(&step.body)) {
    const auto from = static_cast<double>(worked_.from.value);
    draw_staircase_line(*stairs, from);
    sequence::SpeedStairs shown = *stairs;
    for (sequence::SpeedStairs::Stair& stair : shown.stairs) stair.until = stairs_.unit.typed(stair.until);
    shown.stop_at = stairs_.unit.typed(shown.stop_at);
    const std::string why = why_no_way(shown, stairs_.unit.typed(from));
    return why.empty() ? Result<>() : fail(FaultKind::text, "Step 1 (speed_stairs): " + why);
  }
  const auto& drawn = std::get<sequence::Contour>(step.body);
  const drawing::ToolPath in_steps = drawing::contour_path(drawn, {1, 1});
  if (in_steps.runs.empty()) return {};
  double length = in_steps.way_on + in_steps.way_off;
  if (in_steps.runs.front().source < 0) length -= drawn.lead_in;
  worked_.facts = fmt::format("{:.{}f} {} long, {:.1f} s at this speed", contour_.unit.shown_length(length),
                              contour_.unit.decimals, contour_.unit.name, length / drawn.own->high);
  worked_.path = std::make_shared<const drawing::ToolPath>(drawing::contour_path(drawn, scale_));
  return {};
}

/// Adds the range that the plan reaches in each of its axes.
void Contour::add_places(const sequence::Sequence& plan, const Catalog& catalog) {
  const sequence::Reach reach = reaches_between(plan, {0, 1}).front();
  for (std::size_t a = 0; a < plan.axes.size(); ++a)
    for (const auto& place : {reach.least[a], reach.greatest[a]})
      if (place)
        worked_.places.push_back({AxisId{static_cast<std::uint8_t>(catalog.find_axis(plan.axes[a].name))},
                                  Steps(std::llround(*place))});
}

/// Draws speeds over positions, as a staircase.
void Contour::draw_staircase_line(const sequence::SpeedStairs& stairs, double from) {
  const auto put = [&](double x, double y) {
    worked_.stair_x.push_back(static_cast<float>(stairs_.unit.shown(x)));
    worked_.stair_y.push_back(static_cast<float>(stairs_.unit.shown_length(y)));
  };
  double at = from;
  put(at, 0);
  for (const auto& [until, speed] : stairs.stairs) put(at, speed), put(at = until, speed);
  if (!stairs.stairs.empty()) put(stairs.stop_at, stairs.stairs.back().speed);
  put(stairs.stop_at, 0);
  if (worked_.stair_x.back() < worked_.stair_x.front()) {
    std::reverse(worked_.stair_x.begin(), worked_.stair_x.end());
    std::reverse(worked_.stair_y.begin(), worked_.stair_y.end());
  }
}

}  // namespace hw::panels
