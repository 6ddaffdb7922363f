#pragma once
// Draws the form of an action that is an arc (ActionInfo::is_arc): centre, direction and "Full", the
// resulting values, and the path. Ids: those of its ActionForm, `action/ID/full`, `action/ID/path`.
#include <string>

#include "panels/control/action_form.h"

namespace hw::panels {

inline constexpr float arc_height = 160;

class ArcPath {
 public:
  /// Draws at ImGui's cursor and leaves it arc_height below.
  void draw(gui::Frame& frame, ActionForm& form, float width);

 private:
  struct Arc {
    double centre_x = 0, centre_y = 0, from_x = 0, from_y = 0;
    double sweep = 0;  ///< degrees, + counterclockwise
    bool operator==(const Arc&) const = default;
  };
  static bool read(const gui::Frame& frame, const ActionForm& form, Arc& arc);
  void work_out(const gui::Frame& frame, const ActionForm& form, const Arc& arc);
  void draw_path(gui::Frame& frame, const gui::Rect& in) const;

  Arc arc_;
  bool known_ = false;
  Travel travel_[2];
  std::string words_;
  bool inside_ = true;
};

}  // namespace hw::panels
