#include "core/devices/vme58/setup.h"

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vme58 {
namespace {

std::string range_words(const ParamInfo& p) {
  if (!p.choices.empty()) {
    std::string all;
    for (const ParamChoice& c : p.choices) all += fmt::format("{}{}", all.empty() ? "" : ", ", c.value);
    return "one of " + all;
  }
  return fmt::format("{} to {}", encode_number(p.minimum, p.decimals), encode_number(p.maximum, p.decimals));
}

}  // namespace

/// Its place in the catalog.
Result<int> Setup::checked(const intent::SetParam& wish) const {
  const int place = catalog_.find_param(wish.mnemonic);
  if (place < 0)
    return fail(FaultKind::refused, fmt::format("This board has no parameter {}.", wish.mnemonic),
                "Nothing was sent.");
  const ParamInfo& info = catalog_.params[ix(place)];
  if (!info.accepts(wish.value))
    return fail(
        FaultKind::refused,
        fmt::format("{} is not possible for {} ({}): it takes {}.", encode_number(wish.value, info.decimals),
                    info.mnemonic, info.label, range_words(info)),
        "Nothing was sent.");
  if (!info.warning.empty() && !wish.confirmed && wish.value != info.fallback)
    return fail(FaultKind::refused, info.warning, "Nothing was sent.", "Confirm it to go on.");
  return place;
}

Task<Result<>> Setup::set(intent::SetParam wish) {
  if (auto may = commands_.may_talk(); !may) co_return may;
  const auto place = checked(wish);
  if (!place) co_return fail(place.error());
  const Parameter& parameter = values_.at(ix(*place));
  auto may = co_await drive_.may_drive(parameter, wish.value, wish.closing);
  if (!may) co_return may;
  const std::string words = set_text(*parameter.fact, wish.value);
  std::string text = parameter.axis >= 0 ? selection_.addressed(parameter.axis, words) : words + "\n";
  values_.note_fraction(*parameter.fact, wish.value);
  auto sent = co_await commands_.say(std::move(text), Priority::intent);
  if (!sent && wire_.perhaps_done(sent.error())) draft_.params[ix(*place)].known = false;
  if (!sent) co_return sent;
  values_.know(ix(*place), wish.value);
  const bool goes_there = wish.closing == intent::Closing::drive && parameter.fact->drives;
  if (goes_there && draft_.axes[parameter.axis].far_off) motions_.begins_to_settle(parameter.axis);
  if (!parameter.fact->shown) co_return Result<>();
  co_return co_await look_what_came(*place, wish.value);
}

/// AC, VL and VB wait in the axis' queue: what the board shows may come later.
Task<Result<>> Setup::look_what_came(int place, std::int64_t wanted) {
  const Parameter& parameter = values_.at(ix(place));
  const bool speed = parameter.fact->shown == AxisValue::maximum_velocity;
  if (speed) speeds_.was_set(parameter.axis, wanted);
  readings_.next_is(parameter.axis);
  auto read = co_await readings_.read_axes(Priority::intent);
  if (!read) co_return read;
  const ParamState& state = draft_.params[ix(place)];
  const ParamInfo& info = catalog_.params[ix(place)];
  if (speed) speeds_.was_put(parameter.axis, wanted, state.value != wanted);
  if (state.value == wanted) co_return Result<>();
  if (motions_.moving(parameter.axis)) {
    wire_.tell(Notice::Kind::info,
               fmt::format("{} takes effect when what is in the queue before it has ended.", info.mnemonic));
    co_return Result<>();
  }
  co_return fail(FaultKind::controller,
                 fmt::format("{} was set to {}, but the board shows {}.", info.mnemonic,
                             encode_number(wanted, info.decimals), encode_number(state.value, info.decimals)),
                 "It was sent once.", "Its queue may be waiting for something.");
}

}  // namespace hw::vme58
