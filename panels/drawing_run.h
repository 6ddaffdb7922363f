#pragma once
// The drawing on the machine: cut in pieces that fit into the controller, held, stopped, and gone on with
// from the piece where it was stopped. Ids: `drawing/cut`, `drawing/cut_on`, `drawing/hold`, `drawing/stop`,
// `drawing/progress`, `drawing/ask_cut`.
#include <memory>
#include <string>
#include <string_view>

#include "core/device/pieces.h"
#include "gui/frame.h"

namespace hw::panels {

class DrawingRun {
 public:
  struct Wanted {
    std::shared_ptr<const Pieces> pieces;  ///< null: there is nothing to be cut
    std::string_view why_not;              ///< why that is so
    std::string_view time, tool;           ///< how long it takes, what becomes of its tool; may be empty
  };
  /// At ImGui's cursor, over the width of the column.
  void draw(gui::Frame& frame, const Wanted& wanted);
  void draw_dialog(gui::Frame& frame);

 private:
  using Cut = std::shared_ptr<const Pieces>;
  [[nodiscard]] static std::string_view why_not_now(const gui::Frame& frame);
  void ask(gui::Frame& frame, const Wanted& wanted, Cut pieces, int first);
  void draw_while_running(gui::Frame& frame);
  void draw_start(gui::Frame& frame, const Wanted& wanted);
  void draw_progress(gui::Frame& frame);
  void cut(gui::Frame& frame);
  void say_what_came(gui::Frame& frame);

  Cut asked_, cut_;     ///< asked about; the latest that was begun
  int first_ = 0;       ///< piece that was asked about
  IntentId begun_ = 0;  ///< whose fate is not known yet
  bool asking_ = false;
  std::weak_ptr<void> go_ahead_;  ///< a stop while the question stands takes it away
  std::string question_, progress_;
};

}  // namespace hw::panels
