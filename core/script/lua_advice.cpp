#include "core/script/lua_advice.h"

#include <algorithm>
#include <lua.hpp>

#include <fmt/core.h>

#include "core/base/near_name.h"
#include "core/script/bind.h"

namespace hw::script {
namespace {

/// Appends the names in the table on top of the stack, and pops it.
void take_names(lua_State* L, std::vector<std::string>& names) {
  if (lua_istable(L, -1)) {
    lua_pushnil(L);
    while (lua_next(L, -2)) {
      lua_pop(L, 1);
      if (lua_type(L, -1) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -1));
    }
  }
  lua_pop(L, 1);
}

/// Pushes the methods of a type: its __index, or the table that its __index looks them up in.
void push_methods(lua_State* L, const char* type) {
  luaL_getmetatable(L, type);
  if (!lua_istable(L, -1)) return;
  lua_pushliteral(L, "__index");
  lua_rawget(L, -2);
  lua_remove(L, -2);
  if (!lua_isfunction(L, -1) || !lua_getupvalue(L, -1, 1)) return;
  lua_remove(L, -2);
}

/// "(method 'moveto')" -> moveto; empty: the message names nothing of that kind.
std::string_view named(std::string_view message, std::string_view kind) {
  const std::string before = fmt::format("({} '", kind);
  const auto from = message.find(before);
  if (from == message.npos) return {};
  const auto rest = message.substr(from + before.size());
  return rest.substr(0, rest.find("')"));
}

/// Typing errors seldom change the first letter; and "move" may mean one of several names.
std::string likely(std::string_view wanted, const std::vector<std::string>& names) {
  std::vector<std::string> alike;
  std::string begun;
  constexpr std::size_t beginning = 4;
  for (const std::string& name : names) {
    if (name.front() == wanted.front()) alike.push_back(name);
    if (wanted.size() >= beginning && name.starts_with(wanted.substr(0, beginning)))
      begun += (begun.empty() ? "" : ", ") + name;
  }
  std::string meant = did_you_mean(wanted, alike);
  return meant.empty() && !begun.empty() ? fmt::format(" There is {}.", begun) : meant;
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

}  // namespace

void LuaAdvice::learn(lua_State* L) {
  for (const char* type : {controller_type, bench_type, "task"}) {
    push_methods(L, type);
    take_names(L, methods_);
  }
  for (const char* table : {"hw", "ui"}) {
    lua_getglobal(L, table);
    take_names(L, functions_);
  }
  std::sort(methods_.begin(), methods_.end());
  std::sort(functions_.begin(), functions_.end());
}

void LuaAdvice::went_well(std::string_view where) {
  if (where == refused_at_) refused_.clear();
}

void LuaAdvice::refused(std::string where, std::string reason) {
  constexpr std::size_t longest = 1000;
  refused_at_ = where;
  while (where.ends_with(' ') || where.ends_with(':')) where.pop_back();
  if (reason.size() > longest) reason.resize(longest);
  refused_ = fmt::format("A call{}{} returned nil: {}", where.empty() ? "" : " at ", where, reason);
}

std::string LuaAdvice::on(std::string_view message) const {
  if (contains(message, "attempt to call a nil value")) return on_call(message);
  const bool of_nil = contains(message, "a nil value") || contains(message, "with nil") ||
                      contains(message, "compare nil with") || contains(message, "compare two nil values");
  return contains(message, "attempt to ") && of_nil ? on_value(message) : std::string();
}

std::string LuaAdvice::on_call(std::string_view message) const {
  if (const auto method = named(message, "method"); !method.empty()) {
    const std::string meant = likely(method, methods_);
    return meant.empty() ? ". There is no such method: the manual lists them under Scripts." : "." + meant;
  }
  for (const char* kind : {"field", "global"})
    if (const std::string name(named(message, kind)); !name.empty()) {
      const bool in_hw = std::find(functions_.begin(), functions_.end(), name) != functions_.end();
      if (in_hw) return fmt::format(". Did you mean \"hw.{}\"?", name);
      if (std::string meant = likely(name, functions_); !meant.empty()) return "." + meant;
      if (std::find(methods_.begin(), methods_.end(), name) != methods_.end())
        return fmt::format(". A method is called on a controller, with a colon: c:{}(...)", name);
    }
  return {};
}

std::string LuaAdvice::on_value(std::string_view message) const {
  const auto field = named(message, "field");
  if (field == "bench")
    return ". A bus has no bench of its own, but each device has: c.devices[\"01\"].bench";
  if (field == "devices") return ". Only a bus has devices, as dmx-k-sa@emulator,id=01-02.";
  return refused_.empty() ? std::string() : ".\n" + refused_;
}

}  // namespace hw::script
