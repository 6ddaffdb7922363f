#pragma once
// The icons of the console. They are drawn, not taken from a font. Each state has a shape in addition to its
// word and colour.
#include <cstdint>

#include <imgui.h>

namespace hw::gui {

enum class Icon : std::uint8_t {
  none,
  play,          ///< solid triangle to the right: moving +, run
  play_outline,  ///< simulate; worked out
  back,          ///< solid triangle to the left: moving -
  up,
  down,
  pause,         ///< two bars: hold, waiting
  step,          ///< triangle against a bar
  stop,          ///< square
  ring,          ///< idle, off
  disc,          ///< on
  ring_dot,      ///< armed, waiting latch
  square,        ///< limit, clear
  square_solid,  ///< limit, hit
  home_minus,    ///< bar, arrow towards it from the right
  home_plus,
  limit_minus,  ///< bar, triangle at it
  limit_plus,
  cross,  ///< off, refused
  check,
  clock,          ///< stale
  plug,           ///< pulled plug: lost
  house,          ///< homed
  tally,          ///< counted
  hand,           ///< set by hand
  diamond,        ///< untrusted
  diamond_solid,  ///< fault
  emulated,       ///< two squares, one behind the other
  info,
  warning,
  chevron_down,
  chevron_up,
  chevron_left,
  chevron_right,
  plus,
  minus,
  arrow_left,
  arrow_right,
  enter,
  prompt,
  folder,
  file,
  copy,     ///< two sheets
  empty,    ///< a bin: take everything out of a list
  save,     ///< an arrow down, onto a bar
  meaning,  ///< an equals sign: the meaning of the bytes
  folded,   ///< two arrowheads pointing at a line
  undo,     ///< an arrow that turns back to the left
  redo,     ///< an arrow that turns back to the right
  count
};

/// `size`: side of the enclosing square in pixels; 12 logical pixels as a rule.
void draw_icon(ImDrawList* list, Icon icon, ImVec2 centre, float size, ImU32 colour);
/// The console's logo: a handwheel with its knob in the motion colour.
void draw_brand(ImDrawList* list, ImVec2 centre, float size, ImU32 ink, ImU32 knob);
/// Four bars, `lit` of them in colour.
void draw_signal(ImDrawList* list, ImVec2 top_left, float size, int lit, ImU32 colour, ImU32 off);

}  // namespace hw::gui
