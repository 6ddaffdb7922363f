#include "core/device/sequence_draft.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/rounded_steps.h"
#include "core/device/tool_off.h"
#include "core/device/written_speeds.h"
#include "core/sequence/fields.h"
#include "core/sequence/speed_stairs.h"

namespace hw {

namespace seq = sequence;  // files of this folder are compiled together
namespace {

template <class Body>
bool has_speeds(const Body& body) {
  if constexpr (requires { body.own; }) return body.own.has_value();
  return std::is_same_v<Body, seq::Speed> || std::is_same_v<Body, seq::SpeedStairs>;
}

}  // namespace

std::string_view kind_of(const seq::Step& step) { return seq::kind_names[step.body.index()]; }

bool sets_speeds(const seq::StepList& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const seq::Step& step) {
    const seq::StepList* inner = steps_in(step);
    return !step.skipped && (std::visit([](const auto& body) { return has_speeds(body); }, step.body) ||
                             (inner && sets_speeds(*inner)));
  });
}

Result<> SequenceDraft::find_axes() {
  for (std::size_t i = 0; i < sequence.axes.size(); ++i) {
    const int found = catalog.find_axis(sequence.axes[i].name);
    if (found < 0)
      return fail(FaultKind::text,
                  fmt::format("A {} has no axis \"{}\".", catalog.short_name, sequence.axes[i].name),
                  "Nothing was written.", "Choose one of its axes for it.");
    axes_[i] = AxisId{static_cast<std::uint8_t>(found)};
  }
  return {};
}

// ---- the step at hand

void SequenceDraft::enter(const seq::Step& step, std::size_t place) {
  path_.push_back({&step, place, routine_.empty() ? next_index_++ : -1});
}

void SequenceDraft::leave() {
  const Entered left = path_.back();
  path_.pop_back();
  const seq::StepList* inner = steps_in(*left.step);
  if (routine_.empty()) next_index_ = left.index + 1 + (inner ? seq::count_steps(*inner) : 0);
}

Result<> SequenceDraft::begin_routine(std::string_view name) {
  if (in_routine()) return refuse_tool();
  path_outside_ = std::exchange(path_, {});
  routine_ = name;
  return {};
}

void SequenceDraft::end_routine() {
  path_ = std::exchange(path_outside_, {});
  routine_ = {};
}

int SequenceDraft::index() const {
  const std::vector<Entered>& path = routine_.empty() ? path_ : path_outside_;
  return path.empty() ? -1 : path.back().index;
}

std::string SequenceDraft::numbers() const {
  std::string all;
  for (const Entered& e : path_) all += fmt::format("{}{}", all.empty() ? "" : ".", e.place + 1);
  return all;
}

tl::unexpected<Fault> SequenceDraft::refuse(std::string_view why) const {
  return fail(FaultKind::text,
              fmt::format("{}{} {} ({}): {}", routine_, routine_.empty() ? "Step" : ", step", numbers(),
                          kind_of(*path_.back().step), why),
              "Nothing was written.");
}

tl::unexpected<Fault> SequenceDraft::refuse_field(std::string field, std::string_view why,
                                                  std::optional<double> nearest) const {
  auto refusal = refuse(why);
  latest_ = {index(), std::move(field), refusal.value().what, std::string(why), nearest};
  return refusal;
}

tl::unexpected<Fault> SequenceDraft::refuse_single_axis(std::string_view what) const {
  return refuse(fmt::format("{} needs two axes.", what));
}

tl::unexpected<Fault> SequenceDraft::refuse_unknown_start() const {
  return refuse("put an absolute move of both axes before it: its start is not known.");
}

tl::unexpected<Fault> SequenceDraft::refuse_outputs(std::size_t count, std::uint32_t value,
                                                    std::string_view kind) const {
  return refuse(
      fmt::format("the controller has {} {}; the value {} is too large for them.", count, kind, value));
}

tl::unexpected<Fault> SequenceDraft::refuse_own_speed() const {
  return refuse(fmt::format("{} Put a speed step before it.", no_own_speed));
}

std::optional<std::vector<std::size_t>> refused_step(std::string_view what) {
  constexpr std::string_view step = "Step ";
  if (!what.starts_with(step)) return std::nullopt;
  what.remove_prefix(step.size());
  std::vector<std::size_t> path;
  for (;;) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(what.data(), what.data() + what.size(), number);
    if (error != std::errc() || number == 0) return std::nullopt;
    path.push_back(number - 1);
    what.remove_prefix(static_cast<std::size_t>(end - what.data()));
    if (!what.starts_with('.')) return path;
    what.remove_prefix(1);
  }
}

