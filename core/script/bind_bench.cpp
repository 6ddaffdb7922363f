// `c.bench`: operates an emulated controller. A refusal by the bench is an error at the script's line: a test
// that goes on without its limit switch proves nothing.
#include <cmath>

#include <fmt/core.h>

#include "core/emulation/bench_file.h"
#include "core/emulation/emulator.h"
#include "core/script/bind.h"

namespace hw::script {
namespace {

BenchAccess& bench_of(const Call& call) {
  const auto& bench = session_of(call)->bench();
  if (!bench)
    throw Misuse(fmt::format("{} is not an emulator in this process, so it has no bench",
                             session_of(call)->address().text()));
  return *bench;
}

int operate(Call& call, const BenchCommand& command) {
  const auto done = bench_of(call).operate(command);
  if (!done) throw Misuse("bench: " + done.error().sentence());
  return call.yes();
}

AxisId axis_of(const Call& call) {
  const Catalog& catalog = session_of(call)->catalog();
  const int index = axis_index(call.L, call.place(1), catalog, "bench");
  if (index < 0) throw Misuse(fmt::format("bench: {} has no such axis", catalog.short_name));
  return AxisId{static_cast<std::uint8_t>(index)};
}

int small(const Call& call, int argument, const char* what) {
  const std::int64_t value = call.whole(argument, what);
  if (value < -1'000'000'000 || value > 1'000'000'000)
    throw Misuse(fmt::format("bench: {} is too large", what));
  return static_cast<int>(value);
}

/// Converts the maker's number; the bench counts from 1.
int bench_input(Call& call) {
  const int number = small(call, 1, "input");
  const int place = session_of(call)->catalog().find_input(number);
  return operate(call, bench::Input(place < 0 ? number : place + 1, call.on(2, "on")));
}

int limit(Call& call) {
  const std::string side = call.text(2, "side");
  if (side != "+" && side != "-") throw Misuse("bench: the side of a limit switch is \"+\" or \"-\"");
  return operate(call, bench::Limit(axis_of(call), side == "+" ? Sign::plus : Sign::minus, call.on(3, "on")));
}

int bench_home(Call& call) { return operate(call, bench::HomeSwitch(axis_of(call), call.on(2, "on"))); }
int bench_analog(Call& call) {
  return operate(call, bench::Analog(small(call, 1, "analog input"), small(call, 2, "value")));
}
int button(Call& call) { return operate(call, bench::Button(call.text(1, "button"), call.on(2, "on"))); }
int jam(Call& call) { return operate(call, bench::Jam(axis_of(call), call.on(2, "on"))); }
int alarm(Call& call) { return operate(call, bench::Alarm(axis_of(call), call.on(2, "on"))); }
int slip(Call& call) { return operate(call, bench::Slip(axis_of(call), Steps(small(call, 2, "counts")))); }
int unplug(Call& call) { return operate(call, bench::Unplug(call.on(1, "on"))); }
int garble(Call& call) { return operate(call, bench::Garble(small(call, 1, "bytes"))); }
int drop(Call& call) { return operate(call, bench::Drop(small(call, 1, "bytes"))); }
/// By the bench's name ("Slave"); absent: the first, the device's own.
int supply_of(const Call& call, int argument) {
  if (!call.has(argument)) return 0;
  const std::string name = call.text(argument, "name of a supply");
  const auto& supplies = session_of(call)->catalog().bench.supplies;
  for (std::size_t i = 0; i < supplies.size(); ++i)
    if (supplies[i].name == name) return static_cast<int>(i);
  throw Misuse(fmt::format("bench: there is no supply \"{}\"", name));
}

/// Without a name: all supplies.
int power(Call& call) {
  return operate(call, bench::Power(call.on(1, "on"), call.has(2) ? supply_of(call, 2) : -1));
}
int breaker(Call& call) { return operate(call, bench::Breaker(supply_of(call, 2), call.on(1, "out"))); }
int power_cycle(Call& call) { return operate(call, bench::PowerCycle()); }

// at(t, fn): t on the clock of hw.now(); a past time runs at once.
int at(Call& call) {
  const double t = call.number(1, "time");
  if (!lua_isfunction(call.L, call.place(2))) throw Misuse("bench:at: argument 2 must be a function");
  if (std::abs(t) > 1e9) throw Misuse("bench:at: the time is too far away");
  Runner& runner = call.runner();
  lua_pushvalue(call.L, call.place(2));
  runner.run_at(call.L, runner.began() + from_seconds(t));
  return call.nothing();
}

// ---- place(axis, {minus=, plus=, home={from, to}, ...}): the keys of a bench file's [axis.N]

/// By raw access: no __index of the script may run here.
int raw_field(lua_State* L, int table, const char* key) {
  lua_pushstring(L, key);
  return lua_rawget(L, table);
}

std::optional<Steps> steps(lua_State* L, int table, const char* key) {
  raw_field(L, table, key);
  int whole = 0;
  const lua_Integer value = lua_tointegerx(L, -1, &whole);
  const bool absent = lua_isnil(L, -1);
  lua_pop(L, 1);
  if (absent) return {};
  if (!whole) throw Misuse(fmt::format("bench:place: {} must be a whole number", key));
  return Steps(value);
}

void read_home(lua_State* L, int table, AxisPlace& place) {
  raw_field(L, table, "home");
  if (!lua_isnil(L, -1)) {
    int ok_from = 0, ok_to = 0;
    if (lua_istable(L, -1)) {
      lua_rawgeti(L, -1, 1);
      lua_rawgeti(L, -2, 2);
      place.home_from = Steps(lua_tointegerx(L, -2, &ok_from));
      place.home_to = Steps(lua_tointegerx(L, -1, &ok_to));
      lua_pop(L, 2);
    }
    if (!ok_from || !ok_to) throw Misuse("bench:place: home must be {from, to}");
  }
  lua_pop(L, 1);
}

/// motor = true, false, or a table of differences from the motor of core/motion/motor.h.
void read_motor(lua_State* L, int table, AxisPlace& place) {
  const int kind = raw_field(L, table, "motor");
  if (kind != LUA_TNIL) place.motor.emplace();
  if (kind == LUA_TBOOLEAN) place.motor->present = lua_toboolean(L, -1) != 0;
  if (kind == LUA_TTABLE) {
    lua_pushnil(L);
    while (lua_next(L, -2)) {
      const std::string_view key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "(no text)";
      const auto known = std::find_if(motor_keys.begin(), motor_keys.end(),
                                      [&](const MotorKey& k) { return k.name == key; });
      if (known == motor_keys.end()) throw Misuse(fmt::format("bench:place: a motor has no \"{}\"", key));
      const double value = lua_type(L, -1) == LUA_TNUMBER ? lua_tonumber(L, -1) : NAN;
      if (!(value >= known->low && value <= known->high))
        throw Misuse(
            fmt::format("bench:place: {} must be a number from {} to {}", key, known->low, known->high));
      *place.motor.*known->value = value;
      lua_pop(L, 1);
    }
  }
  lua_pop(L, 1);
  if (kind != LUA_TNIL && kind != LUA_TBOOLEAN && kind != LUA_TTABLE)
    throw Misuse("bench:place: motor must be true, false or a table");
}

void refuse_unknown_keys(lua_State* L, int table) {
  static constexpr std::string_view known[] = {
      "minus", "plus", "home", "index_every", "counts_per_step", "backlash", "scatter", "seed", "motor"};
  lua_pushnil(L);
  while (lua_next(L, table)) {
    lua_pop(L, 1);
    const std::string_view key = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "(no text)";
    if (std::find(std::begin(known), std::end(known), key) == std::end(known))
      throw Misuse(
          fmt::format("bench:place: a place has no \"{}\"; known keys: minus, plus, home, index_every, "
                      "counts_per_step, backlash, scatter, seed, motor",
                      key));
  }
}

int place(Call& call) {
  const int table = call.place(2);
  if (!lua_istable(call.L, table)) throw Misuse("bench:place: argument 2 must be a table like {plus=90000}");
  refuse_unknown_keys(call.L, table);
  AxisPlace place;
  place.minus = steps(call.L, table, "minus");
  place.plus = steps(call.L, table, "plus");
  place.index_every = steps(call.L, table, "index_every");
  place.backlash = steps(call.L, table, "backlash");
  place.scatter = steps(call.L, table, "scatter");
  if (const auto seed = steps(call.L, table, "seed")) place.seed = seed->value;
  read_home(call.L, table, place);
  read_motor(call.L, table, place);
  if (raw_field(call.L, table, "counts_per_step") != LUA_TNIL) {
    if (lua_type(call.L, -1) != LUA_TNUMBER) throw Misuse("bench:place: counts_per_step must be a number");
    place.counts_per_step = lua_tonumber(call.L, -1);
  }
  lua_pop(call.L, 1);
  if (const auto problem = problem_of(place); !problem.empty())
    throw Misuse("bench:place: " + std::string(problem));
  return operate(call, bench::Place(axis_of(call), place));
}

// ---- looking

void push_positions(lua_State* L, const std::array<Steps, max_axes>& all, std::size_t count) {
  lua_createtable(L, static_cast<int>(count), 0);
  for (std::size_t i = 0; i < count; ++i) {
    lua_pushinteger(L, all[i].value);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
}

// The pulses so far, oldest first: {t=, output=, width=, position={...}}.
int pulses(Call& call) {
  lua_State* L = call.L;
  const auto& all = bench_of(call).emulator().pulses();
  const std::size_t axes = session_of(call)->catalog().axes.size();
  lua_createtable(L, static_cast<int>(all.size()), 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    lua_createtable(L, 0, 4);
    lua_pushnumber(L, seconds(all[i].at));
    lua_setfield(L, -2, "t");
    lua_pushinteger(L, all[i].output);
    lua_setfield(L, -2, "output");
    lua_pushnumber(L, seconds(all[i].width));
    lua_setfield(L, -2, "width");
    push_positions(L, all[i].position, axes);
    lua_setfield(L, -2, "position");
    lua_rawseti(L, -2, static_cast<lua_Integer>(i + 1));
  }
  return 1;
}

// A set of bits as {name=true/false}.
template <class Named>
void set_bits(lua_State* L, const char* field, const std::vector<Named>& named, std::uint32_t bits) {
  lua_createtable(L, 0, static_cast<int>(named.size()));
  for (std::size_t i = 0; i < named.size(); ++i) {
    lua_pushboolean(L, (bits >> i) & 1u);
    lua_setfield(L, -2, named[i].name.c_str());
  }
  lua_setfield(L, -2, field);
}

// look(): {powered=, unplugged=, lamps={Power=true ...}, buttons={...}, load={...}}.
int look(Call& call) {
  lua_State* L = call.L;
  BenchView view;
  bench_of(call).look(view);
  const Catalog& catalog = session_of(call)->catalog();
  lua_createtable(L, 0, 6);
  lua_pushboolean(L, view.powered);
  lua_setfield(L, -2, "powered");
  lua_pushboolean(L, view.unplugged);
  lua_setfield(L, -2, "unplugged");
  set_bits(L, "lamps", catalog.bench.lamps, view.lamps);
  set_bits(L, "buttons", catalog.bench.buttons, view.buttons);
  push_positions(L, view.load_position, catalog.axes.size());
  lua_setfield(L, -2, "load");
  return 1;
}

constexpr Function bench_methods[] = {
    {"input", bench_input},       {"limit", limit},     {"home", bench_home}, {"analog", bench_analog},
    {"button", button},           {"jam", jam},         {"alarm", alarm},     {"slip", slip},
    {"unplug", unplug},           {"garble", garble},   {"drop", drop},       {"power", power},
    {"power_cycle", power_cycle}, {"breaker", breaker}, {"at", at},           {"place", place},
    {"pulses", pulses},           {"look", look},
};

}  // namespace

void bind_bench(lua_State* L) {
  luaL_newmetatable(L, bench_type);
  push_functions(L, std::begin(bench_methods), std::end(bench_methods), 1);
  lua_setfield(L, -2, "__index");
  close_handle_type(L);
}

}  // namespace hw::script
