// Set-up. The board shows speeds and gains in its data area; what it shows nowhere is known while the console
// has set it itself since the board's start, and unknown otherwise.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

std::int64_t unit_of(int decimals) {
  std::int64_t unit = 1;
  for (int i = 0; i < decimals; ++i) unit *= 10;
  return unit;
}

std::int64_t in_units(double number, const ParameterFact& fact) {
  return std::llround(number * static_cast<double>(unit_of(fact.decimals)));
}

std::string range_words(const ParamInfo& p) {
  if (!p.choices.empty()) {
    std::string all;
    for (const ParamChoice& c : p.choices) all += fmt::format("{}{}", all.empty() ? "" : ", ", c.value);
    return "one of " + all;
  }
  return fmt::format("{} to {}", encode_number(p.minimum, p.decimals), encode_number(p.maximum, p.decimals));
}

}  // namespace

Task<Result<>> Vme58Driver::perform(const IntentBody& body) {
  using namespace intent;
  if (!wire_.is_open()) co_return no_connection();
  if (const auto* i = std::get_if<MoveTo>(&body)) co_return co_await move(i->targets, i->speed, false);
  if (const auto* i = std::get_if<MoveBy>(&body)) co_return co_await move(i->distances, i->speed, true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await set_position(*i);
  if (std::holds_alternative<SetEncoder>(body))
    co_return fail(FaultKind::refused, "A VME58 has no command for the encoder counter alone.",
                   "Nothing was sent.", "Set the position: LP loads both counters.");
  if (const auto* i = std::get_if<SetPower>(&body)) co_return co_await set_power(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await set_output(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) co_return co_await set_param(*i);
  if (const auto* i = std::get_if<Act>(&body)) co_return co_await act(*i);
  if (const auto* i = std::get_if<SendText>(&body)) co_return co_await send_text(i->text);
  if (const auto* i = std::get_if<Watch>(&body)) {
    watched_ = i->groups;
    co_return Result<>();
  }
  if (const auto* i = std::get_if<Sample>(&body)) {
    const bool on = i->length.count() > 0 && i->axis.index < axis_count();
    sampled_axis_ = on ? i->axis.index : -1;
    sample_until_ = now() + i->length;
    servo_watch_.start();
    co_return Result<>();
  }
  if (std::holds_alternative<ReadParams>(body)) co_return co_await readings_.read_all(Priority::intent);
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_state();
  if (std::holds_alternative<Store>(body))
    co_return fail(FaultKind::refused,
                   "A VME58 has no memory that stays: it starts from factory values each time.",
                   "Nothing was sent.", "Save the set-up to a file; restoring the file sets it again.");
  if (std::holds_alternative<Reset>(body)) co_return co_await reset();
  co_return co_await perform_program(body);
}

Task<Result<>> Vme58Driver::set_param(intent::SetParam wish) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  const int index = catalog_.find_param(wish.mnemonic);
  if (index < 0)
    co_return fail(FaultKind::refused, fmt::format("This board has no parameter {}.", wish.mnemonic),
                   "Nothing was sent.");
  const ParamInfo& info = catalog_.params[ix(index)];
  if (!info.accepts(wish.value))
    co_return fail(
        FaultKind::refused,
        fmt::format("{} is not possible for {} ({}): it takes {}.", encode_number(wish.value, info.decimals),
                    info.mnemonic, info.label, range_words(info)),
        "Nothing was sent.");
  if (!info.warning.empty() && !wish.confirmed && wish.value != info.fallback)
    co_return fail(FaultKind::refused, info.warning, "Nothing was sent.", "Confirm it to go on.");
  const Parameter& parameter = parameters_[ix(index)];
  auto may = co_await may_drive(parameter, wish.value, wish.closing);
  if (!may) co_return may;
  const std::string set = set_text(*parameter.fact, wish.value);
  const std::string text = parameter.axis >= 0 ? addressed(parameter.axis, set) : set + "\n";
  note_fraction(*parameter.fact, wish.value);
  auto sent = co_await commands_.say(text, Priority::intent);
  ParamState& state = draft_.params[ix(index)];
  if (!sent && wire_.perhaps_done(sent.error())) state.known = false;
  if (!sent) co_return sent;
  know_param(ix(index), wish.value);
  const bool goes_there = wish.closing == intent::Closing::drive && parameter.fact->drives;
  if (goes_there && draft_.axes[parameter.axis].far_off) begins_to_settle(parameter.axis);
  if (!parameter.fact->shown) co_return Result<>();
  auto& borrowed = minds_[ix(parameter.axis)].velocity;
  if (borrowed && parameter.fact->shown == AxisValue::maximum_velocity) borrowed->before = wish.value;
  // AC, VL and VB wait in the axis' queue: what the board shows may come later.
  readings_.next_is(parameter.axis);
  auto read = co_await readings_.read_axes(Priority::intent);
  if (!read) co_return read;
  auto& put = minds_[ix(parameter.axis)].put_velocity;
  if (parameter.fact->shown == AxisValue::maximum_velocity && (put || state.value != wish.value))
    put = PutVelocity{wish.value};
  if (state.value == wish.value) co_return Result<>();
  if (moving(parameter.axis)) {
    tell(Notice::Kind::info,
         fmt::format("{} takes effect when what is in the queue before it has ended.", info.mnemonic));
    co_return Result<>();
  }
  co_return fail(
      FaultKind::controller,
      fmt::format("{} was set to {}, but the board shows {}.", info.mnemonic,
                  encode_number(wish.value, info.decimals), encode_number(state.value, info.decimals)),
      "It was sent once.", "Its queue may be waiting for something.");
}

void Vme58Driver::know_param(std::size_t place, std::int64_t value) {
  draft_.params[place].value = value;
  draft_.params[place].known = true;
  note_fraction(*parameters_[place].fact, value);
}

/// From here on the data area does not tell all of the gains.
void Vme58Driver::note_fraction(const ParameterFact& fact, std::int64_t value) {
  if (!fact.shown || value % unit_of(fact.decimals) == 0) return;
  mark_due_ = mark_due_ || gains_are_whole_;
  gains_are_whole_ = false;
}

/// From the data area, which has integer parts only: a fraction that the console has set stays beside it, and
/// one that another session has set, or may have, nobody can tell.
void Vme58Driver::take_parameters(int axis) {
  auto& put = minds_[ix(axis)].put_velocity;
  if (put && put->carried_out) put.reset();
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const Parameter& parameter = parameters_[i];
    if (parameter.axis != axis || !parameter.fact->shown) continue;
    const std::int64_t unit = unit_of(parameter.fact->decimals);
    const std::int64_t shown = value(axis, *parameter.fact->shown);
    ParamState& state = draft_.params[i];
    if (state.known && state.value / unit == shown) continue;
    state.value = shown * unit;
    state.known = unit == 1 || gains_are_whole_;
  }
}

