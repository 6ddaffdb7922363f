#include "core/script/call.h"

#include <cmath>

#include <fmt/core.h>

#include "core/base/log.h"
#include "core/script/bind.h"

namespace hw::script {

const char* Call::type_of(int argument) const {
  return lua_isnoneornil(L, place(argument)) ? "nil" : luaL_typename(L, place(argument));
}

std::string Call::given(int argument) const {
  if (lua_type(L, place(argument)) != LUA_TNUMBER) return type_of(argument);
  const double number = lua_tonumber(L, place(argument));
  return std::isnan(number) ? "nan" : fmt::format("{:g}", number);
}

void Call::wrong(int argument, const char* what, const char* wanted) const {
  throw Misuse(fmt::format("{}: argument {} ({}) must be {}, not {}", function_, argument, what, wanted,
                           given(argument)));
}

std::string Call::text(int argument, const char* what) const {
  if (lua_type(L, place(argument)) != LUA_TSTRING && lua_type(L, place(argument)) != LUA_TNUMBER)
    wrong(argument, what, "a text");
  std::size_t length = 0;
  lua_pushvalue(L, place(argument));  // conversion must not change the script's value
  const char* bytes = lua_tolstring(L, -1, &length);
  std::string copy(bytes, length);
  lua_pop(L, 1);
  return copy;
}

double Call::number(int argument, const char* what) const {
  if (lua_type(L, place(argument)) != LUA_TNUMBER) wrong(argument, what, "a number");
  const double value = lua_tonumber(L, place(argument));
  if (!std::isfinite(value)) wrong(argument, what, "a finite number");
  return value;
}

std::int64_t Call::whole(int argument, const char* what) const {
  int is_whole = 0;
  const lua_Integer value = lua_tointegerx(L, place(argument), &is_whole);
  if (lua_type(L, place(argument)) != LUA_TNUMBER || !is_whole) wrong(argument, what, "a whole number");
  return value;
}

bool Call::on(int argument, const char* what) const {
  if (lua_isnone(L, place(argument))) return true;
  if (lua_type(L, place(argument)) == LUA_TNUMBER) return whole(argument, what) != 0;
  if (!lua_isboolean(L, place(argument))) wrong(argument, what, "true or false");
  return lua_toboolean(L, place(argument));
}

Duration Call::patience(int argument, double fallback_s) const {
  const double s = has(argument) ? number(argument, "seconds") : fallback_s;
  if (s < 0 || s > 1e6) wrong(argument, "seconds", "from 0 to a million seconds");
  return from_seconds(s);
}

int Call::yes() {
  lua_pushboolean(L, 1);
  return 1;
}

static const char* word_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::refused: return "refused";
    case FaultKind::asks: return "asks";
    case FaultKind::no_answer: return "no_answer";
    case FaultKind::garbled: return "garbled";
    case FaultKind::controller: return "controller";
    case FaultKind::stopped: return "stopped";
    case FaultKind::lost: return "lost";
    case FaultKind::port: return "port";
    case FaultKind::text: return "text";
    case FaultKind::internal: break;
  }
  return "internal";
}

// Printing a refusal shows its kind, not its address, so that a replay is identical.
static int refusal_as_text(lua_State* L) {
  if (!lua_istable(L, 1)) return 0;
  lua_pushliteral(L, "kind");
  lua_rawget(L, 1);
  if (lua_type(L, -1) != LUA_TSTRING) lua_pushliteral(L, "refusal");
  return 1;
}

int push_refusal(lua_State* L, Refusal refusal) {
  static const log::Subject& log = log::subject("script");
  name_device(L, refusal);
  luaL_where(L, 1);
  log.debug("{}refused ({}): {}", lua_tostring(L, -1), refusal.too_late ? "timeout" : word_of(refusal.kind),
            refusal.reason);
  Runner::of(L).notes().advice.refused(lua_tostring(L, -1), refusal.reason);
  lua_pop(L, 1);
  lua_pushnil(L);
  lua_pushlstring(L, refusal.reason.data(), refusal.reason.size());
  lua_createtable(L, 0, 4);
  const auto set = [L](const char* key, std::string_view text) {
    if (text.empty()) return;
    lua_pushlstring(L, text.data(), text.size());
    lua_setfield(L, -2, key);
  };
  set("kind", refusal.too_late ? "timeout" : word_of(refusal.kind));
  set("axis", refusal.axis);
  set("device", refusal.device);
  set("what_to_do", refusal.what_to_do);
  if (luaL_newmetatable(L, "refusal")) {
    lua_pushcfunction(L, refusal_as_text);
    lua_setfield(L, -2, "__tostring");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
  }
  lua_setmetatable(L, -2);
  return 3;
}

