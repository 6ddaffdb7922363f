// What panels, terminal and scripts know of a Twin.
#include "core/device/stopping_way.h"
#include "tests/example/facts.h"
#include "tests/example/twin.h"

namespace hw::twin {
namespace {

ParamInfo param(const Param& fact) {
  const bool ramp = fact.mnemonic[0] == 'R';
  const std::string motor = fact.axis == 0 ? "motor A" : "motor B";
  ParamInfo info;
  info.mnemonic = fact.mnemonic, info.axis = fact.axis, info.group = "Speeds";
  info.minimum = fact.minimum, info.maximum = fact.maximum, info.fallback = fact.factory;
  info.stored = false;
  info.unit = ramp ? "steps/s²" : "steps/s";
  info.label = (ramp ? "Ramp of " : "Speed of ") + motor;
  info.explanation = ramp ? "How fast " + motor + " speeds up and slows down, in each of its motions."
                          : "The speed of each motion of " + motor + " that names no speed of its own.";
  return info;
}

}  // namespace

Result<Catalog> make_catalog(const DeviceOptions&) {
  Catalog c;
  c.model = model, c.name = c.short_name = "Twin", c.summary = "two stepping motors";
  c.axes = {{"A", "axis A"}, {"B", "axis B"}};
  c.homing_modes = {{.id = "limit", .label = "to the limit switch", .only_direction = Sign::minus},
                    {.id = "home", .label = "onto the home switch"}};
  for (const Param& fact : params) c.params.push_back(param(fact));
  c.commands = {{"ID", "ID", "name and version"},
                {"?", "?", "state of both axes"},
                {"G [axis] [place]", "G A 400", "go to a place", true},
                {"D [axis] [distance]", "D B -400", "go a distance", true},
                {"J [axis] [+/-]", "J A +", "jog", true},
                {"H [axis] [+/-] H", "H A - H", "home onto the home switch", true},
                {"H [axis] - L", "H A - L", "home to the limit switch", true},
                {"P [axis] [count]", "P A 0", "set the count of an axis"},
                {"S *", "S *", "stop both axes with their ramps"},
                {"K [axis]", "K A", "stop an axis at once"},
                {"V[axis]", "VA", "read the speed of an axis"},
                {"V[axis]=[speed]", "VA=300", "set the speed of an axis"}};
  c.jog_speed = Pps(static_cast<double>(params[speed_param].factory));
  c.jog_speed_max = Pps(static_cast<double>(top_speed));
  c.position_min = Steps(-position_max), c.position_max = c.move_max = Steps(position_max);
  c.stopping_way = stopping_way_by_ramp, c.can.usual_baud = baud, c.can.bauds = {baud};
  return c;
}

DeviceType device_type() {
  DeviceType t{};  // no language, no explanations, no probe
  t.model = model, t.make_catalog = make_catalog, t.make_driver = make_driver,
  t.make_emulator = make_emulator;
  return t;
}

}  // namespace hw::twin
