#include "core/devices/vme58/setup.h"

#include <fmt/core.h>

#include "core/device/param_check.h"

namespace hw::vme58 {
namespace {

std::string written(const ParamInfo& info, std::int64_t value) { return encode_number(value, info.decimals); }

}  // namespace

Task<Result<>> Setup::set(intent::SetParam request) {
  ParamRules rules{"This board", written};
  rules.may_now = [this](const ParamInfo&) { return commands_.may_talk(); };
  const auto place = check_param(catalog_, request, rules);
  if (!place) co_return fail(place.error());
  const Parameter& parameter = values_.at(*place);
  auto may = co_await drive_.may_drive(parameter, request.value, request.closing);
  if (!may) co_return may;
  const std::string words = set_text(*parameter.fact, request.value);
  std::string text = parameter.axis >= 0 ? selection_.addressed(parameter.axis, words) : words + "\n";
  values_.note_fraction(*parameter.fact, request.value);
  auto sent = co_await commands_.transmit(std::move(text), Priority::intent);
  if (!sent && wire_.perhaps_done(sent.error())) snapshot_.params[*place].known = false;
  if (!sent) co_return sent;
  values_.know(*place, request.value);
  const bool goes_there = request.closing == intent::Closing::drive && parameter.fact->drives;
  if (goes_there && snapshot_.axes[parameter.axis].far_off) motions_.begins_to_settle(parameter.axis);
  if (!parameter.fact->shown) co_return Result<>();
  co_return co_await check_shown_value(*place, request.value);
}

/// AC, VL and VB wait in the axis' queue: the board may show the new value later.
Task<Result<>> Setup::check_shown_value(std::size_t place, std::int64_t wanted) {
  const Parameter& parameter = values_.at(place);
  OwnSetting* const own = speeds_.shown_at(parameter.fact->shown);
  if (own) own->was_set(parameter.axis, wanted);
  readings_.next_is(parameter.axis);
  auto read = co_await readings_.read_axes(Priority::intent);
  if (!read) co_return read;
  const ParamState& state = snapshot_.params[place];
  const ParamInfo& info = catalog_.params[place];
  if (own) own->was_put(parameter.axis, wanted, state.value != wanted);
  if (state.value == wanted) co_return Result<>();
  if (motions_.moving(parameter.axis)) {
    wire_.report(Notice::Kind::info,
                 fmt::format("{} takes effect when the queue before it is empty.", info.mnemonic));
    co_return Result<>();
  }
  co_return fail(FaultKind::controller,
                 fmt::format("{} was set to {}, but the board reports {}.", info.mnemonic,
                             encode_number(wanted, info.decimals), encode_number(state.value, info.decimals)),
                 "It was sent once.", "The queue of its axis may be waiting.");
}

}  // namespace hw::vme58
