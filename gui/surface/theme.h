#pragma once
// Colour tokens in a dark and a light set, and the ImGui style made from them. Each colour has one meaning:
// cyan motion, green good, amber attention, red stop or fault, violet emulated.
#include <array>
#include <cstdint>

#include <imgui.h>

namespace hw::gui {

enum class Tone : std::uint8_t {
  ground,  ///< top bar, status line
  panel,   ///< columns, panels
  raised,  ///< buttons
  hover,   ///< button under the pointer
  well,    ///< fields, editor, logs, plots
  sel,     ///< chosen row, chosen segment, button that is on
  line,    ///< hairlines, grids, disabled outline
  edge,    ///< field outline, chosen outline, empty lamp
  ink,     ///< values, names, digits
  ink2,    ///< labels, sentences in support
  ink3,    ///< line numbers, times, off, disabled, stale
  motion,  ///< moving, will move
  ok,
  warn,   ///< limit, stale, untrusted, edited
  fault,  ///< error, lost, refused
  stop,   ///< STOP ALL fill
  emu,    ///< EMULATED
  flow,   ///< program text: loops, jumps
  trace,  ///< third plot trace
  lamp_ok,
  lamp_warn,  ///< lamp fills, inside an ink2 ring
  motion_t,
  ok_t,
  warn_t,
  fault_t,
  emu_t,      ///< tints behind the same colour
  on_motion,  ///< text on a `motion` fill
  on_stop,    ///< text on a `stop` fill
  count
};

constexpr ImU32 rgb(std::uint32_t hex) {
  return IM_COL32((hex >> 16) & 255, (hex >> 8) & 255, hex & 255, 255);
}
constexpr ImU32 with_alpha(ImU32 colour, float alpha) {
  return (colour & ~IM_COL32_A_MASK) | (static_cast<ImU32>(alpha * 255.0f + 0.5f) << IM_COL32_A_SHIFT);
}

struct Theme {
  bool dark;
  std::array<ImU32, static_cast<std::size_t>(Tone::count)> tones;
  constexpr ImU32 operator[](Tone t) const { return tones[static_cast<std::size_t>(t)]; }
};

extern const Theme dark_theme;
extern const Theme light_theme;

/// Fills `style` from the tokens; all lengths times `scale`.
void apply(const Theme& theme, float scale, ImGuiStyle& style);

}  // namespace hw::gui
