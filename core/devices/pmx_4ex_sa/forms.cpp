#include "core/devices/pmx_4ex_sa/forms.h"

#include "core/devices/pmx_4ex_sa/facts.h"

namespace hw::pmx_4ex_sa {

// Manual ch. 9.
const arcus::Forms& forms() {
  static const arcus::Forms all{
      .model = &model,
      .status = "MST",
      .positions = "PP",
      .encoders = "PE",
      .speeds = "PS",
      .behind_status = {"BUF", "BUFSTART", "BUFEND", "BUFFREE", "MM"},
      .position = "Pa",
      .encoder = "Ea",
      .mode = "",
      .jog = "Jas",
      .stop = "STOPa",
      .abort = "ABORTa",
      .clear = "CLRa",
      .homes = {"Has0", "Has1", "Has2", "Has3", "Has4"},
      .power = "EOn",
      .change_speed = "SSPDa=n",
      .change_target = "Tan",
      .latch = "LTa",
      .sync_on = "SYNaO",
      .sync_off = "SYNaF",
      .loop_state = "SLSa",
      .high_speed = "HS",
      .accel = "ACC",
      .axis_high_speed = "HSa",
      .axis_low_speed = "LSa",
      .axis_accel = "ACCa",
      .axis_speeds = true,
      .joystick = true,
      .supply = "12 to 24 V",
      .wires = "the wiring (485+ and 485- may be crossed)",
      .other_product = arcus::dmx_product,
  };
  return all;
}

}  // namespace hw::pmx_4ex_sa
