// Methods of a controller for its status: axes, inputs, outputs. Rule: a call requests a status round that
// begins after it, so the result is never older than the call; a value that cannot be read now is nil and a
// reason, never an old value.
#include <cmath>

#include <fmt/core.h>

#include "core/script/bind.h"
#include "core/script/options.h"

namespace hw::script {
namespace {

using Push = int (*)(lua_State*, const Snapshot&, const Catalog&, int number);

bool is_gone(const LinkHealth& link) { return !link.connected(); }
std::string why_gone(const LinkHealth& link) {
  return fmt::format("There is no connection. {}", link.sentence.view());
}

std::string why_unread(const LinkHealth& link) {
  if (!link.sentence.view().empty()) return std::string(link.sentence.view());
  return "The controller does not report it at present.";
}

int push_unknown(lua_State* L, std::string reason, FaultKind kind = FaultKind::no_answer) {
  return push_refusal(L, Refusal{std::move(reason), kind});
}

/// Time at which the round read the value.
using SeenAt = Instant (*)(const Snapshot&, int number);
Instant axis_seen_at(const Snapshot& known, int axis) { return known.axes[axis].seen_at; }
Instant io_seen_at(const Snapshot& known, int) { return known.io_seen_at; }

Task<Answer> read_fresh(SessionPtr session, Instant asked_at, Push push, int number, SeenAt seen_at,
                        std::string what) {
  co_await session->pump().refresh();
  co_return [session, asked_at, push, number, seen_at, what = std::move(what)](lua_State* L) {
    const Snapshot& known = session->known();
    const LinkHealth& link = known.link;
    if (is_gone(link)) return push_unknown(L, why_gone(link), FaultKind::lost);
    if (number >= 0 && seen_at(known, number) < asked_at)
      return push_unknown(L, fmt::format("{} cannot be read now. {}", what, why_unread(link)));
    return push(L, known, session->catalog(), number);
  };
}

int ask_of(Call& call, const SessionPtr& session, Push push, int number, SeenAt seen_at, std::string what) {
  return call.wait(
      read_fresh(session, call.runner().scheduler().now(), push, number, seen_at, std::move(what)));
}

/// Adds the axis to the table of a refusal.
Task<Answer> naming_axis(Task<Answer> reading, std::string axis) {
  const Answer read = co_await std::move(reading);
  co_return [read, axis = std::move(axis)](lua_State* L) {
    const int results = read(L);
    if (results == 3 && lua_istable(L, -1)) {
      lua_pushlstring(L, axis.data(), axis.size());
      lua_setfield(L, -2, "axis");
    }
    return results;
  };
}

Task<Answer> read_axis(const Call& call, const OneAxis& one, Push push) {
  const std::string& name = one.session->catalog().axes[static_cast<std::size_t>(one.index)].name;
  return naming_axis(
      read_fresh(one.session, call.runner().scheduler().now(), push, one.index, axis_seen_at, "Axis " + name),
      name);
}

int of_axis(Call& call, Push push) {
  const OneAxis one = one_axis(call, 1, call.function());
  if (one.index < 0) return call.refuse(one.refusal);
  return call.wait(read_axis(call, one, push));
}

int push_position(lua_State* L, const Snapshot& known, const Catalog& catalog, int axis) {
  const AxisState& state = known.axes[axis];
  if (!state.position_known)
    return push_unknown(L, fmt::format("The position of axis {} is not known.", catalog.axes[axis].name));
  lua_pushinteger(L, state.position.value);
  return 1;
}
int push_encoder(lua_State* L, const Snapshot& known, const Catalog& catalog, int axis) {
  if (!known.axes[axis].has_encoder)
    return push_unknown(L, fmt::format("Axis {} has no encoder.", catalog.axes[axis].name));
  lua_pushinteger(L, known.axes[axis].encoder.value);
  return 1;
}
const char* name_of(Activity a) {
  switch (a) {
    case Activity::unknown: return "unknown";
    case Activity::idle: return "idle";
    case Activity::moving: return "moving";
    case Activity::jogging: return "jogging";
    case Activity::homing: return "homing";
    case Activity::stopping: return "stopping";
    case Activity::error: return "error";
  }
  return "unknown";
}
const char* name_of(EndedBy e) {
  switch (e) {
    case EndedBy::nothing: return "nothing";
    case EndedBy::target: return "target";
    case EndedBy::limit: return "limit";
    case EndedBy::stop: return "stop";
    case EndedBy::abort: return "abort";
    case EndedBy::elsewhere: return "elsewhere";
    case EndedBy::error: return "error";
    case EndedBy::lost: return "lost";
    case EndedBy::not_in_place: return "not_in_place";
  }
  return "nothing";
}
const char* name_of(RunState r) {
  switch (r) {
    case RunState::idle: return "idle";
    case RunState::running: return "running";
    case RunState::waiting: return "waiting";
    case RunState::held: return "held";
    case RunState::error: return "error";
  }
  return "idle";
}
const char* name_of(LinkState l) {
  switch (l) {
    case LinkState::connecting: return "connecting";
    case LinkState::good: return "good";
    case LinkState::late: return "late";
    case LinkState::lost: return "lost";
    case LinkState::closed: return "closed";
  }
  return "connecting";
}

void set_flag(lua_State* L, const char* name, bool on) {
  lua_pushboolean(L, on);
  lua_setfield(L, -2, name);
}
void set_word(lua_State* L, const char* name, std::string_view word) {
  lua_pushlstring(L, word.data(), word.size());
  lua_setfield(L, -2, name);
}
void set_whole(lua_State* L, const char* name, std::int64_t value) {
  lua_pushinteger(L, value);
  lua_setfield(L, -2, name);
}

/// Fields of servo axes only; unknown values of the loop are omitted.
void set_servo(lua_State* L, const AxisState& s) {
  set_flag(L, "servo", s.loop != Loop::none);
  if (s.loop == Loop::none) return;
  set_whole(L, "command", s.command.value);
  set_whole(L, "following_error", s.following_error().value);
  if (s.loop == Loop::unknown) return;
  set_flag(L, "in_place", s.loop == Loop::in_place);
  set_flag(L, "open_loop", s.loop == Loop::open);
}

int push_axis_status(lua_State* L, const Snapshot& known, const Catalog&, int axis) {
  const AxisState& s = known.axes[axis];
  lua_createtable(L, 0, 20);
  set_servo(L, s);
  set_flag(L, "moving", s.moves());
  set_flag(L, "idle", s.activity == Activity::idle);
  set_flag(L, "jogging", s.activity == Activity::jogging);
  set_flag(L, "homing", s.activity == Activity::homing);
  set_flag(L, "stopping", s.activity == Activity::stopping);
  set_flag(L, "limit_minus", s.limit_minus);
  set_flag(L, "limit_plus", s.limit_plus);
  set_flag(L, "home", s.home);
  set_flag(L, "alarm", s.alarm);
  set_flag(L, "enabled", s.enabled);
  set_flag(L, "slip", s.slipped);
  set_flag(L, "position_known", s.position_known);
  set_flag(L, "position_doubtful", s.trust.doubtful());
  set_word(L, "activity", name_of(s.activity));
  set_word(L, "ended_by", name_of(s.ended_by));
  return 1;
}

/// Always pushes a table with `link`, to allow diagnosis. While the link is not good, `why` gives the reason,
/// and values that could not be read are omitted.
int push_whole_status(lua_State* L, const Snapshot& known) {
  lua_createtable(L, 0, 10);
  set_word(L, "link", name_of(known.link.state));
  if (known.link.state != LinkState::good) {
    set_word(L, "why", known.link.sentence.view());
    return 1;
  }
  set_flag(L, "moving", known.any_axis_moving());
  set_word(L, "program", name_of(known.program.run));
  set_whole(L, "program_number", known.program.slot);
  set_whole(L, "program_command", known.program.command);
  if (known.pieces.total > 0) {
    set_whole(L, "pieces", known.pieces.total);
    set_whole(L, "pieces_done", known.pieces.done);
    set_flag(L, "in_pieces", known.pieces.running);
    set_whole(L, "step", known.pieces.step + 1);
  }
  set_flag(L, "unsaved_setup", known.unsaved_setup);
  set_flag(L, "unsaved_programs", known.unsaved_programs);
  set_word(L, "notice", known.notice.view());
  set_word(L, "firmware", known.identity.firmware.view());
  return 1;
}

constexpr Duration short_look = Millis(20), long_look = Millis(200);
constexpr std::int64_t enough_steps = 50;  // fewer are too imprecise: one step is then a few percent

// Measures the steps between two status rounds over the time between them. 0 at once at rest.
Task<Answer> measure_velocity(Runner& runner, SessionPtr session, int axis, double steps_per_unit) {
  const AxisState& state = session->known().axes[axis];
  co_await session->pump().refresh();
  const Steps from = state.position;
  const Instant from_at = state.seen_at;
  for (const Duration look : {short_look, long_look}) {
    const bool enough = std::abs((state.position - from).value) >= enough_steps;
    if (enough || !session->known().any_axis_moving()) break;
    co_await runner.sleep_until(from_at + look);
    co_await session->pump().refresh();
  }
  const Duration passed = state.seen_at - from_at;
  const double speed =
      passed > Duration::zero() ? static_cast<double>((state.position - from).value) / seconds(passed) : 0;
  const LinkHealth& link = session->known().link;
  if (is_gone(link)) co_return answer_refused(why_gone(link));
  co_return [speed = speed / steps_per_unit](lua_State* L) {
    lua_pushnumber(L, speed);
    return 1;
  };
}
int velocity(Call& call) {
  const OneAxis one = one_axis(call, 1, "velocity");
  if (one.index < 0) return call.refuse(one.refusal);
  const Counting counting = Options(call, 2, "velocity", {"unit"}).counting();
  return call.wait(
      measure_velocity(call.runner(), one.session, one.index, counting.steps_per_unit(call, one)));
}

Task<Answer> read_whole_status(SessionPtr session) {
  co_await session->pump().refresh();
  co_return [session](lua_State* L) { return push_whole_status(L, session->known()); };
}

/// Converts a reading in steps to units, if `per_unit` is not 0.
Task<Answer> in_units(Task<Answer> reading, double per_unit) {
  const Answer read = co_await std::move(reading);
  co_return [read, per_unit](lua_State* L) {
    const int results = read(L);
    if (results != 1 || !lua_isinteger(L, -1)) return results;
    const Steps steps(lua_tointeger(L, -1));
    lua_pop(L, 1);
    push_steps(L, steps, per_unit);
    return 1;
  };
}
int position(Call& call) {
  const OneAxis one = one_axis(call, 1, "position");
  if (one.index < 0) return call.refuse(one.refusal);
  const double per_unit = Options(call, 2, "position", {"unit"}).counting().per_unit(call, one);
  return call.wait(in_units(read_axis(call, one, push_position), per_unit));
}
int encoder(Call& call) { return of_axis(call, push_encoder); }
int status(Call& call) {
  if (!call.has(1)) return call.wait(read_whole_status(session_of(call)));
  return of_axis(call, push_axis_status);
}

// ---- inputs and outputs, by the maker's number

/// The index of a number, and the range of numbers.
struct Numbered {
  int place;  ///< -1: none
  std::size_t count;
  int first, last;
};

template <class List>
Numbered numbered(const List& list, int place, const Catalog& c,
                  int (Catalog::*number_of)(std::size_t) const) {
  return list.empty() ? Numbered{-1, 0, 0, 0}
                      : Numbered{place, list.size(), (c.*number_of)(0), (c.*number_of)(list.size() - 1)};
}

/// "There is no input 9. VXM has 1 to 4."
std::string no_such(const Catalog& catalog, const char* what, std::int64_t number, const Numbered& there) {
  return there.count == 0 ? fmt::format("{} has no {}s.", catalog.short_name, what)
                          : fmt::format("There is no {} {}. {} has {} to {}.", what, number,
                                        catalog.short_name, there.first, there.last);
}

int of_number(Call& call, const char* what, std::int64_t number, const Numbered& there, Push push) {
  if (there.place < 0) return call.refuse(no_such(session_of(call)->catalog(), what, number, there));
  return ask_of(call, session_of(call), push, there.place, io_seen_at,
                fmt::format("The {} {}", what, number));
}

/// Whether the line has been read; if not, pushes nil and the reason.
bool has_read(lua_State* L, std::uint32_t known, int place, const char* what, int number) {
  if (known & (1u << place)) return true;
  push_unknown(L, fmt::format("{} {} has not been read.", what, number));
  return false;
}
bool is_high(std::uint32_t bits, int place) { return (bits & (1u << place)) != 0; }

int push_input(lua_State* L, const Snapshot& known, const Catalog& catalog, int place) {
  if (!has_read(L, known.inputs_known, place, "Input", catalog.input_number(place))) return 3;
  lua_pushboolean(L, is_high(known.inputs, place) != catalog.inputs[place].active_low);
  return 1;
}
int push_output(lua_State* L, const Snapshot& known, const Catalog& catalog, int place) {
  if (!has_read(L, known.outputs_known, place, "Output", catalog.output_number(place))) return 3;
  lua_pushboolean(L, is_high(known.outputs, place));
  return 1;
}

// A round may have read another input; then this one is queried. A reading at the instant of the call may be
// older than the call, except on a controller without a query, where it is from the new round.
Task<Answer> fresh_analog(SessionPtr session, Instant asked_at, int place) {
  const auto at = static_cast<std::size_t>(place);
  const Snapshot& known = session->known();
  co_await session->pump().refresh();
  if (!is_gone(known.link) && known.analog_seen_at[at] <= asked_at) {
    IntentBody ask_it = intent::ReadAnalog(place + 1);
    const auto read = co_await session->perform(std::move(ask_it));
    if (!read && known.analog_seen_at[at] < asked_at) co_return answer_refused(read.error());
  }
  if (is_gone(known.link)) co_return answer_refused(why_gone(known.link));
  if (known.analog_seen_at[at] < asked_at)
    co_return answer_refused(fmt::format("Analog input {} cannot be read now.", place + 1));
  const std::int32_t reading = known.analog[at];
  co_return [reading](lua_State* L) {
    lua_pushinteger(L, reading);
    return 1;
  };
}

/// Waits for the end of a round that begins now, or for a newer query of the inputs.
Task<> refresh_inputs(SessionPtr session, Instant asked_at) {
  const std::uint64_t round = session->pump().want_round();
  const Snapshot& known = session->known();
  while (known.link.connected() && known.inputs_asked_at <= asked_at &&
         session->pump().rounds_ended() < round)
    co_await session->pump().published().wait();
}

Task<Answer> read_input(SessionPtr session, Instant asked_at, int place) {
  co_await refresh_inputs(session, asked_at);
  co_return [session, asked_at, place](lua_State* L) {
    const Snapshot& known = session->known();
    if (is_gone(known.link)) return push_unknown(L, why_gone(known.link), FaultKind::lost);
    if (known.inputs_asked_at <= asked_at && known.io_seen_at < asked_at)
      return push_unknown(L, fmt::format("The input {} cannot be read now. {}",
                                         session->catalog().input_number(place), why_unread(known.link)));
    return push_input(L, known, session->catalog(), place);
  };
}

int input(Call& call) {
  const SessionPtr& session = session_of(call);
  const Catalog& c = session->catalog();
  const std::int64_t n = call.whole(1, "input");
  const Numbered there = numbered(c.inputs, c.find_input(n), c, &Catalog::input_number);
  if (there.place < 0) return call.refuse(no_such(c, "input", n, there));
  return call.wait(read_input(session, call.runner().scheduler().now(), there.place));
}
int output(Call& call) {
  const Catalog& c = session_of(call)->catalog();
  const std::int64_t n = call.whole(1, "output");
  const Numbered there = numbered(c.outputs, c.find_output(n), c, &Catalog::output_number);
  if (there.place < 0 || !call.has(2)) return of_number(call, "output", n, there, push_output);
  return perform(call, intent::SetOutput(static_cast<int>(n), call.on(2, "on")));
}
int analog(Call& call) {
  const SessionPtr& session = session_of(call);
  const auto count = session->catalog().analog.size();
  const std::int64_t n = call.whole(1, "analog input");
  if (n < 1 || n > static_cast<std::int64_t>(count))
    return call.refuse(
        no_such(session->catalog(), "analog input", n, {-1, count, 1, static_cast<int>(count)}));
  return call.wait(fresh_analog(session, call.runner().scheduler().now(), static_cast<int>(n) - 1));
}

constexpr Function status_table[] = {
    {"position", position}, {"encoder", encoder}, {"velocity", velocity}, {"status", status},
    {"input", input},       {"output", output},   {"analog", analog},
};

}  // namespace

std::span<const Function> status_methods() { return status_table; }

}  // namespace hw::script
