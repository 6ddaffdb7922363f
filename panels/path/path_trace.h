#pragma once
// Follows the real path of the shown axes, with its age.
#include <array>
#include <cstdint>

#include <imgui.h>

#include "core/drawing/tool_path.h"
#include "gui/shell/frame.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

/// The runs of a trace by their age at the last addition, oldest first, so that the trace does not change
/// while nothing moves.
struct TraceAges {
  static constexpr std::size_t count = 4;
  static constexpr std::array<int, count - 1> seconds{600, 60, 10};
  /// The first run of each age; the last age is the newest, and extends to the end.
  std::array<std::size_t, count> begin{};
};
TraceAges ages_of(const drawing::ToolPath& trace);
/// The colour of the trace, which fades from the newest to the oldest.
ImU32 trace_colour(const gui::Ui& ui, std::size_t age);
float trace_width(const gui::Ui& ui, std::size_t age);

class PathTrace {
 public:
  /// Call once a frame.
  void follow(const gui::Frame& frame, const PathAxes& axes);
  [[nodiscard]] const drawing::ToolPath& path() const { return path_; }
  /// The time at which the axes were on that run, to the second.
  [[nodiscard]] Instant when(std::size_t run) const;

 private:
  /// The parameters followed; a change restarts the trace.
  struct Key {
    PathAxes axes;
    Instant zero{};                        ///< zero of time
    std::array<std::uint64_t, 3> begun{};  ///< by direction: gui::PositionTrace::begun()
    std::array<double, 3> scale{};
    bool operator==(const Key&) const = default;
  };
  /// A controller, and the part of its trace taken so far.
  struct Source {
    gui::Tab* tab = nullptr;
    std::uint64_t taken = 0;  ///< number taken, of gui::PositionTrace::count()
  };
  void begin(const Directions& all);
  [[nodiscard]] bool is_lost() const;
  Source* soonest();
  [[nodiscard]] std::optional<drawing::Point3> point(const Directions& all, Instant at) const;
  void add(const std::optional<drawing::Point3>& from, const std::optional<drawing::Point3>& to, Instant at);
  void take_next(const Directions& all, Source& source);

  Key of_;
  std::array<Source, 3> sources_;
  std::size_t source_count_ = 0;
  Instant first_{};  ///< start of the trace; each run is a second since then
  drawing::ToolPath path_;
};

}  // namespace hw::panels
