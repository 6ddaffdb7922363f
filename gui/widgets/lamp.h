#pragma once
// Inputs, limits, latches: shape, name and word. Outputs: a toggle that changes when the controller has
// confirmed it.
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
/// Only the shape, for rails and drawn front panels: `size` logical, lit in `tone` within an ink2 ring.
void draw_lamp(Ui& ui, ImVec2 centre, float size, LampShape shape, LampState state,
               Tone tone = Tone::lamp_ok);

enum class ToggleState : std::uint8_t { off, on, sending, refused, stale };
struct ToggleOptions {
  ToggleState state = ToggleState::off;
  std::string_view word = {};      ///< instead of off, on, sending, refused, on?
  std::string_view disabled = {};  ///< why, naming its owner
  std::string_view tip = {};
  float width = fill;
  bool narrow = false;  ///< only lamp and name
};
Touch toggle_lamp(Ui& ui, std::string_view id, std::string_view name, const ToggleOptions& options);
/// The same as a cell of a table, 28 high in a row of 32: only the lamp, as row and column name it.
Touch toggle_cell(Ui& ui, std::string_view id, std::string_view name, bool on, float width,
                  std::string_view tip);

}  // namespace hw::gui
