#pragma once
// How each model spells what the driver says and asks: data that the codec fills in. In a form `a` stands for
// the axis letter, `s` for the sign, `n` for a number.
#include <array>
#include <string_view>

#include "core/devices/arcus/facts.h"

namespace hw::arcus {

struct Forms {
  const Model* model;

  // One round of status: each is answered by one value per axis, joined by colons.
  std::string_view status = "MST", positions, encoders, speeds = "PS";
  /// Behind the axes' words of `status`: ids of readouts.
  std::array<std::string_view, 5> behind_status{};

  std::string_view position, encoder;  ///< of one axis, with a set form
  std::string_view mode = "MM";        ///< asks for it; empty: it stands in `status`
  std::string_view move = "a";         ///< followed by the target; axes one after the other
  std::string_view jog, stop, clear, clear_loop;
  std::array<std::string_view, 5> homes;  ///< by HomeMode
  std::string_view power;                 ///< followed by =0 or =1
  std::string_view change_speed, speed_window, change_target;
  std::string_view latch, sync_on, sync_off;
  std::string_view loop_state, loop_difference;
  std::string_view high_speed, axis_high_speed, axis_low_speed, axis_accel, accel;
  bool axis_speeds = false;  ///< an axis may have speeds of its own
  bool buffer = false;       ///< BO, BF, I
  bool joystick = false;     ///< JE

  // For a person.
  std::string_view supply;         ///< "12 to 24 V"
  std::string_view wires;          ///< what can be crossed
  std::string_view other_product;  ///< reply to ID of the other model of the family
};

}  // namespace hw::arcus
