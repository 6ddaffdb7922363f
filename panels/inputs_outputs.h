#pragma once
#include <array>
#include <span>
#include <string_view>

#include <imgui.h>

#include "gui/shell/panel_entry.h"

namespace hw::panels {

/// Shows inputs as lamps, outputs as toggles that change only when the controller has confirmed it, and
/// analog inputs as meters. Lines of a group are below its name, which gives their direction.
class InputsOutputs final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_inputs(gui::Frame& frame);
  void draw_outputs(gui::Frame& frame);
  void draw_levels(gui::Frame& frame, std::span<const InputInfo> lines, std::size_t first);
  void draw_levels_of_outputs(gui::Frame& frame, std::string_view group);
  void draw_output(gui::Frame& frame, int number, float width, bool narrow);
  void draw_all_analog(gui::Frame& frame);
  void draw_analog(gui::Frame& frame, int number, float width, bool short_words);
  static void draw_rail(gui::Frame& frame);
  static void draw_rail_lamp(gui::Frame& frame, int number, std::string_view own, ImVec2 at, float width_px);

  std::array<IntentId, max_outputs + 1> asked_{};  ///< by output number: the latest command, until it is done
};

}  // namespace hw::panels
