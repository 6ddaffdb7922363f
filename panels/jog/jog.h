#pragma once
#include <vector>

#include <imgui.h>

#include "gui/model/units_format.h"
#include "gui/shell/panel_entry.h"
#include "panels/column.h"
#include "panels/jog/guard_offer.h"
#include "panels/jog/jog_speed.h"
#include "panels/jog/jog_units.h"
#include "panels/jog/tap_card.h"
#include "panels/position/unit_chooser.h"

namespace hw::panels {

/// Jogs axes: hold a button to move, tap it for a step. Up to four axes have a pad. If each axis has a row
/// with two buttons of its own, this panel shows Stop and the steps.
class Jog final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  void draw_title(gui::Frame& frame, const LeftColumn& column);
  void draw_reason(gui::Frame& frame, const gui::Rect& place);
  void draw_guarantee_here(gui::Frame& frame, const gui::Rect& place);
  void draw_hint_over_guarantee(gui::Frame& frame, const gui::Rect& place);
  static void show_own_units(gui::Frame& frame, const OwnUnits& own, const gui::Rect& place);
  // Each function returns its height.
  [[nodiscard]] float draw_cross(gui::Frame& frame, const LeftColumn& column);
  [[nodiscard]] float draw_pairs(gui::Frame& frame);
  [[nodiscard]] float draw_stop_and_steps(gui::Frame& frame, const LeftColumn& column);
  void draw_button(gui::Frame& frame, AxisId axis, Sign sign, float x, float y, ImVec2 size);
  void draw_stop(gui::Frame& frame, float x, float y, ImVec2 size);
  void draw_stop_again(gui::Frame& frame, float x, float y, ImVec2 size);
  void draw_steps_column(gui::Frame& frame, float x, float width, float height);
  void draw_steps_row(gui::Frame& frame, float x, float y, float width);
  void draw_step(gui::Frame& frame, const gui::JogStep& step, std::string_view label, float width);
  template <class Width>
  [[nodiscard]] int words_that_fit(const gui::Frame& frame, const Width& width) const;
  /// The label of a step in as many words as `room` allows; 0: the fewest.
  [[nodiscard]] std::string_view label_of(const gui::JogStep& step, int room) const;
  void follow_unit(gui::Frame& frame);

  JogSpeed speed_;
  GuardOffer guard_;
  TapCard refused_tap_;
  UnitChooser chooser_;
  std::vector<gui::JogStep> steps_;
  gui::DisplayUnit
      steps_unit_;  ///< unit of the steps; where units differ, that of unit_of_taps() with the names of all
  bool units_differ_ = false;
  int steps_many_ = 0;
  ImVec2 origin_{};
};

}  // namespace hw::panels
