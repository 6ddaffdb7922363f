#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "gui/model/units_format.h"
#include "gui/shell/panel_entry.h"
#include "gui/widgets/number_field.h"
#include "panels/doubt_ways.h"
#include "panels/places_menu.h"
#include "panels/refusal_card.h"

namespace hw::panels {

/// Several axes on a straight line.
bool can_go_together(const gui::Frame& frame);

/// To a position, or to the home of an axis.
class GotoHome final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  struct Row {
    gui::NumberField field;
    gui::DisplayUnit unit;  ///< in which its number is typed
    IntentId asked = 0;     ///< the move that was sent last
    std::string refused;    ///< why the last one was not done
    Steps nearest{};        ///< offered instead, when `offers`
    bool offers = false;
    RefusalCard card;
    DoubtWays doubt;  ///< of the last one, if it was refused for that
  };
  void follow_units(const gui::Frame& frame);
  void follow_unit_of_speed(const gui::DisplayUnit& unit);
  void draw_rows(gui::Frame& frame);
  void draw_chosen(gui::Frame& frame);
  void draw_by(gui::Frame& frame);
  void draw_axis_choice(gui::Frame& frame, float width);
  void draw_title(gui::Frame& frame);
  void draw_way(gui::Frame& frame, float cell);
  void draw_speed(gui::Frame& frame, AxisId axis, float width);
  void draw_places(gui::Frame& frame, float width);
  void draw_home_ways(gui::Frame& frame, ImVec2 at, float width_px);
  void draw_name(gui::Frame& frame, AxisId axis, ImVec2 at);
  void draw_together(gui::Frame& frame, const gui::Box& place, ImVec2 at);
  void draw_row(gui::Frame& frame, AxisId axis);
  void draw_target(gui::Frame& frame, AxisId axis, float width, float speed_width);
  void draw_homes(gui::Frame& frame, AxisId axis, std::string_view why);
  void draw_refusal(gui::Frame& frame, AxisId axis, const gui::Rect& beside);
  void go(gui::Frame& frame, AxisId axis);
  void go_to(gui::Frame& frame, AxisId axis, Steps target);
  void follow(gui::Frame& frame, AxisId axis);
  /// Nothing, and the row says why: no number, or out of what the controller can count.
  std::optional<Steps> target_of(gui::Frame& frame, AxisId axis);
  void go_together(gui::Frame& frame);
  void go_to_zero(gui::Frame& frame);
  [[nodiscard]] bool chosen(const gui::Frame& frame, std::size_t axis) const;
  /// Of those that take part the first that cannot be moved.
  [[nodiscard]] std::string_view why_not_together(const gui::Frame& frame) const;
  void send(gui::Frame& frame, std::vector<AxisTarget> targets, bool by, Pps speed = {});
  [[nodiscard]] Pps speed_of(const gui::Frame& frame, AxisId axis) const;

  std::array<Row, max_axes> rows_;
  gui::NumberField speed_;  ///< of moves to and by; empty: as the controller is set
  gui::DisplayUnit speed_unit_;
  PlacesMenu places_;
  int mode_ = 0;
  bool by_ = false;                      ///< distances instead of targets
  bool all_ = false;                     ///< of many axes: a row for each
  std::uint32_t together_ = 0;           ///< bit per axis: takes part in a move of several
  std::vector<std::string_view> names_;  ///< of the ways of homing; kept for its memory
};

}  // namespace hw::panels
