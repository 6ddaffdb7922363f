#pragma once
// Where the axes have really been, as a path in those of them that are looked at.
#include <cstdint>

#include "core/drawing/tool_path.h"
#include "gui/shell/frame.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

class PathTrace {
 public:
  /// Once a frame.
  void follow(const gui::Frame& frame, const PathAxes& axes);
  [[nodiscard]] const drawing::ToolPath& path() const { return path_; }
  /// When the axes were on that run of it, to the second.
  [[nodiscard]] Instant when(std::size_t run) const;

 private:
  /// What it was followed with; another one begins it anew.
  struct Of {
    std::uint64_t begun = 0;  ///< gui::PositionTrace::begun()
    PathAxes axes;
    drawing::Point3 scale;
    bool operator==(const Of&) const = default;
  };
  Of of_;
  std::uint64_t count_ = 0;  ///< gui::PositionTrace::count() that it has come to
  Instant first_{};          ///< each run is of one second since then
  drawing::ToolPath path_;
};

}  // namespace hw::panels
