#pragma once
#include <imgui.h>

#include "gui/shell/panel_entry.h"

namespace hw::panels {

/// Shows the state of the limit switches, home switches and alarms.
class Limits final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  struct Signal;
  class Signals;
  struct Summary;
  static bool find_signals(const gui::Frame& frame, int axis, Signals& signals, Summary& summary);
  void draw_limits(gui::Frame& frame);
  void draw_with_home(gui::Frame& frame);
  void draw_signals(gui::Frame& frame, int axis, float names, Summary& summary);
  void draw_in_halves(gui::Frame& frame, float names, Summary& summary);
  void draw_signal(gui::Frame& frame, const Signal& signal, bool sure, ImVec2 at, float cell, bool named);
  void draw_rail(gui::Frame& frame);
  void draw_brief_rail(gui::Frame& frame);
};

}  // namespace hw::panels
