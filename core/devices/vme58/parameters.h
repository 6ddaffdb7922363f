#pragma once
// What can be set on a VME58, axis by axis: the maker's two letters, range, factory value, and how it is told
// to the board. For the catalog and the driver.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/vme58/command_facts.h"

namespace hw::vme58 {

/// What an axis must have for a parameter to be one of its.
enum class Fitting : std::uint8_t { any, servo, encoder, step_with_encoder };

/// One row: of each axis that has the fitting, or of the whole board.
struct ParameterFact {
  std::string_view letters;  ///< what is sent in front of the number; of a switch: its name
  Fitting fitting = Fitting::any;
  bool whole_board = false;
  std::optional<AxisValue> shown;  ///< where the data area shows it (its integer part)
  bool drives = false;             ///< as ParamInfo::drives
  int decimals = 0;
  std::int64_t minimum = 0, maximum = 0, factory = 0;
  /// A switch: two commands instead of one with a number; the parameter is 0 or 1.
  std::string_view off = {}, on = {};
  const char* group = "";
  const char* label = "";  ///< "{}" is the axis letter
  const char* explanation = "";
  const char* unit = "";
  const char* off_words = "";
  const char* on_words = "";
};

/// One parameter of one board.
struct Parameter {
  const ParameterFact* fact;
  int axis;  ///< -1: of the whole board
  std::string mnemonic;
};

/// Ramp form of the whole board (PN): besides PN's own 1 to 10.
inline constexpr std::int64_t ramp_linear = 0, ramp_cosine = 11;

/// Of all axes of this model, in the order of the catalog.
std::vector<Parameter> parameters_of(const Variant& variant);
/// The text that sets it, without the axis: "VL1000", "HN", "CN".
std::string set_text(const ParameterFact& fact, std::int64_t value);

}  // namespace hw::vme58
