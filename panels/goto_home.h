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
#include "panels/doubt_remedies.h"
#include "panels/places_menu.h"
#include "panels/refusal_card.h"
#include "panels/widget_path.h"

namespace hw::panels {

/// Whether the axes can move together on a straight line.
bool can_go_together(const gui::Frame& frame);

/// Moves axes to a position or to their home.
class GotoHome final : public gui::Panel {
 public:
  void draw(gui::Frame& frame) override;

 private:
  struct Motion {
    std::vector<AxisTarget> targets;
    bool by = false;  ///< the targets are distances
  };
  struct Row {
    gui::NumberField field;
    gui::DisplayUnit unit;          ///< unit of the typed number
    IntentId asked = 0;             ///< the latest move sent
    Motion sent;                    ///< the latest move
    std::string refused;            ///< why the latest move was not done
    std::optional<Motion> instead;  ///< the nearest move that is allowed
    RefusalCard card;
    DoubtRemedies doubt;  ///< remedies, if the latest move was refused for a doubtful position
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
  static Path label_of_nearest(const gui::Frame& frame, AxisId axis, const Motion* nearest);
  void go_instead(gui::Frame& frame, AxisId axis);
  void follow(gui::Frame& frame, AxisId axis);
  /// The typed target. nullopt: it is not a number, or outside of the controller's count range; the row shows
  /// which.
  std::optional<Steps> target_of(gui::Frame& frame, AxisId axis);
  void go_together(gui::Frame& frame);
  void go_to_zero(gui::Frame& frame);
  [[nodiscard]] bool chosen(const gui::Frame& frame, std::size_t axis) const;
  /// Why the first of the axes that go together cannot be moved; empty: all can.
  [[nodiscard]] std::string_view why_not_together(const gui::Frame& frame) const;
  void send(gui::Frame& frame, Motion motion);
  [[nodiscard]] static std::optional<Motion> nearest_to(const gui::Frame& frame, const Motion& motion,
                                                        const PastTravel& past);
  [[nodiscard]] double typed_speed() const;  ///< 0: none

  std::array<Row, max_axes> rows_;
  gui::NumberField speed_;  ///< speed of moves to and by; empty: the controller's own speed
  gui::DisplayUnit speed_unit_;
  bool speed_is_shown_ = false;  ///< in this frame; a move never uses a number that is out of sight
  PlacesMenu places_;
  int mode_ = 0;
  bool by_ = false;                      ///< distances instead of targets
  bool all_ = false;                     ///< with many axes: a row for each of them
  std::uint32_t together_ = 0;           ///< a bit for each axis that goes together with others
  std::vector<std::string_view> names_;  ///< names of the kinds of homing; a member to keep its memory
};

}  // namespace hw::panels
