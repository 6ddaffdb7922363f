#pragma once
// The highlighted runs of a path, and the progress of the one being executed: runs before the reached place
// are done, those after it still to do.
#include <cstddef>
#include <optional>
#include <vector>

#include "panels/path/path_subject.h"

namespace hw::panels {

class PathProgress {
 public:
  /// Consecutive runs of the path.
  struct Stretch {
    std::size_t first = 0, end = 0;
    bool operator==(const Stretch&) const = default;
  };
  /// A place on the path, and its first point after that place.
  struct Reached {
    drawing::Point3 at;
    std::size_t next_point = 0;
  };
  /// Call once a frame. Searches only when the highlighted runs change.
  void follow(const PathSubject& subject);
  [[nodiscard]] const std::vector<Stretch>& lit() const { return lit_; }
  /// Number of runs done; none: nothing is being executed, or the path does not show it.
  [[nodiscard]] std::optional<std::size_t> done() const {
    return of_.at_work && lit_.size() == 1 ? std::optional(lit_.front().first) : std::nullopt;
  }
  /// Within what is at work, and back only when the tool has not been near what lies ahead; none: it is not
  /// near it. Once a frame, behind follow().
  std::optional<Reached> reached(const drawing::PathView& view, drawing::Point3 here, double within_px);

 private:
  /// The key of the stretches found.
  struct Of {
    std::shared_ptr<const drawing::ToolPath> path;
    int source = -1, count = 1;
    std::optional<int> pass;
    bool at_work = false;
    bool operator==(const Of&) const = default;
  };
  /// On the screen.
  struct Tool {
    const drawing::PathView& view;
    drawing::Point at;
    double within_px;
  };
  [[nodiscard]] std::optional<Reached> first_near(const Tool& tool, std::size_t from, std::size_t end) const;

  Of of_;
  std::vector<Stretch> lit_;
  std::size_t reached_ = 0;   ///< point before the latest place reached
  std::size_t searched_ = 0;  ///< while the tool is not near what lies ahead: search goes on there
};

}  // namespace hw::panels
