// What hw.open() gives: one controller. Rule for everything that is read (position, status, inputs ...): the
// call asks for a round of status that begins after it, so what it gives back is never older than the call;
// what cannot be read now is nil and a reason, never an old value.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/core.h>

#include "core/script/bind.h"

namespace hw::script {
namespace {

using SessionPtr = std::shared_ptr<Session>;

// ---- arguments

AxisId id_of(int index) { return AxisId{static_cast<std::uint8_t>(index)}; }

Sign sign_of(const Call& call, int argument) {
  const std::string sign = call.text(argument, "direction");
  if (sign == "+") return Sign::plus;
  if (sign == "-") return Sign::minus;
  throw Misuse("the direction must be \"+\" or \"-\"");
}

struct ById {  // the same order in every run
  bool operator()(const SessionPtr& a, const SessionPtr& b) const {
    return a->catalog().id() < b->catalog().id();
  }
};
using Targets = std::map<SessionPtr, std::vector<AxisTarget>, ById>;

// {[1]=400} or {X=1000, Y=0}, put into the catalog's order; on a bus {["01"]=400}. Not empty: why not.
std::string read_targets(const Call& call, int argument, Targets& targets) {
  const int table = call.place(argument);
  if (!lua_istable(call.L, table)) throw Misuse("the targets must be a table like {[1]=400}");
  lua_pushnil(call.L);
  while (lua_next(call.L, table)) {
    const OneAxis one = one_axis_at(call, lua_absindex(call.L, -2), "targets");
    int whole = 0;
    const lua_Integer steps = lua_tointegerx(call.L, -1, &whole);
    if (!whole) throw Misuse("a target must be a whole number of steps");
    lua_pop(call.L, 1);
    if (one.index < 0) return one.refusal;
    targets[one.session].push_back(AxisTarget{id_of(one.index), Steps(steps)});
  }
  if (targets.empty()) throw Misuse("the table of targets is empty");
  for (auto& [session, own] : targets)
    std::sort(own.begin(), own.end(), [](const auto& a, const auto& b) { return a.axis < b.axis; });
  return {};
}

// ---- commands

Task<Answer> perform_body(SessionPtr session, IntentBody body) {
  const auto result = co_await session->perform(std::move(body));
  co_return answer_of(result);
}
int perform(Call& call, IntentBody body) {
  return call.wait(perform_body(session_of(call), std::move(body)));
}
int perform_on(Call& call, const OneAxis& one, IntentBody body) {
  return call.wait(perform_body(one.session, std::move(body)));
}

// All begin before the first is waited for.
template <class Move>
Task<Answer> move_all(Targets targets) {
  std::vector<std::pair<SessionPtr, IntentId>> under_way;
  for (auto& [session, own] : targets) under_way.emplace_back(session, session->post(Move(std::move(own))));
  Result<> all;
  for (const auto& [session, id] : under_way) {
    auto moved = co_await session->outcome(id);
    if (all && !moved) all = std::move(moved);
  }
  co_return answer_of(all);
}

template <class Move>
int move(Call& call) {
  Targets targets;
  if (const std::string why = read_targets(call, 1, targets); !why.empty()) return call.refuse(why);
  return call.wait(move_all<Move>(std::move(targets)));
}

int jog(Call& call) {
  const OneAxis one = one_axis(call, 1, "jog");
  if (one.index < 0) return call.refuse(one.refusal);
  const Pps speed(call.has(3) ? call.number(3, "speed") : 0);
  return perform_on(call, one, intent::JogStart(id_of(one.index), sign_of(call, 2), speed, false));
}

int home(Call& call) {
  const OneAxis one = one_axis(call, 1, "home");
  if (one.index < 0) return call.refuse(one.refusal);
  int mode = 0;
  if (call.has(3)) {
    const std::string wanted = call.text(3, "mode");
    const auto& modes = one.session->catalog().homing_modes;
    const auto found =
        std::find_if(modes.begin(), modes.end(), [&](const HomingMode& m) { return m.id == wanted; });
    if (found == modes.end()) return call.refuse(fmt::format("There is no way of homing \"{}\".", wanted));
    mode = static_cast<int>(found - modes.begin());
  }
  return perform_on(call, one, intent::Home(id_of(one.index), sign_of(call, 2), mode));
}

Task<Answer> stop_bus(std::shared_ptr<SessionGroup> bus, bool at_once) {
  const auto stopped = co_await bus->perform_stop(at_once);
  co_return answer_of(stopped);
}

template <class How>
int stop(Call& call) {
  if (call.has(1)) {
    const OneAxis one = one_axis(call, 1, "stop");
    if (one.index < 0) return call.refuse(one.refusal);
    return perform_on(call, one, How(bus_of(call) ? -1 : one.index));
  }
  if (auto bus = bus_of(call)) return call.wait(stop_bus(std::move(bus), std::is_same_v<How, intent::Abort>));
  return perform(call, How(-1));
}

Task<Answer> wait_idle(SessionPtr session, Duration patience) {
  const auto idle = co_await session->wait_until_idle(patience);
  co_return answer_of(idle);
}
Task<Answer> wait_bus_idle(std::shared_ptr<SessionGroup> bus, Duration patience) {
  const auto idle = co_await bus->wait_until_idle(patience);
  co_return answer_of(idle);
}
int wait(Call& call) {
  const Duration patience = call.patience(1, 3600);
  if (auto bus = bus_of(call)) return call.wait(wait_bus_idle(std::move(bus), patience));
  return call.wait(wait_idle(session_of(call), patience));
}

// ---- raw text

// On a bus: to all of its devices at once, where the maker has a way to say that.
int send(Call& call) {
  const auto bus = bus_of(call);
  const SessionPtr& session = bus ? bus->members().front() : session_of(call);
  if (bus && !session->catalog().can.broadcast)
    return call.refuse(fmt::format("{} has no message to all devices of a wire. Send it to each of them.",
                                   session->catalog().short_name));
  const LinkHealth& link = session->known().link;
  if (link.state == LinkState::lost || link.state == LinkState::closed)
    return call.refuse(fmt::format("There is no connection. {}", link.sentence.view()));
  session->send(intent::SendText(call.text(1, "text"), bus != nullptr));
  return call.yes();
}

Task<Answer> query_text(SessionPtr session, std::string text, Duration patience) {
  auto reply = co_await session->pump().query(std::move(text), patience);
  if (!reply) co_return answer_refused(reply.error().sentence());
  co_return answer_text(std::move(*reply));
}
int query(Call& call) {
  return call.wait(query_text(session_of(call), call.text(1, "text"), call.patience(2, 1)));
}

Task<Answer> read_text(Runner& runner, SessionPtr session, Duration patience) {
  const Instant deadline = runner.scheduler().now() + patience;
  std::string text;
  for (bool in_time = true; in_time && !runner.over();) {
    if (session->pump().driver().take_unsolicited(text)) co_return answer_text(std::move(text));
    if (session->known().link.state == LinkState::closed) break;
    in_time = co_await session->pump().published().wait_until(deadline);
  }
  if (session->pump().driver().take_unsolicited(text)) co_return answer_text(std::move(text));
  co_return answer_refused("Nothing came.");
}
int read(Call& call) { return call.wait(read_text(call.runner(), session_of(call), call.patience(1, 1))); }

// ---- what is known

using Push = int (*)(lua_State*, const Snapshot&, const Catalog&, int number);

// Whether the controller can be believed now; else why not.
std::string why_unknown(const LinkHealth& link) {
  if (link.state == LinkState::lost || link.state == LinkState::closed)
    return fmt::format("There is no connection. {}", link.sentence.view());
  return std::string(link.sentence.view());
}

int push_unknown(lua_State* L, std::string reason) {
  lua_pushnil(L);
  lua_pushlstring(L, reason.data(), reason.size());
  return 2;
}

Task<Answer> read_fresh(SessionPtr session, Instant asked_at, Push push, int number, bool of_axis) {
  co_await session->pump().refresh();
  co_return [session, asked_at, push, number, of_axis](lua_State* L) {
    const Snapshot& known = session->known();
    const LinkHealth& link = known.link;
    if (link.state == LinkState::lost || link.state == LinkState::closed)
      return push_unknown(L, why_unknown(link));
    if (of_axis && number >= 0 && known.axes[number].seen_at < asked_at)
      return push_unknown(L, fmt::format("Axis {} cannot be read now. {}",
                                         session->catalog().axes[number].name, link.sentence.view()));
    return push(L, known, session->catalog(), number);
  };
}

int ask_of(Call& call, const SessionPtr& session, Push push, int number, bool of_axis) {
  return call.wait(read_fresh(session, call.runner().scheduler().now(), push, number, of_axis));
}
int ask(Call& call, Push push, int number) { return ask_of(call, session_of(call), push, number, false); }

int of_axis(Call& call, Push push) {
  const OneAxis one = one_axis(call, 1, "axis");
  if (one.index < 0) return call.refuse(one.refusal);
  return ask_of(call, one.session, push, one.index, true);
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

int push_axis_status(lua_State* L, const Snapshot& known, const Catalog&, int axis) {
  const AxisState& s = known.axes[axis];
  lua_createtable(L, 0, 14);
  set_flag(L, "moving",
           s.activity == Activity::moving || s.activity == Activity::jogging ||
               s.activity == Activity::homing || s.activity == Activity::stopping);
  set_flag(L, "idle", s.activity == Activity::idle);
  set_flag(L, "jogging", s.activity == Activity::jogging);
  set_flag(L, "homing", s.activity == Activity::homing);
  set_flag(L, "stopping", s.activity == Activity::stopping);
  set_flag(L, "limit_minus", s.limit_minus);
  set_flag(L, "limit_plus", s.limit_plus);
  set_flag(L, "home", s.home);
  set_flag(L, "alarm", s.alarm);
  set_flag(L, "enabled", s.enabled);
  set_flag(L, "position_known", s.position_known);
  set_flag(L, "position_doubtful", s.position_doubtful);
  set_word(L, "activity", name_of(s.activity));
  set_word(L, "ended_by", name_of(s.ended_by));
  return 1;
}

int push_whole_status(lua_State* L, const Snapshot& known, const Catalog&, int) {
  lua_createtable(L, 0, 10);
  set_flag(L, "moving", known.any_axis_moving());
  set_word(L, "link", name_of(known.link.state));
  set_word(L, "program", name_of(known.program.run));
  set_whole(L, "program_number", known.program.slot);
  set_whole(L, "program_command", known.program.command);
  set_flag(L, "unsaved_setup", known.unsaved_setup);
  set_flag(L, "unsaved_programs", known.unsaved_programs);
  set_word(L, "notice", known.notice.view());
  set_word(L, "firmware", known.identity.firmware.view());
  return 1;
}

constexpr Duration short_look = Millis(20), long_look = Millis(200);
constexpr std::int64_t enough_steps = 50;  // fewer say little: one step more or less is then a few percent

// Measured: steps between two rounds of status over the time between them. At rest 0 at once.
Task<Answer> measure_velocity(Runner& runner, SessionPtr session, int axis) {
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
  if (link.state == LinkState::lost || link.state == LinkState::closed)
    co_return answer_refused(why_unknown(link));
  co_return [speed](lua_State* L) {
    lua_pushnumber(L, speed);
    return 1;
  };
}
int velocity(Call& call) {
  const OneAxis one = one_axis(call, 1, "velocity");
  if (one.index < 0) return call.refuse(one.refusal);
  return call.wait(measure_velocity(call.runner(), one.session, one.index));
}

int position(Call& call) { return of_axis(call, push_position); }
int encoder(Call& call) { return of_axis(call, push_encoder); }
int status(Call& call) {
  if (!call.has(1)) return ask(call, push_whole_status, 0);
  return of_axis(call, push_axis_status);
}

// ---- inputs and outputs, by the maker's number from 1

// nullopt in words: "There is no input 9. VXM has 1 to 4."
std::string no_such(const Catalog& catalog, const char* what, std::int64_t number, std::size_t count) {
  return count == 0
             ? fmt::format("{} has no {}s.", catalog.short_name, what)
             : fmt::format("There is no {} {}. {} has 1 to {}.", what, number, catalog.short_name, count);
}
bool within(std::int64_t number, std::size_t count) {
  return number >= 1 && number <= static_cast<std::int64_t>(count);
}

int push_input(lua_State* L, const Snapshot& known, const Catalog& catalog, int number) {
  const std::uint32_t bit = 1u << (number - 1);
  if (!(known.inputs_known & bit)) return push_unknown(L, fmt::format("Input {} has not been read.", number));
  const bool high = known.inputs & bit;
  lua_pushboolean(L, high != catalog.inputs[number - 1].active_low);
  return 1;
}
int input(Call& call) {
  const Catalog& catalog = session_of(call)->catalog();
  const std::int64_t n = call.whole(1, "input");
  if (!within(n, catalog.inputs.size()))
    return call.refuse(no_such(catalog, "input", n, catalog.inputs.size()));
  return ask(call, push_input, static_cast<int>(n));
}

int push_output(lua_State* L, const Snapshot& known, const Catalog&, int number) {
  const std::uint32_t bit = 1u << (number - 1);
  if (!(known.outputs_known & bit))
    return push_unknown(L, fmt::format("Output {} has not been read.", number));
  lua_pushboolean(L, (known.outputs & bit) != 0);
  return 1;
}
int output(Call& call) {
  const Catalog& catalog = session_of(call)->catalog();
  const std::int64_t n = call.whole(1, "output");
  if (!within(n, catalog.outputs.size()))
    return call.refuse(no_such(catalog, "output", n, catalog.outputs.size()));
  if (!call.has(2)) return ask(call, push_output, static_cast<int>(n));
  return perform(call, intent::SetOutput(static_cast<int>(n), call.on(2, "on")));
}

int push_analog(lua_State* L, const Snapshot& known, const Catalog&, int number) {
  if (!(known.analog_known & (1u << (number - 1))))
    return push_unknown(L, fmt::format("Analog input {} has not been read.", number));
  lua_pushinteger(L, known.analog[number - 1]);
  return 1;
}
int analog(Call& call) {
  const Catalog& catalog = session_of(call)->catalog();
  const std::int64_t n = call.whole(1, "analog input");
  if (!within(n, catalog.analog.size()))
    return call.refuse(no_such(catalog, "analog input", n, catalog.analog.size()));
  return ask(call, push_analog, static_cast<int>(n));
}

// ---- parameters

std::string no_param(const Catalog& catalog, const std::string& name) {
  return fmt::format("{} has no parameter \"{}\".", catalog.short_name, name);
}

// As the maker writes it: 0.8, "4EX07".
std::int64_t unit_of(const ParamInfo& info) {
  std::int64_t unit = 1;
  for (int i = 0; i < info.decimals; ++i) unit *= 10;
  return unit;
}
void push_value(lua_State* L, const ParamInfo& info, std::int64_t value) {
  if (!info.prefix.empty())
    lua_pushstring(L, fmt::format("{}{:0{}}", info.prefix, value, info.digits).c_str());
  else if (info.decimals > 0)
    lua_pushnumber(L, static_cast<double>(value) / static_cast<double>(unit_of(info)));
  else
    lua_pushinteger(L, value);
}
std::int64_t value_of(const Call& call, int argument, const ParamInfo& info) {
  if (!info.prefix.empty() && call.is_text(argument)) {
    const std::string text = call.text(argument, "value");
    char* end = nullptr;
    const bool named = text.starts_with(info.prefix) && text.size() > info.prefix.size();
    const long long number = named ? std::strtoll(text.c_str() + info.prefix.size(), &end, 10) : 0;
    if (!named || *end != 0) throw Misuse(fmt::format("the value must read like {}01", info.prefix));
    return number;
  }
  if (info.decimals > 0)
    return std::llround(call.number(argument, "value") * static_cast<double>(unit_of(info)));
  return call.whole(argument, "value");
}

Task<Answer> get_param(SessionPtr session, int index) {
  const ParamInfo& info = session->catalog().params[index];
  if (info.readable) {
    IntentBody ask = intent::ReadParams(info.mnemonic);
    const auto read = co_await session->perform(std::move(ask));
    if (!read) co_return answer_refused(read.error().sentence());
  }
  const ParamState state = session->known().params[index];
  if (!state.known)
    co_return answer_refused(fmt::format("{} cannot be read from this controller.", info.mnemonic));
  co_return [state, &info](lua_State* L) {
    push_value(L, info, state.value);
    return 1;
  };
}
int get(Call& call) {
  const std::string name = call.text(1, "parameter");
  const int index = session_of(call)->catalog().find_param(name);
  if (index < 0) return call.refuse(no_param(session_of(call)->catalog(), name));
  return call.wait(get_param(session_of(call), index));
}

// A script says what it means: it confirms what the console would ask a person.
int set(Call& call) {
  const std::string name = call.text(1, "parameter");
  const Catalog& catalog = session_of(call)->catalog();
  const int index = catalog.find_param(name);
  if (index < 0) return call.refuse(no_param(catalog, name));
  const ParamInfo& info = catalog.params[static_cast<std::size_t>(index)];
  return perform(call, intent::SetParam(name, value_of(call, 2, info), true));
}

// ---- stored programs

int selected(const SessionPtr& session) { return std::max<int>(0, session->known().program.slot); }

// Where programs run at once, their number is that of the thread.
int programs_of(const Catalog& catalog) { return std::max(catalog.program.slots, catalog.program.threads); }

int slot_of(const Call& call, int argument) {
  const SessionPtr& session = session_of(call);
  if (!call.has(argument)) return selected(session);
  const std::int64_t n = call.whole(argument, "program");
  return n >= 0 && n < programs_of(session->catalog()) ? static_cast<int>(n) : -1;
}
std::string no_slot(const Catalog& catalog) {
  return fmt::format("There is no such program. {} has 0 to {}.", catalog.short_name,
                     programs_of(catalog) - 1);
}

int load(Call& call) {
  std::string text = call.text(1, "text");
  const int slot = slot_of(call, 2);
  if (slot < 0) return call.refuse(no_slot(session_of(call)->catalog()));
  return perform(call, intent::LoadProgram(slot, std::move(text)));
}
int run(Call& call) {
  const int slot = slot_of(call, 1);
  if (slot < 0) return call.refuse(no_slot(session_of(call)->catalog()));
  return perform(call, intent::RunProgram(slot));
}

// With a number: that thread only, where programs run in several.
template <class Verb>
int of_thread(Call& call) {
  const int threads = session_of(call)->catalog().program.threads;
  if (!call.has(1)) return perform(call, Verb());
  const std::int64_t thread = call.whole(1, "thread");
  if (thread < 0 || thread >= threads)
    return call.refuse(
        threads == 0 ? fmt::format("{} runs one program at a time.", session_of(call)->catalog().short_name)
                     : fmt::format("There is no thread {}. {} has 0 to {}.", thread,
                                   session_of(call)->catalog().short_name, threads - 1));
  return perform(call, Verb(static_cast<int>(thread)));
}

Task<Answer> upload(SessionPtr session, int slot) {
  auto listing = co_await session->listing(slot);
  if (!listing) co_return answer_refused(listing.error().sentence());
  co_return answer_text(std::move(*listing));
}
int program(Call& call) {
  const int slot = slot_of(call, 1);
  if (slot < 0) return call.refuse(no_slot(session_of(call)->catalog()));
  return call.wait(upload(session_of(call), slot));
}

constexpr Function methods[] = {
    {"send", send},
    {"query", query},
    {"read", read},
    {"move_to", move<intent::MoveTo>},
    {"move_by", move<intent::MoveBy>},
    {"jog", jog},
    {"home", home},
    {"stop", stop<intent::Stop>},
    {"abort", stop<intent::Abort>},
    {"wait", wait},
    {"position", position},
    {"encoder", encoder},
    {"velocity", velocity},
    {"status", status},
    {"input", input},
    {"output", output},
    {"analog", analog},
    {"get", get},
    {"set", set},
    {"load", load},
    {"run", run},
    {"pause", of_thread<intent::Pause>},
    {"resume", of_thread<intent::Resume>},
    {"halt", of_thread<intent::HaltProgram>},
    {"program", program},
};

}  // namespace

void bind_controller(lua_State* L) {
  luaL_newmetatable(L, controller_type);
  push_functions(L, std::begin(methods), std::end(methods), 1);
  lua_pushcclosure(L, index_handle, 1);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, drop_handle);
  lua_setfield(L, -2, "__gc");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_pop(L, 1);
}

}  // namespace hw::script
