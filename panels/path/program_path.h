#pragma once
// The path of a program's latest rehearsal, worked out by the worker, and what it comes to; on a bus, of the
// programs of all controllers that are looked at, as if they began at once, or of a drawing that they do
// together.
#include <array>
#include <memory>
#include <optional>
#include <string>
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

class ProgramPath {
 public:
  struct Facts {
    std::string size, way_on, way_off, time;  ///< empty: there is none
    std::string tool;                         ///< what switches it: "DO5", "Z"; empty: it is always on
    int every = 1;                            ///< every so manieth of its places was kept
  };
  /// Once a frame, of the chosen program. True: it is another one from now on, or in other axes or units.
  bool follow(gui::Frame& frame, const PathAxes& axes, PathTool tool);
  /// Has the programs rehearsed that it is of.
  void rehearse(const gui::Frame& frame);
  [[nodiscard]] std::string_view why_not_rehearse() const;
  [[nodiscard]] bool under_way() const;

  [[nodiscard]] bool of_several() const { return made_.count > 1; }
  /// It is of a drawing that the controllers of a bus do together, and not of their programs: of the newest
  /// of both. Null: of programs. The sources of its path are steps.
  [[nodiscard]] const gui::DrawnTogether* drawn() const { return made_.drawn ? &drawn_ : nullptr; }
  /// Of drawn(), while it is at work; none: it is not, or nothing tells.
  [[nodiscard]] std::optional<double> seconds_left() const { return left_s_; }
  /// -1: of no one program.
  [[nodiscard]] int slot() const { return made_.drawn ? -1 : made_.parts[0].slot; }
  [[nodiscard]] bool rehearsed() const;
  /// Null: not rehearsed, not worked out yet, or nothing moves. Its sources are places() of text().
  [[nodiscard]] const std::shared_ptr<const drawing::ToolPath>& path() const { return path_; }
  /// The way that the blocks or the drawing mean which the program was written from; null: it is of none.
  [[nodiscard]] const std::shared_ptr<const drawing::ToolPath>& commanded() const { return commanded_; }
  [[nodiscard]] const Facts& facts() const { return facts_; }
  /// That was rehearsed; null: none was, or several were.
  [[nodiscard]] const std::string* text() const;
  /// What is typed now is not what was rehearsed.
  [[nodiscard]] bool older() const;
  [[nodiscard]] const SourcePlaces& places() const { return places_; }
  /// How often that of a run of path() was done before; none: the path does not tell.
  [[nodiscard]] std::optional<int> pass_of(std::size_t run) const;
  /// The source of path() that is at work, or the last one in front of it in its line that has a run; -1:
  /// none.
  [[nodiscard]] int source_at_work() const;
  /// What the path was made of; null: nothing, or several.
  [[nodiscard]] const Rehearsal* rehearsal() const;

 private:
  /// One controller.
  struct Part {
    gui::Tab* tab = nullptr;
    int rehearsal = 0, slot = -1;
    bool operator==(const Part&) const = default;
    [[nodiscard]] const gui::Rehearsals::Outcome* outcome() const;
  };
  /// What the path was made of: made anew when it differs.
  struct Made {
    std::array<Part, 3> parts;
    std::size_t count = 0;
    TrackAxes axes;
    PathTool tool;
    std::shared_ptr<const Rehearsal> drawn;  ///< null: the programs
    bool operator==(const Made&) const = default;
  };
  struct Paths {
    std::shared_ptr<const drawing::ToolPath> path, commanded;
    int every = 1;
  };
  [[nodiscard]] Made wanted_of(const gui::Frame& frame, const PathAxes& axes, PathTool tool) const;
  void follow_drawn(const gui::Frame& frame);
  [[nodiscard]] std::vector<Rehearsal> tracks() const;
  void work_out(gui::Frame& frame, const Directions& seen);
  void work_out_drawn(gui::Frame& frame, const Directions& seen);
  void name_tool(const Catalog& catalog, const TrackAxes& axes);
  void take(Paths paths, const std::vector<gui::DisplayUnit>& units);

  Made made_;
  gui::DrawnTogether drawn_;  ///< the bus's latest
  int passed_over_ = 0;       ///< its number when the programs were asked for
  StepClock clock_;
  std::optional<double> left_s_;
  int step_at_work_ = -1;
  std::shared_ptr<const drawing::ToolPath> path_, commanded_;
  Facts facts_;
  SourcePlaces places_;
  std::vector<bool> has_run_;  ///< by source
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

/// "12.5 mm"; of several units there is no length.
std::string length_text(double units, const gui::DisplayUnit& unit, bool one_unit);

}  // namespace hw::panels
