// Set-up: every parameter by the maker's mnemonic; storing; and the list of what can be asked of the driver.
#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/arcus/driver.h"

namespace hw::arcus {
namespace {

constexpr Duration store_patience = std::chrono::seconds(3);

std::string range_words(const ParamInfo& p) {
  if (!p.choices.empty()) {
    std::string all;
    for (const ParamChoice& c : p.choices) all += fmt::format("{}{}", all.empty() ? "" : ", ", c.value);
    return "one of " + all;
  }
  return fmt::format("{} to {}{}", encode_value(p, p.minimum), encode_value(p, p.maximum),
                     p.also_zero ? ", or 0" : "");
}

}  // namespace

Task<Result<>> ArcusDriver::perform(const IntentBody& body) {
  using namespace intent;
  if (!talk_.is_open()) co_return talk_.no_connection();
  if (auto looked = co_await look_after_silence(); !looked) co_return looked;
  if (auto returned = co_await give_back_first(); !returned) co_return returned;
  if (const auto* i = std::get_if<MoveTo>(&body)) co_return co_await move(i->targets, i->speed, false);
  if (const auto* i = std::get_if<MoveBy>(&body)) co_return co_await move(i->distances, i->speed, true);
  if (const auto* i = std::get_if<JogStart>(&body)) co_return co_await jog(*i);
  if (const auto* i = std::get_if<Home>(&body)) co_return co_await home(*i);
  if (const auto* i = std::get_if<SetPosition>(&body)) co_return co_await set_position(*i);
  if (const auto* i = std::get_if<SetEncoder>(&body)) co_return co_await set_encoder(*i);
  if (const auto* i = std::get_if<SetPower>(&body)) co_return co_await set_power(*i);
  if (const auto* i = std::get_if<SetOutput>(&body)) co_return co_await set_output(*i);
  if (const auto* i = std::get_if<SetParam>(&body)) co_return co_await set_param(*i);
  if (const auto* i = std::get_if<Act>(&body)) co_return co_await act(*i);
  if (const auto* i = std::get_if<SetVariable>(&body)) co_return co_await set_variable(*i);
  if (const auto* i = std::get_if<FeedMoves>(&body)) co_return co_await start_feed(*i);
  if (const auto* i = std::get_if<SendText>(&body)) co_return co_await send_text(*i);
  if (const auto* i = std::get_if<Watch>(&body)) {
    watched_ = i->groups;
    co_return Result<>();
  }
  if (const auto* i = std::get_if<ReadParams>(&body)) co_return co_await read_params(i->only);
  if (const auto* i = std::get_if<ReadAnalog>(&body);
      i && i->number >= 1 && i->number <= model().analog_inputs)
    co_return co_await read_analog(i->number, Priority::intent);
  if (std::holds_alternative<Store>(body)) co_return co_await store();
  if (std::holds_alternative<ReadAgain>(body)) co_return co_await read_again();
  if (std::holds_alternative<Reset>(body))
    co_return fail(FaultKind::refused, fmt::format("A {} has no reset command.", model().title),
                   "Nothing was sent.", "Switch its power off and on.");
  co_return co_await perform_program(body);
}

const SettingFact* ArcusDriver::fact_of(int index) const {
  int first = 0;
  for (const SettingFact& fact : model().settings) {
    if (index < first + fact.count) return &fact;
    first += fact.count;
  }
  return nullptr;
}

std::optional<std::int64_t> ArcusDriver::param(std::string_view mnemonic) const {
  const int index = catalog_.find_param(mnemonic);
  if (index < 0 || !draft_.params[ix(index)].known) return std::nullopt;
  return draft_.params[ix(index)].value;
}

std::optional<std::int64_t> ArcusDriver::setting(Setting id, int axis) const {
  int first = 0;
  for (const SettingFact& fact : model().settings) {
    const ParamState& state = draft_.params[ix(first + axis)];
    if (fact.id == id) return state.known ? std::optional(state.value) : std::nullopt;
    first += fact.count;
  }
  return std::nullopt;
}

// An axis has speeds of its own where all three of them are set, else it has the common one (PMX manual,
// HS[axis]). None: they are not read yet.
std::optional<bool> ArcusDriver::has_own_speeds(int axis) const {
  bool own = forms_.axis_speeds;
  for (const Setting id : {Setting::axis_high_speed, Setting::axis_low_speed, Setting::axis_accel}) {
    if (!forms_.axis_speeds) break;
    const auto value = setting(id, axis);
    if (!value) return std::nullopt;
    own = own && *value != 0;
  }
  return own;
}

/// At which it starts and ends without a ramp; 0: not read yet.
std::int64_t ArcusDriver::start_speed(int axis) const {
  const auto own = has_own_speeds(axis);
  if (!own) return 0;
  return (*own ? setting(Setting::axis_low_speed, axis) : setting(Setting::low_speed)).value_or(0);
}

void ArcusDriver::show_own_speeds() {
  if (borrowed_) return;
  for (int i = 0; i < axis_count(); ++i) {
    const auto own = has_own_speeds(i);
    const auto speed =
        own.value_or(false) ? setting(Setting::axis_high_speed, i) : setting(Setting::high_speed);
    draft_.axes[i].own_speed = Pps(own ? static_cast<double>(speed.value_or(0)) : 0);
  }
}

void ArcusDriver::forget_params(std::string_view head) {
  for (std::size_t i = 0; i < catalog_.params.size(); ++i)
    if (catalog_.params[i].mnemonic.starts_with(head)) draft_.params[i].known = false;
}

Task<Result<>> ArcusDriver::read_param(int index, Priority priority) {
  const ParamInfo& info = catalog_.params[ix(index)];
  std::function<bool(std::string_view)> is_value = [&info](std::string_view text) {
    return decode_value(info, text).has_value();
  };
  auto reply = co_await talk_.ask_for(info.mnemonic, std::move(is_value), priority);
  if (!reply) co_return fail(reply.error());
  const std::int64_t value = *decode_value(info, *reply);
  const ParamState& before = draft_.params[ix(index)];
  const bool taken_back = before.known && before.value != value && nobody_sets_.test(ix(index)) &&
                          in_ram_only(index) && value == after_power_up_[ix(index)];
  if (taken_back)
    restarted(fmt::format("{} read {} and now reads {}, and nothing that was sent does that", info.mnemonic,
                          encode_value(info, before.value), encode_value(info, value)),
              std::nullopt);
  draft_.params[ix(index)].value = value;
  draft_.params[ix(index)].known = true;
  const bool programs_leave_it = stored_code_ && !stored_code_->sets.test(ix(index));
  nobody_sets_.set(ix(index), programs_leave_it || scheduler_.now() > programs_run_until_);
  if (info.stored) compare_with_stored(index);
  co_return Result<>();
}

// What reads as it is stored needs no Store: it was set back, or the power was off.
void ArcusDriver::compare_with_stored(int index) {
  ParamState& read = draft_.params[ix(index)];
  if (read.stored) {
    after_power_up_[ix(index)] = read.value;
    stored_known_.set(ix(index));
    return;
  }
  if (!stored_known_.test(ix(index)) || read.value != after_power_up_[ix(index)]) return;
  read.stored = true;
  draft_.unsaved_setup = unsaved_variables_ || std::any_of(draft_.params.begin(), draft_.params.end(),
                                                           [](const ParamState& p) { return !p.stored; });
}

// One that is not known may set anything. Whether it still runs shows in the next second.
void ArcusDriver::program_runs(Duration at_most) {
  if (stored_code_)
    nobody_sets_ &= ~stored_code_->sets;
  else
    nobody_sets_.reset();
  programs_run_until_ = std::max(programs_run_until_, scheduler_.now() + at_most);
}

// Not in the memory that stays.
bool ArcusDriver::in_ram_only(int index) const {
  return (!catalog_.params[ix(index)].stored || !draft_.params[ix(index)].stored) && !borrowed_;
}

// A controller that stood at zero shows by its positions nothing of having been switched off and on. What it
// then has lost shows it: one value a second of those that a power-up takes back.
Task<Result<>> ArcusDriver::read_what_power_keeps() {
  const int index = next_that_would_show();
  if (index < 0) co_return Result<>();
  co_return co_await read_param(index, Priority::poll);
}

/// One after the other; -1: there is none.
int ArcusDriver::next_that_would_show() {
  const int params = static_cast<int>(catalog_.params.size());
  for (int tried = 0; tried < params; ++tried) {
    const int index = next_kept_;
    next_kept_ = (next_kept_ + 1) % params;
    const ParamInfo& info = catalog_.params[ix(index)];
    const ParamState& state = draft_.params[ix(index)];
    const bool would_show = !state.stored || (!info.stored && state.value != info.fallback);
    if (state.known && would_show && in_ram_only(index)) return index;
  }
  return -1;
}

// What depends on what: times are adjusted to the speeds, the joystick switches StepNLoop off.
void ArcusDriver::changed_param(int index) {
  const ParamInfo& info = catalog_.params[ix(index)];
  ParamState& state = draft_.params[ix(index)];
  state.known = false;
  state.stored = !info.stored;
  draft_.unsaved_setup = draft_.unsaved_setup || info.stored;
  const SettingFact* fact = fact_of(index);
  if (!fact) return;
  switch (fact->id) {
    case Setting::high_speed:
    case Setting::low_speed:
    case Setting::axis_high_speed:
    case Setting::axis_low_speed:
      forget_params("ACC");
      forget_params("DEC");
      break;
    case Setting::loop:
    case Setting::joystick:
      for (AxisMind& mind : minds_) mind.loop_state = -1;
      forget_params("SL");
      break;
    default: break;
  }
}

Task<Result<>> ArcusDriver::set_param(intent::SetParam wish) {
  const int index = catalog_.find_param(wish.mnemonic);
  if (index < 0)
    co_return fail(FaultKind::refused, fmt::format("A {} has no parameter {}.", model().title, wish.mnemonic),
                   "Nothing was sent.");
  const ParamInfo& info = catalog_.params[ix(index)];
  if (!info.accepts(wish.value))
    co_return fail(FaultKind::refused,
                   fmt::format("{} is not possible for {} ({}): it takes {}.", encode_value(info, wish.value),
                               info.mnemonic, info.label, range_words(info)),
                   "Nothing was sent.");
  if (!info.warning.empty() && !wish.confirmed && !(wish.value == 0))
    co_return fail(FaultKind::refused, info.warning, "Nothing was sent.", "Confirm it to go on.");
  auto set = co_await talk_.command(set_command(info, wish.value), Priority::intent);
  if (!set) co_return set;
  changed_param(index);
  auto read = co_await read_param(index, Priority::intent);
  if (!read) co_return read;
  const std::int64_t kept = draft_.params[ix(index)].value;
  if (kept == wish.value) co_return co_await read_loop(Priority::intent);
  const bool ramp = info.unit == "ms" && !info.stored;
  if (!ramp)
    co_return fail(FaultKind::controller,
                   fmt::format("{} was set to {}, but the controller says {}.", info.mnemonic,
                               encode_value(info, wish.value), encode_value(info, kept)),
                   "It was sent once.", "The number that the controller says is the one that holds.");
  tell(Notice::Kind::info,
       fmt::format("{} was set to {} ms; with the present speeds the controller uses {} ms (table A.0).",
                   info.mnemonic, wish.value, kept));
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_params(std::string only) {
  if (!only.empty()) {
    const int index = catalog_.find_param(only);
    if (index >= 0) co_return co_await read_param(index, Priority::intent);
  }
  for (int i = 0; i < static_cast<int>(catalog_.params.size()); ++i) {
    auto read = co_await read_param(i, Priority::transfer);
    if (!read) co_return read;
    co_await stay_live();
  }
  for (int n = catalog_.variables.stored_from; n < catalog_.variables.count; ++n) {
    auto read = co_await read_variable(n, Priority::transfer);
    if (!read) co_return read;
    co_await stay_live();
  }
  co_return Result<>();
}

Task<Result<>> ArcusDriver::read_again() {
  for (ParamState& p : draft_.params) p.known = false;
  draft_.variables_known.reset();
  for (AxisMind& mind : minds_) mind.loop_state = -1;
  co_return co_await read_state();
}

void ArcusDriver::is_stored() {
  for (std::size_t i = 0; i < catalog_.params.size(); ++i) {
    ParamState& p = draft_.params[i];
    if (catalog_.params[i].stored) stored_known_.set(i, p.known);
    if (catalog_.params[i].stored && p.known) after_power_up_[i] = p.value;
    p.stored = true;
  }
  unsaved_variables_ = false;
  draft_.unsaved_setup = false;
}

Task<Result<>> ArcusDriver::store() {
  auto done = co_await talk_.command("STORE", Priority::intent, store_patience);
  if (!done && done.error().kind == FaultKind::no_answer)
    co_return fail(FaultKind::no_answer, "The controller did not confirm in time that it has stored.",
                   "STORE was sent once and is not repeated: the memory bears a limited number of writes.",
                   "Do not switch the controller off now. Compare the set-up before you store again.");
  if (!done) co_return done;
  is_stored();
  tell(Notice::Kind::info,
       "The set-up and the variables V50 to V99 are stored. Speeds, sync settings and V0 to V49 are never "
       "kept.");
  co_return Result<>();
}

}  // namespace hw::arcus
