#pragma once
// Large numbers: right-aligned tabular figures with the unit in a slot of 36 beside them.
#include <span>
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

enum class DigitsState : std::uint8_t {
  good,
  off,        ///< ink3
  stale,      ///< ink3; the age is shown below
  untrusted,  ///< ink3 on diagonal hatching
};

struct DigitsOptions {
  Face face = Face::digits48;
  DigitsState state = DigitsState::good;
  std::string_view tip = {};
  float width = fill;
};

/// `number`: the text to show ("−150.000"). The widget is a button: a click copies or sets the number.
Touch digits(Ui& ui, std::string_view id, std::string_view label, std::string_view number,
             std::string_view unit, const DigitsOptions& options = {});

/// The largest face, `wanted` or smaller, in which all numbers fit beside their unit, so that the decimal
/// points of all axes stay in one column.
Face digits_face(const Ui& ui, std::span<const std::string_view> numbers, std::string_view unit, Face wanted,
                 float width_px);
/// The width of figures and unit together, in pixels.
float digits_width(const Ui& ui, Face face, std::string_view number, std::string_view unit);

}  // namespace hw::gui