bool SequenceDraft::pass_over(const seq::Step& step, const Fault& fault, const Before& before) {
  if (!refused_) return false;
  // Details are known for a refused field of this step; for another refusal, or one in a tool routine, only
  // the sentence is known.
  RefusedStep refused = latest_.what == fault.what && routine_.empty() ? latest_ : RefusedStep();
  if (refused.what.empty()) {
    const std::size_t why = fault.what.find("): ");
    refused.what = fault.what;
    refused.why = routine_.empty() && why != fault.what.npos ? fault.what.substr(why + 3) : fault.what;
  }
  if (!steps_in(step)) path_.resize(before.depth + 1);  // its replacement is no step of the list
  refused.step = index();
  path_.resize(before.depth + 1);
  lines_.resize(before.lines);
  indent_ = before.indent, part_ = before.part, at_ = before.at;
  if (routine_.empty()) line(fmt::format("{}block {} is not written", comment_mark_, numbers()));
  if (const auto* move = std::get_if<seq::Move>(&step.body))
    as_if_moved(*move);
  else if (!std::holds_alternative<seq::Arc>(step.body))
    forget_moved_axes({step});
  const auto same = [&](const RefusedStep& r) { return r.step == refused.step && r.what == refused.what; };
  if (routine_.empty() || std::none_of(refused_->begin(), refused_->end(), same))
    refused_->push_back(std::move(refused));
  return true;
}

/// Otherwise an arc after a refused move would be refused too.
void SequenceDraft::as_if_moved(const seq::Move& move) {
  for (int a = 0; a < axis_count(); ++a) {
    if (!move.to[ix(a)]) continue;
    const std::int64_t steps = rounded_steps(*move.to[ix(a)] * sequence.axes[ix(a)].per_unit).value;
    const auto at = this->at(a);
    if (!move.relative)
      stands(a, steps);
    else if (at)
      stands(a, *at + steps);
  }
}

void SequenceDraft::remark(std::string_view what) {
  std::string sentence = refuse(what).value().what;
  if (std::find(remarks_.begin(), remarks_.end(), sentence) == remarks_.end())
    remarks_.push_back(std::move(sentence));
}

// ---- the text

void SequenceDraft::line(std::string_view text) {
  lines_.push_back({part_, index(), std::string(static_cast<std::size_t>(indent_), ' ').append(text)});
}

