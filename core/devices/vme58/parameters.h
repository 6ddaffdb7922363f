#pragma once
// The parameters of a VME58, axis by axis: the maker's two letters, range, factory value, and the command
// that sets them. For the catalog and the driver.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/vme58/command_facts.h"

namespace hw::vme58 {

/// The fitting of an axis that a parameter requires.
enum class Fitting : std::uint8_t { any, servo, encoder, step_with_encoder };

/// One row: a parameter of each axis with the fitting, or of the whole board.
struct ParameterFact {
  std::string_view letters;  ///< sent before the number; of a switch: its name
  Fitting fitting = Fitting::any;
  bool whole_board = false;
  std::optional<AxisValue> shown;  ///< its place in the data area (integer part only)
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

/// All parameters of this model, in catalog order.
std::vector<Parameter> parameters_of(const Variant& variant);
/// The text that sets it, without the axis: "VL1000", "HN", "CN".
std::string set_text(const ParameterFact& fact, std::int64_t value);

}  // namespace hw::vme58
