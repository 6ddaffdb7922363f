#pragma once
// The path of a program's latest rehearsal, which the worker makes, and its totals. On a bus it is the path
// of the programs of all controllers shown, as if started together, or of a drawing that they do together.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/track_path.h"
#include "gui/model/bus.h"
#include "gui/model/rehearsals.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"
#include "panels/drawing/drawing_job.h"
#include "panels/path/path_choice.h"
#include "panels/path/source_places.h"

namespace hw::panels {

/// Shown while ProgramPath::older().
inline constexpr std::string_view path_is_older = "The text has been changed since. Simulate draws it again.";

class ProgramPath {
 public:
  struct Facts {
    std::string size, way_on, way_off, time;  ///< empty: unknown
    std::string tool;  ///< the output or axis that switches it: "DO5", "Z"; empty: it is always on
    int every = 1;     ///< one in so many places was kept
  };
  /// Call once a frame, for the chosen program. Returns true when the program, axes or units have changed.
  bool follow(gui::Frame& frame, const PathAxes& axes, PathTool tool);
  /// Requests a rehearsal of the programs that the path shows.
  void rehearse(const gui::Frame& frame);
  [[nodiscard]] std::string_view why_not_rehearse() const;
  [[nodiscard]] bool under_way() const;

  [[nodiscard]] bool of_several() const { return made_.count > 1; }
  /// The drawing that the controllers of a bus do together, if the path shows it; null: the path shows
  /// programs. The newer of the two is shown. The sources of a drawing's path are steps.
  [[nodiscard]] const gui::DrawnTogether* drawn() const { return made_.drawn ? &drawn_ : nullptr; }
  /// The time left of drawn() while it runs; nullopt: it does not run, or unknown.
  [[nodiscard]] std::optional<double> seconds_left() const { return left_s_; }
  /// The slot of the program; -1: the path is not that of a single program.
  [[nodiscard]] int slot() const { return made_.drawn ? -1 : made_.parts[0].slot; }
  [[nodiscard]] bool rehearsed() const;
  /// The sentence why the latest rehearsal has no result; empty: it has.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }
  /// The path; null: not rehearsed, not made yet, or nothing moves. Its sources are places() of text().
  [[nodiscard]] const std::shared_ptr<const drawing::ToolPath>& path() const { return path_; }
  /// The intended path of the blocks or drawing from which the program was written; null: there are none.
  [[nodiscard]] const std::shared_ptr<const drawing::ToolPath>& commanded() const { return commanded_; }
  [[nodiscard]] const Facts& facts() const { return facts_; }
  /// The rehearsed text; null: none, or several.
  [[nodiscard]] const std::string* text() const;
  /// Whether the text has changed since the rehearsal.
  [[nodiscard]] bool older() const;
  [[nodiscard]] const SourcePlaces& places() const { return places_; }
  /// How often the source of a run of path() was done before; nullopt: the path does not show it.
  [[nodiscard]] std::optional<int> pass_of(std::size_t run) const;
  /// The source of path() that is executed, or the last source before it in its line that has a run; -1:
  /// none.
  [[nodiscard]] int source_at_work() const;
  /// How often that source was done before; nullopt: not reported, or no run of path() shows it.
  [[nodiscard]] std::optional<int> pass_at_work() const;
  /// Whether the tool is on, as reported by the controllers that switch or lower it; nullopt: always on, or
  /// not reported.
  [[nodiscard]] std::optional<bool> tool_on(const gui::Frame& frame) const;
  /// The rehearsal of the path; null: none, or several.
  [[nodiscard]] const Rehearsal* rehearsal() const;

 private:
  /// The part of a controller in the path.
  struct Part {
    gui::Tab* tab = nullptr;
    int rehearsal = 0, slot = -1;
    bool operator==(const Part&) const = default;
    [[nodiscard]] int started() const;  ///< the program that Run starts and Simulate tries
    [[nodiscard]] const gui::Rehearsals::Outcome* outcome() const;
  };
  /// The inputs of the path. A change rebuilds it.
  struct Made {
    std::array<Part, 3> parts;
    std::size_t count = 0;
    TrackAxes axes;
    PathTool tool;
    std::shared_ptr<const Rehearsal> drawn;  ///< null: made from the programs
    bool operator==(const Made&) const = default;
  };
  struct Paths {
    std::shared_ptr<const drawing::ToolPath> path, commanded;
    int every = 1;
  };
  [[nodiscard]] Made wanted_of(const gui::Frame& frame, const PathAxes& axes, PathTool tool) const;
  void follow_drawn(const gui::Frame& frame);
  void follow_refusal();
  [[nodiscard]] std::vector<Rehearsal> tracks() const;
  void work_out(gui::Frame& frame, const Directions& seen);
  void work_out_drawn(gui::Frame& frame, const Directions& seen);
  void keep_tool(const Catalog& catalog, const TrackAxes& axes);
  void take(Paths paths, const std::vector<gui::DisplayUnit>& units);

  Made made_;
  gui::DrawnTogether drawn_;  ///< the latest drawing of the bus
  int passed_over_ = 0;       ///< number of the drawing when the user asked for the programs
  StepClock clock_;
  std::optional<double> left_s_;
  std::string refusal_;
  int refused_ = 0;  ///< number of that rehearsal
  int step_at_work_ = -1;
  std::shared_ptr<const drawing::ToolPath> path_, commanded_;
  Facts facts_;
  SourcePlaces places_;
  std::vector<int> most_passes_;  ///< by source: passes of its runs; 0: no runs
  TrackAxes tool_axes_;           ///< signals that the tool is on
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

/// "12.5 mm"; a path in several units has no length.
std::string length_text(double units, const gui::DisplayUnit& unit, bool one_unit);

}  // namespace hw::panels
