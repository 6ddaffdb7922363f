#include "core/script/options.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/base/near_name.h"

namespace hw::script {
namespace {

std::string unknown_option(const char* function, const std::string& key,
                           const std::vector<std::string>& known) {
  return fmt::format("{}: there is no option \"{}\". It takes {}.{}", function, key, fmt::join(known, ", "),
                     did_you_mean(key, known));
}

}  // namespace

Options::Options(const Call& call, int argument, const char* function, std::vector<std::string> known)
    : L_(call.L), function_(function), table_(call.has(argument) ? call.place(argument) : 0) {
  if (table_ == 0) return;
  if (!lua_istable(L_, table_))
    throw Misuse(fmt::format("{}: the options must be a table like {{{}=...}}", function, known.front()));
  lua_pushnil(L_);
  while (lua_next(L_, table_)) {
    lua_pop(L_, 1);
    const std::string key = lua_type(L_, -1) == LUA_TSTRING ? lua_tostring(L_, -1) : "(no name)";
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw Misuse(unknown_option(function, key, known));
  }
}

int Options::push(const char* key) const {
  if (table_ == 0) {
    lua_pushnil(L_);
    return LUA_TNIL;
  }
  lua_pushstring(L_, key);
  return lua_rawget(L_, table_);
}

Pps Options::speed() const {
  const int kind = push("speed");
  const double value = kind == LUA_TNUMBER ? lua_tonumber(L_, -1) : 0;
  lua_pop(L_, 1);
  if (kind == LUA_TNIL) return Pps{};
  if (kind != LUA_TNUMBER || !std::isfinite(value) || value <= 0)
    throw Misuse(fmt::format("{}: the speed must be a number above 0, in steps/s", function_));
  return Pps(value);
}

std::optional<std::string> Options::text(const char* key) const {
  const int kind = push(key);
  const bool is_text = kind == LUA_TSTRING;
  std::optional<std::string> value;
  if (is_text) value = lua_tostring(L_, -1);
  lua_pop(L_, 1);
  if (kind != LUA_TNIL && !is_text)
    throw Misuse(fmt::format("{}: the option {} must be a text", function_, key));
  return value;
}

}  // namespace hw::script
