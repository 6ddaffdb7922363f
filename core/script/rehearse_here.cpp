#include "core/script/rehearse_here.h"

#include <algorithm>
#include <map>

#include "core/base/index.h"
#include "core/device/controller_state.h"

namespace hw::script {
namespace {

void put(lua_State* L, const char* name, std::string_view word) {
  lua_pushlstring(L, word.data(), word.size());
  lua_setfield(L, -2, name);
}
void put(lua_State* L, const char* name, double number) {
  lua_pushnumber(L, number);
  lua_setfield(L, -2, name);
}
void put(lua_State* L, const char* name, std::int64_t whole) {
  lua_pushinteger(L, whole);
  lua_setfield(L, -2, name);
}
void put(lua_State* L, const char* name, bool on) {
  lua_pushboolean(L, on);
  lua_setfield(L, -2, name);
}

/// Sets a field under a name in script form: 1 is a number, "X" a text.
void put_under(lua_State* L, const std::string& name) {
  const bool number =
      !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (number)
    lua_pushinteger(L, std::stoi(name));
  else
    lua_pushlstring(L, name.data(), name.size());
  lua_insert(L, -2);
  lua_settable(L, -3);
}

void push_axes(lua_State* L, const Rehearsal& r) {
  lua_newtable(L);
  for (const RehearsedAxis& axis : r.axes) {
    lua_createtable(L, 0, 5);
    put(L, "begin", axis.begin), put(L, "position", axis.position), put(L, "travel", axis.travel);
    put(L, "min", axis.minimum), put(L, "max", axis.maximum);
    put_under(L, axis.name);
  }
}

void push_stops(lua_State* L, const Rehearsal& r) {
  lua_newtable(L);
  lua_Integer place = 0;
  for (const RehearsedStop& stop : r.stops) {
    lua_createtable(L, 0, 5);
    put(L, "t", stop.t), put(L, "reason", stop.reason);
    if (stop.line >= 0) put(L, "line", std::int64_t{stop.line} + 1);
    if (stop.direction != 0) put(L, "axis", stop.axis), put(L, "direction", std::int64_t{stop.direction});
    lua_rawseti(L, -2, ++place);
  }
}

int push_rehearsal(lua_State* L, const Rehearsal& r) {
  lua_createtable(L, 0, 12);
  put(L, "duration", r.duration_s), put(L, "finished", r.finished), put(L, "endless", r.endless);
  put(L, "limit_touched", r.limit_touched), put(L, "sent", r.sent_to_host);
  if (!r.error.empty()) put(L, "error", r.error);
  push_axes(L, r);
  lua_setfield(L, -2, "axes");
  push_stops(L, r);
  lua_setfield(L, -2, "stops");
  lua_newtable(L);
  for (const auto& [number, on] : r.outputs) {
    lua_pushboolean(L, on != 0);
    put_under(L, number);
  }
  lua_setfield(L, -2, "outputs");
  lua_newtable(L);
  for (const RehearsedAssumption& a : r.assumptions) put(L, a.name.c_str(), a.value);
  lua_setfield(L, -2, "assumptions");
  return 1;
}

bool knows_all_params(const Session& session) {
  const auto& params = session.catalog().params;
  for (std::size_t i = 0; i < params.size(); ++i)
    if (params[i].readable && !session.known().params[i].known) return false;
  return true;
}

/// Reads the controller's other programs, which this one may call. Unreadable ones stay unknown.
Task<> read_programs(SessionPtr session, int but_slot, std::map<int, std::string>& programs) {
  const int slots = session->catalog().program.slots;
  for (int slot = 0; slots > 1 && slot < slots; ++slot) {
    if (slot == but_slot) continue;
    auto listing = co_await session->listing(slot);
    if (!listing) co_return;
    programs[slot] = std::move(*listing);
  }
}

Result<Rehearsal> rehearse_now(Session& session, const std::string& text, int slot,
                               const std::map<int, std::string>& programs) {
  BenchView bench;
  if (session.bench()) session.bench()->look(bench);
  auto state = std::make_shared<ControllerState>(ControllerState{session.known(), programs});
  RehearseOptions options = rehearse_from(std::move(state), bench, session.catalog());
  options.slot = slot;
  return session.type().language().rehearse(text, options);
}

/// Reads the variables that the program uses before it sets them. False: there are none.
Task<bool> reads_variables(SessionPtr session, const Rehearsal& rehearsal) {
  const VariableFacts& facts = session->catalog().variables;
  bool any = false;
  for (int n = 0; n < facts.count; ++n) {
    const std::string name = facts.prefix + std::to_string(n);
    const bool assumed = std::any_of(rehearsal.assumptions.begin(), rehearsal.assumptions.end(),
                                     [&](const RehearsedAssumption& a) { return a.name == name; });
    if (!assumed) continue;
    (void)co_await session->perform(intent::ReadParams(name));
    any = true;
  }
  co_return any;
}

}  // namespace

Task<Answer> rehearse_here(SessionPtr session, std::string text, int slot) {
  if (!session->type().language) co_return answer_refused("This model has no program language.");
  if (!knows_all_params(*session)) (void)co_await session->perform(intent::ReadParams());
  co_await session->pump().refresh();
  if (!session->known().link.connected())
    co_return answer_refused(std::string(session->known().link.sentence.view()));
  std::map<int, std::string> programs;
  co_await read_programs(session, slot, programs);
  auto done = rehearse_now(*session, text, slot, programs);
  if (done && co_await reads_variables(session, *done)) done = rehearse_now(*session, text, slot, programs);
  if (!done) co_return answer_refused(done.error());
  co_return [result = std::make_shared<Rehearsal>(std::move(*done))](lua_State* L) {
    return push_rehearsal(L, *result);
  };
}

}  // namespace hw::script
