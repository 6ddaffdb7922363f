#pragma once
// The drawing on the machine: cut in pieces that fit into the controller, held, stopped, and gone on with
// from the start of what was being drawn then. Ids: `drawing/cut`, `drawing/cut_on`, `drawing/hold`,
// `drawing/stop`, `drawing/cut_progress`, `drawing/ask_cut`, `drawing/loops`, `drawing/open_loops`.
#include <memory>
#include <string>
#include <string_view>

#include "core/device/pieces.h"
#include "gui/shell/frame.h"
#include "panels/drawing/drawing_job.h"

namespace hw::panels {

class DrawingRun {
 public:
  struct Wanted {
    std::shared_ptr<const DrawingJob::Made> made;  ///< null: there is nothing to be cut
    std::string_view why_not;                      ///< why that is so, or it has no pieces
    std::string_view time;                         ///< how long it takes; may be empty
    std::size_t moves = 0;                         ///< in all of it
    bool in_work = false;                          ///< it is being worked out: a click waits for it
  };
  /// At ImGui's cursor, over the width of the column.
  void draw(gui::Frame& frame, const Wanted& wanted);
  void draw_dialog(gui::Frame& frame);
  /// Asks whether several controllers shall go once around it with the tool off: they have no one program.
  void trace_frame(gui::Frame& frame, std::shared_ptr<const DrawingJob::Made> made);
  /// Why that cannot be now, as a sentence; empty: it can.
  [[nodiscard]] std::string_view why_no_trace(const gui::Frame& frame, const DrawingJob::Made* made) const;

 private:
  using Made = std::shared_ptr<const DrawingJob::Made>;
  enum class What : std::uint8_t { all, rest, frame };
  void ask(gui::Frame& frame, What what, Made made, Parts parts, std::string question);
  void ask_to_go_on(gui::Frame& frame);
  /// On the worker; the question comes behind it.
  void work_out(gui::Frame& frame, What what, Made made, int from_step);
  void draw_while_running(gui::Frame& frame);
  void draw_override(gui::Frame& frame);
  void tell(gui::Frame& frame, const IntentBody& wish);
  void draw_start(gui::Frame& frame, const Wanted& wanted);
  void draw_loops(gui::Frame& frame, const Pieces& pieces);
  [[nodiscard]] std::string_view why_not_now(const gui::Frame& frame, const DrawingJob::Made* made);
  void draw_progress(gui::Frame& frame);
  void cut(gui::Frame& frame);
  void say_what_came(gui::Frame& frame);

  struct Asked {
    Made made;
    Parts parts;
    std::string question;
    std::weak_ptr<void> go_ahead;  ///< a stop while the question stands takes it away
    What what = What::all;
    bool open = false;
  } asked_;
  struct WorkedOut {
    What what = What::all;
    Made made;
    Parts parts;
  } worked_out_;  ///< without parts: nothing
  Made cut_;      ///< the latest that was begun
  struct Begun {
    gui::Tab* by;
    IntentId id;
  };
  std::vector<Begun> begun_;  ///< whose fate is not known yet
  bool working_ = false;      ///< something out
  bool waits_ = false;        ///< what was clicked
  StepClock clock_;
  std::string progress_, speed_;
  std::uint32_t closed_loops_ = 0;  ///< that `loops_` tells of
  std::string loops_;               ///< why it cannot be cut with them; empty: it can
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::panels
