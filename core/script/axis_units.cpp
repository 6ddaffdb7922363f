#include "core/script/axis_units.h"

#include <cmath>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/script/bind.h"

namespace hw::script {

void AxisUnits::set(const std::shared_ptr<Session>& session, int axis, AxisUnit unit) {
  set_by_script_[session][ix(axis)] = std::move(unit);
}

std::optional<AxisUnit> AxisUnits::find(const std::shared_ptr<Session>& session, int axis) const {
  const auto found = set_by_script_.find(session);
  if (found != set_by_script_.end() && found->second[ix(axis)]) return found->second[ix(axis)];
  return kept ? kept(*session, axis) : std::nullopt;
}

double Counting::steps_per_unit(const Call& call, const OneAxis& one) const {
  if (!in_units_) return 1;
  if (const auto unit = call.runner().notes().units.find(one.session, one.index)) return unit->steps_per_unit;
  throw Misuse(fmt::format(
      "{}: axis {} has no unit yet: set it first, c:units(axis, {{unit=\"mm\", steps_per_unit=400}})",
      call.function(), one.session->catalog().axes[ix(one.index)].name));
}

double Counting::common_to(const Call& call, const std::vector<OneAxis>& axes) const {
  std::optional<double> common;
  for (const OneAxis& one : axes) {
    const double steps = std::abs(steps_per_unit(call, one));
    if (common && *common != steps)
      throw Misuse(
          fmt::format("{}: a speed in units needs axes of one unit: give it in steps/s, without unit=true",
                      call.function()));
    common = steps;
  }
  return common.value_or(1);
}

void push_steps(lua_State* L, Steps steps, double per_unit) {
  if (per_unit == 0)
    lua_pushinteger(L, steps.value);
  else
    lua_pushnumber(L, static_cast<double>(steps.value) / per_unit);
}

static std::string value_at(lua_State* L, int place) {
  if (lua_type(L, place) == LUA_TNUMBER) return fmt::format("{:g}", lua_tonumber(L, place));
  return lua_isnoneornil(L, place) ? "nil" : fmt::format("a {}", luaL_typename(L, place));
}

static const char* hint_of(lua_State* L, int place) {
  if (lua_type(L, place) != LUA_TNUMBER) return "";
  return ": round it, or set a unit with c:units() and add {unit=true}";
}

Steps Counting::steps(const Call& call, int place, const OneAxis& one, const char* what) const {
  int is_whole = 0;
  const lua_Integer whole = lua_tointegerx(call.L, place, &is_whole);
  if (!in_units_) {
    if (is_whole) return Steps(whole);  // a string of digits too, as hw.args are
    throw Misuse(fmt::format("{}: {} must be a whole number of steps, not {}{}", call.function(), what,
                             value_at(call.L, place), hint_of(call.L, place)));
  }
  const double steps = lua_tonumber(call.L, place) * steps_per_unit(call, one);
  if (lua_type(call.L, place) != LUA_TNUMBER || !(std::abs(steps) <= countable))
    throw Misuse(fmt::format("{}: {} must be a number of units, not {}", call.function(), what,
                             value_at(call.L, place)));
  return Steps(std::llround(steps));
}

}  // namespace hw::script
