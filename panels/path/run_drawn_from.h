#pragma once
// Runs the rest of a drawing that the controllers of a bus do together, from a step on. Shows the way there,
// and sends no command before the user agrees. Ids: `WHERE/run_from/yes`, `WHERE/run_from/no`.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/pieces.h"
#include "gui/model/bus.h"
#include "gui/shell/frame.h"
#include "panels/path/path_subject.h"

namespace hw::panels {

class RunDrawnFrom {
 public:
  /// Asks whether to resume from the last place before that step where the tool was up. A toast says why if
  /// the rest cannot be run.
  void ask(gui::Frame& frame, const gui::DrawnTogether& drawn, int step);
  void draw_dialog(gui::Frame& frame, std::string_view where);
  /// The first target of the tool while the question is open, in the units of the axes.
  [[nodiscard]] std::optional<drawing::Point3> goes_to(const gui::Frame& frame, const PathAxes& axes) const;

 private:
  using Parts = std::vector<Pieces>;  ///< the pieces of each controller, in the order of the axes
  struct Begun {
    gui::Tab* by = nullptr;
    IntentId id = 0;
  };
  void take(gui::Frame& frame, Result<Parts> parts);
  void compose_question(const gui::Frame& frame);
  void begin(gui::Frame& frame);
  void report_outcome(gui::Frame& frame);

  bool asking_ = false, working_ = false;
  gui::DrawnTogether drawn_;
  Parts parts_;
  std::optional<Result<Parts>> worked_out_;  ///< result from the worker
  std::string question_;
  std::weak_ptr<void> go_ahead_;  ///< expires on a stop while the question is open
  std::vector<Begun> begun_;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

/// Why no part of the drawing can be run now; empty: the user may ask for it.
std::string_view why_not_run_drawn(const gui::Frame& frame, const gui::DrawnTogether& drawn);

}  // namespace hw::panels
