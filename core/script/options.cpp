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
    throw Misuse(fmt::format("{}: argument {} (options) must be a table like {{{}=...}}, not {}", function,
                             argument, known.front(), call.type_of(argument)));
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

std::optional<double> Options::above_zero(const char* key, const char* unit) const {
  const int kind = push(key);
  const double value = kind == LUA_TNUMBER ? lua_tonumber(L_, -1) : 0;
  lua_pop(L_, 1);
  if (kind == LUA_TNIL) return {};
  if (kind != LUA_TNUMBER || !std::isfinite(value) || value <= 0)
    throw Misuse(fmt::format("{}: the {} must be a number above 0, in {}", function_, key, unit));
  return value;
}

Pps Options::speed(double steps_per_unit) const {
  const char* unit = steps_per_unit == 1 ? "steps/s" : "units/s";
  return Pps(above_zero("speed", unit).value_or(0) * std::abs(steps_per_unit));
}

Acceleration Options::acceleration() const {
  const int kind = push("acceleration");
  int whole = 0;
  const lua_Integer value = lua_tointegerx(L_, -1, &whole);
  lua_pop(L_, 1);
  if (kind == LUA_TNIL) return {};
  if (kind != LUA_TNUMBER || !whole)
    throw Misuse(
        fmt::format("{}: the acceleration must be a whole number, in the controller's own unit", function_));
  return value;
}

Counting Options::counting() const {
  const int kind = push("unit");
  const bool on = lua_toboolean(L_, -1);
  lua_pop(L_, 1);
  if (kind != LUA_TNIL && kind != LUA_TBOOLEAN)
    throw Misuse(fmt::format(
        "{}: the option unit must be true or false: with true it counts in the units of c:units(axis)",
        function_));
  return Counting(on);
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
