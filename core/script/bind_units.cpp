// c:units: the unit of an axis, and its size in steps.
#include <fmt/format.h>

#include "core/base/index.h"
#include "core/script/bind.h"
#include "core/script/options.h"

namespace hw::script {
namespace {

int push_unit(lua_State* L, const std::string& name, double steps_per_unit) {
  lua_createtable(L, 0, 2);
  lua_pushlstring(L, name.data(), name.size());
  lua_setfield(L, -2, "unit");
  lua_pushnumber(L, steps_per_unit);
  lua_setfield(L, -2, "steps_per_unit");
  return 1;
}

/// The script's unit, else the console's, else steps.
int units(Call& call) {
  const OneAxis one = one_axis(call, 1, "units");
  if (one.index < 0) return call.refuse(one.refusal);
  AxisUnits& of_script = call.runner().notes().units;
  if (!call.has(2)) {
    if (const auto unit = of_script.find(one.session, one.index))
      return push_unit(call.L, unit->name, unit->steps_per_unit);
    return push_unit(call.L, one.session->catalog().step_word, 1);
  }
  const Options options(call, 2, "units", {"unit", "steps_per_unit"});
  const auto name = options.text("unit");
  const auto steps = options.above_zero("steps_per_unit", "steps");
  if (!name || name->empty() || !steps)
    throw Misuse("units: give both, as in {unit=\"mm\", steps_per_unit=400}");
  of_script.set(one.session, one.index, {*name, *steps});
  return call.yes();
}

constexpr Function units_table[] = {{"units", units}};

}  // namespace

std::span<const Function> unit_methods() { return units_table; }

}  // namespace hw::script