void Vme58Driver::factory_params() {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    draft_.params[i].value = catalog_.params[i].fallback;
    draft_.params[i].known = true;
  }
  for (std::size_t place = 0; place < catalog_.outputs.size(); ++place)
    if (catalog_.outputs[place].number >= first_auxiliary) {
      draft_.outputs |= 1u << place;  // decision M37: high, the transistor is off
      draft_.outputs_known |= 1u << place;
    }
}

/// What the user's own text has set.
void Vme58Driver::note_param(const TextCommand& sent) {
  for (std::size_t i = 0; i < parameters_.size(); ++i) {
    const ParameterFact& fact = *parameters_[i].fact;
    if (parameters_[i].axis >= 0 &&
        (sent.context.mode != where::single || parameters_[i].axis != sent.context.axis))
      continue;
    ParamState& state = draft_.params[i];
    const std::string_view letters = sent.fact->letters;
    if (!fact.on.empty() && fact.letters != "PA" && (letters == fact.on || letters == fact.off)) {
      state.value = letters == fact.on;
      state.known = true;
    } else if (fact.whole_board && fact.letters == "PN" && (letters == "PF" || letters == "CN")) {
      state.value = letters == "CN" ? ramp_cosine : ramp_linear;
      state.known = true;
    } else if (letters == fact.letters && !sent.numbers.empty() && sent.numbers.front() &&
               (!fact.shown || fact.decimals > 0)) {  // of a gain the data area has the whole part only
      know_param(i, in_units(*sent.numbers.front(), fact));
    }
  }
}

}  // namespace hw::vme58
