#pragma once
// What vme58.forms calls the places of the window, the bits and the values of the axes.
#include <cstdint>
#include <string>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {

/// The part of the window that a row is about.
struct RowPlace {
  std::uint16_t first = 0, last = 0;
  int bytes = 0;
};
RowPlace row_place(const Form& form);

/// "status", "input_put_index", "first" of the row, each with an offset: "vector-1".
std::uint16_t place_named(const std::string& name, const Form& form);
std::uint8_t status_bit_named(const std::string& name);
AxisValue value_named(const std::string& name);
/// Of the bits of a register: "XZ", or "none".
std::string letters_of(unsigned bits);

/// "<cr>", "<lf>" and "<sp>" become what they stand for.
std::string characters_in(std::string text);

}  // namespace hw::vme58::proof
