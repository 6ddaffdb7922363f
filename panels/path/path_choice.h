#pragma once
// Which axes a path is seen in, on a bus of any of its controllers, and what tells that the tool is on. Ids:
// `path/right`, `path/up` (where there are two axes), `path/third` (where there are three), `path/tool`.
#include <string_view>
#include <vector>

#include "gui/shell/frame.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

/// What a path takes for its tool.
struct PathTool {
  bool own = true;  ///< as the blocks or the drawing switch it that the program was written from
  int output = -1;  ///< else this one of the catalog; -1: none, it is always on
  bool operator==(const PathTool&) const = default;
};

class PathChoice {
 public:
  /// In a row with what stands before them; `top_px` of that row.
  void draw(gui::Frame& frame, float top_px);
  /// Once a frame, before the others.
  void begin(const gui::Frame& frame);
  [[nodiscard]] PathAxes axes() const;
  [[nodiscard]] PathTool tool() const;

 private:
  std::vector<std::string_view> axis_names_, right_names_, third_names_, tool_names_;
  int right_ = 0, up_ = 1;  ///< right: one behind the axes is time
  int third_ = 0;           ///< 0 none, else axis third_ - 1
  int tool_ = 0;            ///< 0 its own, 1 none, else output tool_ - 2
};

}  // namespace hw::panels
