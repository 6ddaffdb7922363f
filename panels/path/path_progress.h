#pragma once
// Tracks the highlighted runs of a path, and the progress of the run that is executed. Runs before the
// reached place are done, runs after it are still to do.
#include <cstddef>
#include <optional>
#include <vector>

#include "panels/path/path_subject.h"

namespace hw::panels {

class PathProgress {
 public:
  /// Consecutive runs of the path.
  struct RunRange {
    std::size_t first = 0, end = 0;
    bool operator==(const RunRange&) const = default;
  };
  /// A place on the path, and its first point after that place.
  struct Reached {
    drawing::Point3 at;
    std::size_t next_point = 0;
  };
  /// Call once a frame. Searches only when the highlighted runs change.
  void follow(const PathSubject& subject);
  [[nodiscard]] const std::vector<RunRange>& lit() const { return lit_; }
  /// The number of runs done; nullopt: no run is executed, or the path does not show it.
  [[nodiscard]] std::optional<std::size_t> done() const {
    return of_.at_work && lit_.size() == 1 ? std::optional(lit_.front().first) : std::nullopt;
  }
  /// The place that the tool has reached in the runs at work. It goes back only when the tool was not near
  /// the lines ahead. nullopt: the tool is not near the path. Call once a frame, after follow().
  std::optional<Reached> reached(const drawing::PathView& view, drawing::Point3 here, double within_px);

 private:
  /// The key of the runs found.
  struct Key {
    std::shared_ptr<const drawing::ToolPath> path;
    int source = -1, count = 1;
    std::optional<int> pass;
    bool at_work = false;
    bool operator==(const Key&) const = default;
  };
  /// The tool on the screen.
  struct Tool {
    const drawing::PathView& view;
    drawing::Point at;
    double within_px;
  };
  [[nodiscard]] std::optional<Reached> first_near(const Tool& tool, std::size_t from, std::size_t end) const;

  Key of_;
  std::vector<RunRange> lit_;
  std::size_t reached_ = 0;  ///< point before the latest place reached
  std::size_t searched_ =
      0;  ///< the search continues at this point while the tool is not near the lines ahead
};

}  // namespace hw::panels
