#pragma once
// The path of a program's latest rehearsal, worked out by the worker, and what it comes to.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/device/track_path.h"
#include "gui/model/rehearsals.h"
#include "gui/model/units_format.h"
#include "gui/shell/frame.h"

namespace hw::panels {

class ProgramPath {
 public:
  struct Facts {
    std::string size, way_on, way_off, time;
  };
  /// Once a frame, of the chosen program. True: it is another one from now on, or in other axes or units.
  bool follow(gui::Frame& frame, const TrackAxes& axes);

  [[nodiscard]] int slot() const { return made_.slot; }
  [[nodiscard]] bool rehearsed() const { return made_.rehearsal > 0; }
  /// Null: not rehearsed, not worked out yet, or nothing moves. Its sources are lines of text().
  [[nodiscard]] const std::shared_ptr<const drawing::ToolPath>& path() const { return path_; }
  /// The way that the blocks or the drawing mean which the program was written from; null: it is of none.
  [[nodiscard]] const std::shared_ptr<const drawing::ToolPath>& commanded() const { return commanded_; }
  [[nodiscard]] const Facts& facts() const { return facts_; }
  /// That was rehearsed; null: none was.
  [[nodiscard]] const std::string* text(const gui::Frame& frame) const;
  /// What is typed now is not what was rehearsed.
  [[nodiscard]] bool older(const gui::Frame& frame) const;
  /// Where the controller is in it, -1: nowhere.
  [[nodiscard]] int line_at_work(const gui::Frame& frame) const;

 private:
  /// What the path was made of: made anew when it differs.
  struct Made {
    int rehearsal = 0, slot = -1;
    TrackAxes axes;
    bool operator==(const Made&) const = default;
  };
  void work_out(gui::Frame& frame, const gui::Rehearsals::Outcome& outcome);
  struct Paths {
    std::shared_ptr<const drawing::ToolPath> path, commanded;
  };
  void take(Paths paths, const std::array<gui::DisplayUnit, 3>& units);

  Made made_;
  std::shared_ptr<const drawing::ToolPath> path_, commanded_;
  Facts facts_;
  std::vector<int> line_of_command_;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

/// "12.5 mm"; of several units there is no length.
std::string length_text(double units, const gui::DisplayUnit& unit, bool one_unit);

}  // namespace hw::panels
