#pragma once
// Lets the user choose the axes of a path view, on a bus from any of its controllers, and the signal that the
// tool is on. Ids: `path/right`, `path/up` (where there are two axes), `path/third` (where there are three),
// `path/tool`.
#include <string_view>
#include <vector>

#include "gui/shell/frame.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

/// The tool signal of a path.
struct PathTool {
  bool own = true;  ///< true: as the blocks or drawing switch it from which the program was written
  int output = -1;  ///< otherwise this output of the catalog; -1: none, the tool is always on
  bool operator==(const PathTool&) const = default;
};

class PathChoice {
 public:
  /// Continues a row; `top_px`: top of that row.
  void draw(gui::Frame& frame, float top_px);
  /// Call once a frame, before the other functions.
  void begin(const gui::Frame& frame);
  [[nodiscard]] PathAxes axes() const;
  [[nodiscard]] PathTool tool() const;

 private:
  std::vector<std::string_view> axis_names_, right_names_, third_names_, tool_names_;
  int right_ = 0, up_ = 1;  ///< right: the index after the last axis is time
  int third_ = 0;           ///< 0 none, else axis third_ - 1
  int tool_ = 0;            ///< 0: that of the program, 1: none, else output tool_ - 2
};

}  // namespace hw::panels
