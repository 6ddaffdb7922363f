// Set-up: reading, changing, storing.
#include "core/devices/vxm/parameters.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/nothing_known.h"
#include "core/device/param_check.h"
#include "core/devices/vxm/codec.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/reply_kinds.h"

namespace hw::vxm {

namespace {

constexpr Duration rate_change_pause = Millis(50);
constexpr int values_at_once = 4;  // values read between two requests
constexpr int tries_at_one = 3;    // attempts for a value that is not answered

tl::unexpected<Fault> lost_meanwhile() {
  return fail(FaultKind::lost, "The connection was lost while the baud rate changed.");
}

int baud_rate(std::int64_t number) {
  for (const Baud& b : bauds)
    if (b.number == number) return b.rate;
  return 0;
}

// The value that the controller keeps (App. C p.38, F p.45, O p.68).
std::int64_t as_kept(std::string_view mnemonic, std::int64_t value) {
  if (mnemonic == "DM") return value | mode_always;
  if (mnemonic == "Bx" && value == 1) return backlash_of_one;
  if (mnemonic == "I" && value & inputs_capture) value &= ~std::int64_t{inputs_stop};
  if (mnemonic == "I" && value & inputs_select) value &= ~std::int64_t{inputs_branch_3};
  return value;
}

}  // namespace

std::optional<std::int64_t> Parameters::value(std::string_view mnemonic) const {
  const int index = console_.catalog.find_param(mnemonic);
  if (index < 0 || !console_.snapshot.params[ix(index)].known) return std::nullopt;
  return console_.snapshot.params[ix(index)].value;
}

// A set or get for motor 3 or 4 without a Slave would make the controller restart (EB).
bool Parameters::reachable(const ParamInfo& info) const {
  return identification_.has_slave() || (info.axis < motors_per_controller && info.mnemonic != "PMA");
}

Task<Result<>> Parameters::read_one(int index, Priority priority) {
  const ParamInfo& info = console_.catalog.params[ix(index)];
  if (!info.readable || !reachable(info)) co_return Result<>();
  if (info.mnemonic == "PA" && !identification_.reports_pulses()) co_return Result<>();
  auto value = co_await conversation_.number(get_param(info.mnemonic), priority);
  if (!value) co_return fail(value.error());
  console_.snapshot.params[ix(index)].value = *value;
  console_.snapshot.params[ix(index)].known = true;
  co_return Result<>();
}

Task<Result<>> Parameters::read_all() {
  if (auto may = may_change_(); !may) co_return may;
  for (int i = 0; i < static_cast<int>(console_.catalog.params.size()); ++i) {
    auto read = co_await read_one(i, Priority::transfer);
    if (!read) co_return read;
  }
  co_return Result<>();
}

Task<Result<>> Parameters::read_essentials() {
  for (const char* mnemonic : {"DM", "I", "O", "PMA", "M1M", "M2M", "M3M", "M4M"}) {
    const int index = console_.catalog.find_param(mnemonic);
    if (index < 0) continue;
    auto read = co_await read_one(index, Priority::poll);
    if (!read) co_return read;
  }
  essentials_read_ = true;
  co_return Result<>();
}

Task<Result<>> Parameters::read_some() {
  const int count = static_cast<int>(console_.catalog.params.size());
  for (int read = 0; next_ < count && read < values_at_once; ++next_) {
    if (console_.snapshot.params[static_cast<std::size_t>(next_)].known ||
        !console_.catalog.params[static_cast<std::size_t>(next_)].readable)
      continue;
    auto done = co_await read_one(next_, Priority::poll);
    if (!done && ++failed_reads_ < tries_at_one)
      co_return done;  // after the last attempt: the firmware does not know the value
    failed_reads_ = 0;
    ++read;
  }
  co_return Result<>();
}

void Parameters::was_set(std::string_view mnemonic) {
  next_ = 0;
  for (std::size_t i = 0; i < console_.catalog.params.size(); ++i)
    if (console_.catalog.params[i].mnemonic == mnemonic)
      console_.snapshot.params[i].known = console_.snapshot.params[i].stored = false;
  console_.snapshot.unsaved_setup = true;
  if (mnemonic == "DM" || mnemonic == "I" || mnemonic == "D") essentials_read_ = false;
}

void Parameters::forget() {
  essentials_read_ = false;
  next_ = failed_reads_ = 0;
  set_up_is_unknown(console_.snapshot);
}

Result<> Parameters::may_set(const ParamInfo& info) const {
  if (!reachable(info))
    return fail(FaultKind::refused,
                fmt::format("{} needs a second controller, and none answers on the VXM bus.", info.mnemonic),
                "Nothing was sent.", check_slave);
  return may_change_();
}

Task<Result<>> Parameters::set(const intent::SetParam& request) {
  ParamRules rules;
  rules.title = "A VXM";
  rules.may_now = [this](const ParamInfo& info) { return may_set(info); };
  const auto place = check_param(console_.catalog, request, rules);
  if (!place) co_return fail(place.error());
  const int index = static_cast<int>(*place);
  const ParamInfo& info = console_.catalog.params[*place];
  if (info.mnemonic == "B") co_return co_await set_baud(request.value);
  auto sent = co_await conversation_.transmit(vxm::set_param(info.mnemonic, request.value), Priority::intent);
  if (!sent) co_return sent;
  ParamState& state = console_.snapshot.params[ix(index)];
  state.stored = !info.stored;
  console_.snapshot.unsaved_setup = console_.snapshot.unsaved_setup || info.stored;
  if (info.mnemonic.starts_with("MA") && info.axis >= 0) {
    auto read =
        co_await read_one(console_.catalog.find_param(fmt::format("M{}M", info.axis + 1)), Priority::intent);
    co_return read;
  }
  auto read = co_await read_one(index, Priority::intent);
  if (!read) co_return read;
  const auto expected = as_kept(info.mnemonic, request.value);
  if (!info.readable || state.value == expected) co_return Result<>();
  co_return fail(FaultKind::controller,
                 fmt::format("{} was set to {}, but the controller reports {}.", info.mnemonic, request.value,
                             state.value),
                 "It was sent once.",
                 "Read the set-up again: the value that the controller reports is in force.");
}

// The controller changes its rate after the ender; then both sides must agree, or go back. A stop in between
// would be sent at a rate that is not received.
Task<Result<>> Parameters::set_baud(std::int64_t number) {
  const Station::Uncut uncut(*conversation_.station());
  auto sent = co_await conversation_.transmit(vxm::set_param("B", number), Priority::intent);
  if (!sent) co_return sent;
  co_return co_await follow_rate(number);
}

Task<Result<>> Parameters::follow_rate(std::int64_t number) {
  if (!conversation_.station()) co_return lost_meanwhile();
  const int before = conversation_.station()->rate(), wanted = baud_rate(number);
  auto waited =
      co_await conversation_.station()->pause(conversation_.station()->wire_time(10) + rate_change_pause);
  if (!waited || !conversation_.station()) co_return lost_meanwhile();
  auto changed = conversation_.station()->set_rate(wanted);
  if (changed) {
    auto state = co_await conversation_.state(Priority::intent);
    if (state) {
      const int index = console_.catalog.find_param("B");
      console_.snapshot.params[ix(index)] = {number, true, false};
      console_.snapshot.unsaved_setup = true;
      co_return Result<>();
    }
  }
  if (!conversation_.station()) co_return lost_meanwhile();
  if (before > 0) (void)conversation_.station()->set_rate(before);
  auto state = co_await conversation_.state(Priority::intent);
  co_return fail(
      FaultKind::controller,
      fmt::format("The controller was asked to change to {} baud but does not answer there.", wanted),
      state ? fmt::format("It still answers at {} baud, and that is used again.", before)
            : "It does not answer at the old rate either.",
      state ? "" : "Open it again at each rate, or switch it off and on: the stored rate then holds.");
}

void Parameters::found_at(int rate) {
  ParamState& state = console_.snapshot.params[ix(console_.catalog.find_param("B"))];
  if (rate > 0 && baud_rate(state.value) != rate) state.known = false;
}

void Parameters::was_stored() {
  for (ParamState& p : console_.snapshot.params) p.stored = true;
  console_.snapshot.unsaved_setup = console_.snapshot.unsaved_programs = false;
}

Task<Result<>> Parameters::store() {
  if (auto may = may_change_(); !may) co_return may;
  const AnswerShape prompt{ReplyShape::bytes(1), before_prompt, store_patience, reply_kind::prompt};
  auto reply = co_await conversation_.ask("rsm", prompt, Priority::intent);
  if (!reply && reply.error().kind == FaultKind::no_answer)
    co_return fail(
        FaultKind::no_answer,
        fmt::format("The controller did not confirm within {:.0f} s that it has stored the set-up.",
                    seconds(store_patience)),
        "rsm was sent once and is not repeated: the memory is rated for a limited number of writes.",
        "Do not switch the controller off now. Ask for its state, and compare the set-up before you store "
        "again.");
  if (!reply) co_return fail(reply.error());
  was_stored();
  if (console_.snapshot.store_count >= 0) {
    console_.report(Notice::Kind::info,
                    fmt::format("Set-up and programs are stored. {} of about {} writes are used.",
                                console_.snapshot.store_count, store_life));
  } else {
    console_.report(Notice::Kind::info, fmt::format("Set-up and programs are stored. The memory is rated for "
                                                    "about {} writes; the number used so far is unknown.",
                                                    store_life));
  }
  co_return Result<>();
}

}  // namespace hw::vxm
