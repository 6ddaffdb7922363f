#pragma once
// Lamps show inputs, limits and latches by shape, name and word. Toggles switch outputs; they change only
// when the controller has confirmed it.
#include <string_view>

#include "gui/widgets/touch.h"

namespace hw::gui {

enum class LampShape : std::uint8_t { round, square };
enum class LampState : std::uint8_t {
  off,
  on,
  hit,      ///< a limit: word in warn
  armed,    ///< ring with a dot
  unknown,  ///< dashed, "?"
  disabled,
};

struct LampOptions {
  LampShape shape = LampShape::round;
  LampState state = LampState::off;
  std::string_view word = {};  ///< "clear", "HIT", "high"
  bool word_shown = true;      ///< false: only the lamp
  std::string_view tip = {};
  float width = 0, height = 32;
};
void lamp(Ui& ui, std::string_view id, std::string_view name, const LampOptions& options);
/// Draws only the shape, for rails and front panels. `size` is logical; a lit lamp is filled with `tone`
/// inside an ink2 ring.
void draw_lamp(Ui& ui, ImVec2 centre, float size, LampShape shape, LampState state,
               Tone tone = Tone::lamp_ok);

enum class ToggleState : std::uint8_t { off, on, sending, refused, stale };
struct ToggleOptions {
  ToggleState state = ToggleState::off;
  std::string_view word = {};      ///< instead of off, on, sending, refused, on?
  std::string_view disabled = {};  ///< why it cannot be switched, and what owns it
  std::string_view tip = {};
  float width = fill;
  bool narrow = false;  ///< only lamp and name
};
Touch toggle_lamp(Ui& ui, std::string_view id, std::string_view name, const ToggleOptions& options);
/// A toggle in a table cell, 28 high in a row of 32. It shows only the lamp, because row and column name it.
Touch toggle_cell(Ui& ui, std::string_view id, std::string_view name, bool on, float width,
                  std::string_view tip);

}  // namespace hw::gui
