#pragma once
// How each model spells the driver's commands and questions, as data that the codec fills in. In a form `a`
// stands for the axis letter, `s` for the sign, `n` for a number.
#include <array>
#include <string_view>

#include "core/devices/arcus/facts.h"

namespace hw::arcus {

struct Forms {
  const Model* model;

  // One round of status: each question is answered by one value per axis, joined by colons.
  std::string_view status, positions, encoders, speeds;
  std::array<std::string_view, 5> behind_status;  ///< readout ids of the fields after the words of `status`

  std::string_view position, encoder;  ///< of one axis, with a set form
  std::string_view mode;               ///< asks for ABS or INC; empty: the status contains it
  std::string_view jog, stop, abort, clear;
  std::array<std::string_view, 5> homes;  ///< by HomeMode
  std::string_view power;                 ///< with a set form
  std::string_view change_speed, change_target;
  std::string_view latch, sync_on, sync_off;
  std::string_view loop_state;
  std::string_view high_speed, accel;
  std::string_view axis_high_speed, axis_low_speed, axis_accel;
  bool axis_speeds;  ///< an axis may have speeds of its own
  bool joystick;     ///< axes may follow a joystick (JE)

  // For sentences.
  std::string_view supply;         ///< "12 to 24 V"
  std::string_view wires;          ///< what to check
  std::string_view other_product;  ///< reply to ID of the other model of the family
};

}  // namespace hw::arcus
