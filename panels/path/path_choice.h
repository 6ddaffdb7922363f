#pragma once
// Which axes of a controller a path is seen in, and which output is its tool. Ids: `path/right`, `path/up`,
// `path/third` (where there are three axes), `path/tool`.
#include <optional>
#include <string_view>
#include <vector>

#include "core/device/track_path.h"
#include "gui/shell/frame.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

class PathChoice {
 public:
  /// In a row with what stands before them; `top_px` of that row.
  void draw(gui::Frame& frame, float top_px);
  [[nodiscard]] PathAxes axes() const;
  [[nodiscard]] bool has_tool() const { return tool_ > 0; }
  /// The same, for the track of a rehearsal.
  [[nodiscard]] TrackAxes track_axes(const gui::Tab& tab) const;

 private:
  void name_all(const gui::Frame& frame);

  std::vector<std::string_view> axis_names_, third_names_, tool_names_;
  int right_ = 0, up_ = 1;
  int third_ = 0;  ///< 0 none, else axis third_ - 1
  int tool_ = 0;   ///< 0 none, else output tool_ - 1
};

}  // namespace hw::panels
