#pragma once
// The drawing on the machine: cut in pieces that fit into the controller, held, stopped, and gone on with
// from the start of what was being drawn then. Ids: `drawing/cut`, `drawing/cut_on`, `drawing/hold`,
// `drawing/stop`, `drawing/cut_progress`, `drawing/ask_cut`.
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
    bool in_work = false;                          ///< it is being worked out: a click waits for it
  };
  /// At ImGui's cursor, over the width of the column.
  void draw(gui::Frame& frame, const Wanted& wanted);
  void draw_dialog(gui::Frame& frame);

 private:
  using Made = std::shared_ptr<const DrawingJob::Made>;
  void ask(gui::Frame& frame, Made made, Parts parts, std::string question);
  void ask_to_go_on(gui::Frame& frame);
  void draw_while_running(gui::Frame& frame);
  void draw_override(gui::Frame& frame);
  void tell(gui::Frame& frame, const IntentBody& wish);
  void draw_start(gui::Frame& frame, const Wanted& wanted);
  void draw_progress(gui::Frame& frame);
  void cut(gui::Frame& frame);
  void say_what_came(gui::Frame& frame);

  struct Asked {
    Made made;
    Parts parts;
    std::string question;
    std::weak_ptr<void> go_ahead;  ///< a stop while the question stands takes it away
    bool open = false, goes_on = false;
  } asked_;
  Parts left_;  ///< what was left, worked out
  Made cut_;    ///< the latest that was begun
  struct Begun {
    gui::Tab* by;
    IntentId id;
  };
  std::vector<Begun> begun_;  ///< whose fate is not known yet
  bool working_ = false;      ///< out what is left
  bool waits_ = false;        ///< what was clicked
  std::string progress_, speed_;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::panels
