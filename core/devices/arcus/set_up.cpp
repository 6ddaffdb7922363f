#include "core/devices/arcus/set_up.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/device/nothing_known.h"
#include "core/device/param_check.h"

namespace hw::arcus {
namespace {

constexpr int params_per_round = 3;
constexpr Duration store_patience = std::chrono::seconds(3);

}  // namespace

SetUp::SetUp(const Console& console, Conversation& conversation, const CodeAtWork& code,
             const BorrowedSetting& borrowed, Callbacks callbacks)
    : console_(console),
      conversation_(conversation),
      code_(code),
      borrowed_(borrowed),
      callbacks_(std::move(callbacks)) {
  for (std::size_t i = 0; i < console_.catalog.params.size(); ++i)  // of what is not stored: decision AMB-034
    after_power_up_[i] = console_.catalog.params[i].fallback;
}

const SettingFact* SetUp::fact_of(int index) const {
  int first = 0;
  for (const SettingFact& fact : console_.model().settings) {
    if (index < first + fact.count) return &fact;
    first += fact.count;
  }
  return nullptr;
}

std::optional<std::int64_t> SetUp::param(std::string_view mnemonic) const {
  const int index = console_.catalog.find_param(mnemonic);
  if (index < 0 || !console_.snapshot.params[ix(index)].known) return std::nullopt;
  return console_.snapshot.params[ix(index)].value;
}

std::optional<std::int64_t> SetUp::setting(Setting id, int axis) const {
  int first = 0;
  for (const SettingFact& fact : console_.model().settings) {
    const ParamState& state = console_.snapshot.params[ix(first + axis)];
    if (fact.id == id) return state.known ? std::optional(state.value) : std::nullopt;
    first += fact.count;
  }
  return std::nullopt;
}

// An axis has its own speeds only if all three are set, else the common ones (PMX manual, HS[axis]). None:
// not read yet.
std::optional<bool> SetUp::has_own_speeds(int axis) const {
  bool own = console_.forms.axis_speeds;
  for (const Setting id : {Setting::axis_high_speed, Setting::axis_low_speed, Setting::axis_accel}) {
    if (!console_.forms.axis_speeds) break;
    const auto value = setting(id, axis);
    if (!value) return std::nullopt;
    own = own && *value != 0;
  }
  return own;
}

/// Speed at which the axis starts and ends without a ramp; 0: not read yet.
std::int64_t SetUp::start_speed(int axis) const {
  const auto own = has_own_speeds(axis);
  if (!own) return 0;
  return (*own ? setting(Setting::axis_low_speed, axis) : setting(Setting::low_speed)).value_or(0);
}

void SetUp::show_own_speeds() {
  if (borrowed_.is_out()) return;
  for (int i = 0; i < console_.model().axes(); ++i) {
    const auto own = has_own_speeds(i);
    const auto speed =
        own.value_or(false) ? setting(Setting::axis_high_speed, i) : setting(Setting::high_speed);
    console_.snapshot.axes[i].own_speed = Pps(own ? static_cast<double>(speed.value_or(0)) : 0);
  }
}

void SetUp::forget(std::string_view head) {
  for (std::size_t i = 0; i < console_.catalog.params.size(); ++i)
    if (console_.catalog.params[i].mnemonic.starts_with(head)) console_.snapshot.params[i].known = false;
}

Task<Result<>> SetUp::read(int index, Priority priority) {
  const ParamInfo& info = console_.catalog.params[ix(index)];
  Conversation::Decode decode = [&info](std::string_view text) { return decode_value(info, text); };
  const ParamState& before = console_.snapshot.params[ix(index)];
  const std::int64_t expected = before.known ? before.value : after_power_up_[ix(index)];
  auto reply = co_await conversation_.ask_confirmed(info.mnemonic, std::move(decode), expected, priority);
  if (!reply) co_return fail(reply.error());
  const std::int64_t value = *reply;
  const bool taken_back = before.known && before.value != value && settled_.test(ix(index)) &&
                          in_ram_only(index) && value == after_power_up_[ix(index)];
  if (taken_back)
    callbacks_.restarted(fmt::format("{} read {} and now reads {}, although no command changed it",
                                     info.mnemonic, encode_value(info, before.value),
                                     encode_value(info, value)));
  const bool read_twice = before.known && before.value == value;  // not just garbled twice in the same way
  settled_.set(ix(index), read_twice && (code_.leaves_param(ix(index)) || !code_.program_may_run()));
  console_.snapshot.params[ix(index)].value = value;
  console_.snapshot.params[ix(index)].known = true;
  if (info.stored) compare_with_stored(index);
  co_return Result<>();
}

// A value that reads as stored needs no Store: it was set back, or the power was off.
void SetUp::compare_with_stored(int index) {
  ParamState& read = console_.snapshot.params[ix(index)];
  if (read.stored) {
    after_power_up_[ix(index)] = read.value;
    stored_known_.set(ix(index));
    return;
  }
  if (!stored_known_.test(ix(index)) || read.value != after_power_up_[ix(index)]) return;
  read.stored = true;
  console_.snapshot.unsaved_setup =
      unsaved_variables_ || std::any_of(console_.snapshot.params.begin(), console_.snapshot.params.end(),
                                        [](const ParamState& p) { return !p.stored; });
}

// Unknown code may set anything.
void SetUp::code_may_set() {
  if (code_.known())
    settled_ &= ~code_.known()->sets;
  else
    settled_.reset();
}

// Whether the value is held in RAM only, not in non-volatile memory.
bool SetUp::in_ram_only(int index) const {
  return (!console_.catalog.params[ix(index)].stored || !console_.snapshot.params[ix(index)].stored) &&
         !borrowed_.is_out();
}

// The positions of a controller that stood at zero do not reveal a power cycle. Lost values do: reads one
// value a second of those that a power-up resets.
Task<Result<>> SetUp::read_next_volatile() {
  const int index = next_that_would_show();
  if (index < 0) co_return Result<>();
  co_return co_await read(index, Priority::poll);
}

/// The next value to read, one after the other; -1: there is none.
int SetUp::next_that_would_show() {
  return kept_.next(static_cast<int>(console_.catalog.params.size()), [this](int index) {
    const ParamInfo& info = console_.catalog.params[ix(index)];
    const ParamState& state = console_.snapshot.params[ix(index)];
    const bool stored_is_known = !info.stored || stored_known_.test(ix(index));
    return state.known && stored_is_known && state.value != after_power_up_[ix(index)] && in_ram_only(index);
  });
}

// True: a value that a power cut would have reset is kept; or it is not, and read() has reported the restart.
Task<Result<bool>> SetUp::something_is_kept() {
  const int index = next_that_would_show();
  if (index < 0 || !settled_.test(ix(index))) co_return co_await code_has_left_something();
  auto read_again = co_await read(index, Priority::poll);
  if (!read_again) co_return fail(read_again.error());
  co_return true;
}

// A value set by a program shows that no power cut followed, if power-up starts no program.
Task<Result<bool>> SetUp::code_has_left_something() {
  if (!code_.known()) co_return false;
  const auto sets = code_.known()->sets;
  auto started = co_await conversation_.ask_number("SLOAD", Priority::poll);
  if (!started || *started != 0) co_return false;
  for (std::size_t i = 0; i < console_.catalog.params.size(); ++i) {
    if (console_.catalog.params[i].stored || !sets.test(i)) continue;
    auto read_again = co_await read(static_cast<int>(i), Priority::poll);
    if (!read_again) co_return fail(read_again.error());
    if (console_.snapshot.params[i].value != console_.catalog.params[i].fallback) co_return true;
  }
  co_return false;
}

// First the unknown ones, then all again, because programs and terminals change them.
Task<Result<>> SetUp::read_in_turn() {
  const int params = static_cast<int>(console_.catalog.params.size());
  int read_now = 0;
  for (int tried = 0; tried < params && read_now < params_per_round; ++tried) {
    const int index = params_.next(params);
    if (console_.snapshot.params[ix(index)].known) continue;
    auto done = co_await read(index, Priority::poll);
    if (!done) co_return done;
    ++read_now;
  }
  if (read_now > 0) co_return Result<>();
  auto done = co_await read(params_.peek(params), Priority::poll);
  params_.next(params);
  co_return done;
}

// Dependencies: ramp times are adjusted to the speeds, the joystick switches StepNLoop off.
void SetUp::changed(int index) {
  const ParamInfo& info = console_.catalog.params[ix(index)];
  ParamState& state = console_.snapshot.params[ix(index)];
  state.known = false;
  state.stored = !info.stored;
  console_.snapshot.unsaved_setup = console_.snapshot.unsaved_setup || info.stored;
  const SettingFact* fact = fact_of(index);
  if (!fact) return;
  switch (fact->id) {
    case Setting::high_speed:
    case Setting::low_speed:
    case Setting::axis_high_speed:
    case Setting::axis_low_speed:
      forget("ACC");
      forget("DEC");
      break;
    case Setting::loop:
    case Setting::joystick:
      callbacks_.loops_unknown();
      forget("SL");
      break;
    default: break;
  }
}

Task<Result<bool>> SetUp::set(intent::SetParam request) {
  const std::string title = fmt::format("A {}", console_.model().title);
  const auto place = check_param(console_.catalog, request, {title, encode_value});
  if (!place) co_return fail(place.error());
  const int index = static_cast<int>(*place);
  const ParamInfo& info = console_.catalog.params[*place];
  auto sent = co_await conversation_.command(set_command(info, request.value), Priority::intent);
  if (!sent) co_return fail(sent.error());
  changed(index);
  auto read_back = co_await read(index, Priority::intent);
  if (!read_back) co_return fail(read_back.error());
  const std::int64_t kept = console_.snapshot.params[ix(index)].value;
  if (kept == request.value) co_return true;
  const bool ramp = info.unit == "ms" && !info.stored;
  if (!ramp)
    co_return fail(FaultKind::controller,
                   fmt::format("{} was set to {}, but the controller reports {}.", info.mnemonic,
                               encode_value(info, request.value), encode_value(info, kept)),
                   "It was sent once.", "The value that the controller reports is in force.");
  console_.report(
      Notice::Kind::info,
      fmt::format("{} was set to {} ms; with the present speeds the controller uses {} ms (table A.0).",
                  info.mnemonic, request.value, kept));
  co_return false;
}

void SetUp::is_stored() {
  for (std::size_t i = 0; i < console_.catalog.params.size(); ++i) {
    ParamState& p = console_.snapshot.params[i];
    if (console_.catalog.params[i].stored) stored_known_.set(i, p.known);
    if (console_.catalog.params[i].stored && p.known) after_power_up_[i] = p.value;
    p.stored = true;
  }
  unsaved_variables_ = false;
  console_.snapshot.unsaved_setup = false;
}

Task<Result<>> SetUp::store() {
  auto done = co_await conversation_.command("STORE", Priority::intent, store_patience);
  if (!done && done.error().kind == FaultKind::no_answer)
    co_return fail(
        FaultKind::no_answer, "The controller did not confirm in time that it has stored the set-up.",
        "STORE was sent once and is not repeated: the memory is rated for a limited number of writes.",
        "Do not switch the controller off now. Compare the set-up before you store again.");
  if (!done) co_return done;
  is_stored();
  console_.report(Notice::Kind::info,
                  "The set-up and the variables V50 to V99 are stored. Speeds, sync settings and V0 to V49 "
                  "are never stored.");
  co_return Result<>();
}

void SetUp::forget_all() {
  for (ParamState& p : console_.snapshot.params) p.known = false;
}

void SetUp::was_borrowed(std::string_view name) {
  if (const int index = console_.catalog.find_param(name); index >= 0) settled_.reset(ix(index));
}

void SetUp::restarted() {
  set_up_is_unknown(console_.snapshot);
  settled_.reset();
  unsaved_variables_ = false;
}

}  // namespace hw::arcus
