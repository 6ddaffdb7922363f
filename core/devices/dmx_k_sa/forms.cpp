#include "core/devices/dmx_k_sa/forms.h"

#include "core/devices/dmx_k_sa/facts.h"

namespace hw::dmx_k_sa {

// Manual ch. 9.
const arcus::Forms& forms() {
  static const arcus::Forms all{
      .model = &model,
      .status = "MST",
      .positions = "PX",
      .encoders = "EX",
      .speeds = "PS",
      .behind_status = {},
      .position = "PX",
      .encoder = "EX",
      .mode = "MM",
      .jog = "Js",
      .stop = "STOP",
      .abort = "ABORT",
      .clear = "CLR",
      .homes = {"Hs", "Ls", "ZHs", "Zs", "HLs"},
      .power = "EO",
      .change_speed = "SSPDn",
      .change_target = "Tn",
      .latch = "LT",
      .sync_on = "SYNO",
      .sync_off = "SYNF",
      .loop_state = "SLS",
      .high_speed = "HSPD",
      .accel = "ACC",
      .axis_high_speed = "",
      .axis_low_speed = "",
      .axis_accel = "",
      .axis_speeds = false,
      .joystick = false,
      .supply = "12 to 35 V",
      .wires = "the wiring (TXD and RXD, or 485+ and 485-, may be crossed)",
      .other_product = arcus::pmx_product,
  };
  return all;
}

}  // namespace hw::dmx_k_sa