void SequenceDraft::lines(std::string_view text, std::string_view mark) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    line(std::string(mark).append(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

Result<> SequenceDraft::tool_line(std::string_view mark, std::string_view aside) {
  if (!uses_tool(sequence)) return {};
  const ToolOff tool = tool_off_of(sequence, static_cast<int>(catalog.outputs.size()));
  for (const ToolOutput& o : tool)
    if (o.on && catalog.can.stop_clears_outputs)
      return fail(FaultKind::text,
                  fmt::format("The tool is off while output {} is on: a {} switches its outputs off when it "
                              "is stopped, which switches the tool on.",
                              o.number, catalog.short_name),
                  "Nothing was written.", "Wire the tool so that it is off while the output is off.");
  if (!tool.empty()) {
    line(std::string(mark) + tool_off_line(tool));
    tool_ = fmt::format(
        "Each stop, hold, limit and end switches the tool ({}) off. While the link is lost the console "
        "cannot switch it off; it does so when the link is back.",
        tool_outputs_words(tool));
    if (!aside.empty()) tool_ += fmt::format(" {}", aside);
  } else {
    tool_ = "No output switches the tool: a stop leaves it as it is.";
  }
  return {};
}

SequenceText SequenceDraft::finish() && {
  std::stable_sort(lines_.begin(), lines_.end(),
                   [](const Line& a, const Line& b) { return a.part < b.part; });
  SequenceText all;
  all.remarks = std::move(remarks_);
  all.tool = std::move(tool_);
  for (const Line& l : lines_) {
    all.text.append(l.text).append("\n");
    all.step_of_line.push_back(l.index);
  }
  return all;
}

// ---- axes

Result<std::int64_t> SequenceDraft::steps_of(int place, double units, double low, double high) const {
  const double per_unit = sequence.axes[ix(place)].per_unit, steps = std::round(units * per_unit);
  if (!(steps >= low && steps <= high)) {
    const double nearest = steps > high ? high : low;
    return refuse_field(
        place_field(place),
        fmt::format("{} {} of {} is too far: the range of a {} is {:.10g} to {:.10g}.", units, sequence.unit,
                    name(place), catalog.short_name, std::min(low / per_unit, high / per_unit),
                    std::max(low / per_unit, high / per_unit)),
        std::isnan(steps) ? std::nullopt : std::optional(nearest / per_unit));
  }
  return static_cast<std::int64_t>(steps);
}

std::string SequenceDraft::place_field(int place) const {
  const seq::Step::Body& body = path_.back().step->body;
  if (std::holds_alternative<seq::Move>(body)) return "to/" + sequence.axes[ix(place)].name;
  if (std::holds_alternative<seq::MoveOnInput>(body)) return "to";
  const seq::Plane* plane = seq::plane_of(body);
  return place == (plane ? plane->right : 0) ? "x" : "y";
}

Result<std::int64_t> SequenceDraft::position(int place, double units) const {
  return steps_of(place, units, static_cast<double>(catalog.position_min.value),
                  static_cast<double>(catalog.position_max.value));
}

Result<std::int64_t> SequenceDraft::distance(int place, double units) const {
  const auto most = static_cast<double>(catalog.move_max.value);
  return steps_of(place, units, -most, most);
}

Result<StepSpeeds> SequenceDraft::speeds(int place, const seq::Speeds& units) const {
  const double per_unit = std::abs(sequence.axes[ix(place)].per_unit);
  StepSpeeds s;
  for (auto [key, from, to, word] :
       {std::tuple{"high", units.high, &s.high, "speed"}, {"low", units.low, &s.low, "low speed"}}) {
    if (from == 0) continue;
    const double pps = std::round(from * per_unit), most = catalog.jog_speed_max.value;
    if (!(pps >= 1 && pps <= most))
      return refuse_field(
          key,
          fmt::format("a {} of {} {}/s on {} is not possible: the range of a {} is {:.6g} to {:.10g}.", word,
                      from, sequence.unit, name(place), catalog.short_name, 1 / per_unit, most / per_unit),
          (pps > most ? most : 1) / per_unit);
    *to = static_cast<std::int64_t>(pps);
  }
  if (s.high != 0 && s.low > s.high)
    return refuse_field("low", "the low speed is above the high speed.", units.high);
  s.ramp_ms = units.ramp_ms;
  return s;
}

Result<StepSpeeds> SequenceDraft::speeds_of(int place, const seq::OwnSpeeds& own) const {
  return speeds(place, own ? over(speeds_now_, *own) : speeds_now_);
}

seq::Speeds SequenceDraft::over(seq::Speeds below, const seq::Speeds& above) {
  if (above.high != 0) below.high = above.high;
  if (above.low != 0) below.low = above.low;
  if (above.ramp_ms != 0) below.ramp_ms = above.ramp_ms;
  return below;
}

Result<StepStairs> SequenceDraft::stairs(const seq::SpeedStairs& s) const {
  const auto from = at(s.axis);
  const double per_unit = sequence.axes[ix(s.axis)].per_unit;
  const std::string why =
      seq::why_no_way(s, from ? std::optional(static_cast<double>(*from) / per_unit) : std::nullopt);
  if (!why.empty()) return refuse_field("stairs", why);
  StepStairs made{seq::direction_of(s)};
  for (std::size_t i = 0; i < s.stairs.size(); ++i) {
    const auto until = position(s.axis, s.stairs[i].until);
    const auto speed = speeds(s.axis, {s.stairs[i].speed});
    if (!until || !speed) return fail(!until ? until.error() : speed.error());
    if (speed->high == 0) return refuse_field("stairs", fmt::format("stair {} needs a speed.", i + 1));
    made.stairs.push_back({*until, speed->high});
  }
  const auto stop_at = position(s.axis, s.stop_at);
  if (!stop_at) return fail(stop_at.error());
  made.stop_at = *stop_at;
  return made;
}

bool SequenceDraft::all_alike() const {
  return std::all_of(sequence.axes.begin(), sequence.axes.end(),
                     [this](const seq::Axis& a) { return a.per_unit == sequence.axes[0].per_unit; });
}

void SequenceDraft::forget_moved_axes(const seq::StepList& steps) {
  for (const seq::Step& step : steps) {
    if (step.skipped) continue;
    if (const seq::StepList* inner = steps_in(step)) forget_moved_axes(*inner);
    if (const auto* move = std::get_if<seq::Move>(&step.body)) {
      for (int a = 0; a < axis_count(); ++a)
        if (move->to[ix(a)]) stands(a, std::nullopt);
    } else if (const auto* some = std::get_if<seq::MoveOnInput>(&step.body)) {
      stands(some->axis, std::nullopt);
    } else if (const auto* jog = std::get_if<seq::Jog>(&step.body)) {
      stands(jog->axis, std::nullopt);
    } else if (const auto* stairs = std::get_if<seq::SpeedStairs>(&step.body)) {
      stands(stairs->axis, std::nullopt);
    } else if (const auto* home = std::get_if<seq::Home>(&step.body)) {
      stands(home->axis, std::nullopt);
    } else if (const seq::Plane* plane = seq::plane_of(step.body)) {
      stands(plane->right, std::nullopt), stands(plane->up, std::nullopt);
    } else if (std::holds_alternative<seq::Custom>(step.body)) {
      nothing_known();
    }
  }
}

// ---- inputs and outputs

Result<int> SequenceDraft::input(int number) const {
  const int place = catalog.find_input(number);
  if (place < 0)
    return refuse_field("input", fmt::format("a {} has no input {}.", catalog.short_name, number));
  return place;
}

Result<int> SequenceDraft::output(int number) const {
  const int place = catalog.find_output(number);
  if (place < 0)
    return refuse_field("output", fmt::format("a {} has no output {}.", catalog.short_name, number));
  return place;
}

}  // namespace hw