Refusal refusal_of(const Fault& fault) { return {fault.sentence(), fault.kind, {}, {}, fault.advice}; }

Refusal too_late(Refusal refusal) {
  refusal.too_late = true;
  refusal.what_to_do = "Wait longer, or stop it.";
  return refusal;
}

void forget_mended_refusal(lua_State* L, int results) {
  LuaAdvice& advice = Runner::of(L).notes().advice;
  if (results <= 0 || !advice.knows_refusal() || lua_isnil(L, -results)) return;
  luaL_where(L, 1);
  advice.went_well(lua_tostring(L, -1));
  lua_pop(L, 1);
}

int Call::refuse(std::string_view reason) { return push_refusal(L, Refusal{std::string(reason)}); }

int Call::wait(Task<Answer> work) {
  if (const char* why = runner().why_cannot_wait(L)) throw Misuse(fmt::format("{}: {}", function_, why));
  runner().wait_for(L, std::move(work));
  return waits;
}

int Call::wait_for_act(std::function<Answer()> act) {
  if (const char* why = runner().why_cannot_wait(L)) throw Misuse(fmt::format("{}: {}", function_, why));
  runner().act_between_turns(L, std::move(act));
  return waits;
}

// ---- between Lua and the bodies

int resume_with_answer(lua_State* L, int status, std::ptrdiff_t context);

// All C++ objects live and die in here. After misuse the message is on the stack.
static int call_body(lua_State* L) {
  const auto* function = static_cast<const Function*>(lua_touserdata(L, lua_upvalueindex(1)));
  const int self = static_cast<int>(lua_tointeger(L, lua_upvalueindex(2)));
  const WayOut::Closed closed(Runner::of(L).way_out());
  try {
    Call call(L, function->name, self);
    return function->body(call);
  } catch (const std::exception& e) {
    luaL_where(L, 1);
    lua_pushstring(L, e.what());
    lua_concat(L, 2);
    return Call::misused;
  }
}

// Runs script code, which may never return or raise an error: no C++ object may live here.
static void make_texts(lua_State* L) {
  for (int i = 1, n = lua_gettop(L); i <= n; ++i) {
    luaL_tolstring(L, i, nullptr);
    lua_replace(L, i);
  }
}

static int enter(lua_State* L) {
  Runner::of(L).way_out().open();
  if (static_cast<const Function*>(lua_touserdata(L, lua_upvalueindex(1)))->texts) make_texts(L);
  const int results = call_body(L);
  if (results == Call::misused) return lua_error(L);
  if (results == Call::waits) return lua_yieldk(L, 0, 0, resume_with_answer);
  forget_mended_refusal(L, results);
  return results;
}

void add_functions(lua_State* L, std::span<const Function> functions, int self) {
  for (const Function& f : functions) {
    lua_pushlightuserdata(L, const_cast<Function*>(&f));
    lua_pushinteger(L, self);
    lua_pushcclosure(L, enter, 2);
    lua_setfield(L, -2, f.name);
  }
}

void push_functions(lua_State* L, const Function* first, const Function* last, int self) {
  lua_createtable(L, 0, static_cast<int>(last - first));
  add_functions(L, {first, last}, self);
}

Answer answer_yes() {
  return [](lua_State* L) {
    lua_pushboolean(L, 1);
    return 1;
  };
}
Answer answer_refused(std::string reason) { return answer_refused(Refusal{std::move(reason)}); }
Answer answer_refused(Refusal refusal) {
  return [refusal = std::move(refusal)](lua_State* L) { return push_refusal(L, refusal); };
}
Answer answer_refused(const Fault& fault) { return answer_refused(refusal_of(fault)); }
Answer answer_text(std::string text) {
  return [text = std::move(text)](lua_State* L) {
    lua_pushlstring(L, text.data(), text.size());
    return 1;
  };
}
Answer answer_error(std::string sentence) {
  return [sentence = std::move(sentence)](lua_State* L) {
    luaL_where(L, 1);
    lua_pushlstring(L, sentence.data(), sentence.size());
    lua_concat(L, 2);
    return Call::misused;
  };
}
Answer answer_of(const Result<>& result) { return result ? answer_yes() : answer_refused(result.error()); }

}  // namespace hw::script
