#pragma once
// Draws the front panels of the emulated boxes: lamps, power switch, buttons to hold down, circuit breaker.
// Ids: `bench/lamp/Power`, `bench/power`, `bench/button/Run`, `bench/breaker`; a second box appends its name.
#include <string>

#include <imgui.h>

#include "gui/shell/frame.h"
#include "panels/widget_path.h"

namespace hw::panels {

inline bool bit(std::uint32_t bits, std::size_t n) { return (bits >> n) & 1u; }
/// Whether the box has buttons or lamps beside its switch.
bool has_front_panel(const BenchFacts& facts, int supply);
/// The id of a widget that each supply has: "bench/power", for a second box "bench/power/Slave".
Path path_of(std::string_view what, const BenchSupply& supply);

class FrontPanels {
 public:
  void draw(gui::Frame& frame);

 private:
  void draw_panel(gui::Frame& frame, int supply);
  void draw_lamps(gui::Frame& frame, int supply, ImVec2 corner, float width);
  void draw_power(gui::Frame& frame, int supply, ImVec2 at);
  void draw_buttons(gui::Frame& frame, int supply, ImVec2 at, float width);
  void draw_button(gui::Frame& frame, std::size_t button, float width);
  void draw_breaker(gui::Frame& frame, int supply, ImVec2 at, float width);
  void release_forgotten(gui::Frame& frame);

  std::string pressed_;  ///< id of the button that the mouse holds
};

}  // namespace hw::panels
