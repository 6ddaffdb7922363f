#pragma once
// Runs the drawing on the machine, in pieces that fit into the controller. Holds it, stops it, and resumes it
// from the start of the interrupted part. Ids: `drawing/cut`, `drawing/cut_on`, `drawing/hold`,
// `drawing/stop`, `drawing/cut_progress`, `drawing/ask_cut`, `drawing/loops`, `drawing/open_loops`.
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/device/pieces.h"
#include "gui/shell/frame.h"
#include "panels/drawing/drawing_job.h"

namespace hw::panels {

class DrawingRun {
 public:
  struct Wanted {
    std::shared_ptr<const DrawingJob::Made> made;  ///< null: there is nothing to cut
    std::string_view why_not;                      ///< why there is nothing to cut, or there are no pieces
    std::string_view time;                         ///< duration; may be empty
    std::size_t moves = 0;                         ///< number in the whole drawing
    bool in_work = false;                          ///< the drawing is being worked out; a click waits for it
  };
  /// Draws at ImGui's cursor, across the column.
  void draw(gui::Frame& frame, const Wanted& wanted);
  void draw_dialog(gui::Frame& frame);
  /// Asks whether to go once around the drawing with the tool off.
  void trace_frame(gui::Frame& frame, std::shared_ptr<const DrawingJob::Made> made);
  /// Why the frame cannot be followed now, as a sentence; empty: it can.
  [[nodiscard]] std::string_view why_no_trace(const gui::Frame& frame, const DrawingJob::Made* made) const;
  /// The chain at work in the drawing that is shown; -1: another drawing is being cut, none was begun, or all
  /// of it is done.
  [[nodiscard]] int chain_at_work(const gui::Frame& frame, const DrawingJob::Made* made) const;

 private:
  using Made = std::shared_ptr<const DrawingJob::Made>;
  enum class What : std::uint8_t { all, rest, frame };
  void ask(gui::Frame& frame, What what, Made made, Parts parts, std::string question);
  void ask_to_go_on(gui::Frame& frame);
  /// The drawing that can be resumed; null: none.
  [[nodiscard]] const Made* left(const gui::Frame& frame) const;
  /// Works on the worker, then asks the question.
  void work_out(gui::Frame& frame, What what, Made made, int from_step);
  void draw_while_running(gui::Frame& frame);
  void draw_override(gui::Frame& frame);
  void send_to_all(gui::Frame& frame, const IntentBody& request);
  void draw_start(gui::Frame& frame, const Wanted& wanted);
  void draw_loops(gui::Frame& frame, const Pieces& pieces);
  [[nodiscard]] std::string_view why_not_now(const gui::Frame& frame, const DrawingJob::Made* made);
  void draw_progress(gui::Frame& frame);
  /// `program`: state of a single controller that draws by a program of its own.
  void describe_progress(const PiecesState& now, bool is_sent, RunState program);
  [[nodiscard]] static double share_done(const PiecesState& now, const DrawingJob::Made* made,
                                         std::optional<double> left);
  /// The drawing that is cut, or was cut last; null: none, or a drawing begun elsewhere.
  [[nodiscard]] const DrawingJob::Made* at_work(const gui::Frame& frame) const;
  void cut(gui::Frame& frame);
  void report_outcome(gui::Frame& frame);

  struct Asked {
    Made made;
    Parts parts;
    std::string question;
    std::weak_ptr<void> go_ahead;  ///< expires on a stop while the question is open
    What what = What::all;
    bool open = false;
  } asked_;
  struct WorkedOut {
    What what = What::all;
    Made made;
    Parts parts;
  } worked_out_;         ///< without parts: no result
  Made cut_;             ///< the latest drawing requested
  Made stopped_;         ///< the drawing before, because `cut_` may be refused
  bool traces_ = false;  ///< the latest run was a frame
  const sequence::Sequence* traced_ =
      nullptr;  ///< that frame, only compared with the run that the bus has begun
  struct Begun {
    gui::Tab* by;
    IntentId id;
  };
  std::vector<Begun> begun_;  ///< commands whose outcomes are not known yet
  bool working_ = false;      ///< a job is under way
  bool waits_ = false;        ///< a click waits for the result
  StepClock clock_;
  std::string progress_, speed_;
  std::uint32_t closed_loops_ = 0;  ///< reported in `loops_`
  std::string loops_;               ///< why the drawing cannot be cut with these loops; empty: it can
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::panels
