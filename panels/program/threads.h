#pragma once
// The programs that run at once, a row each: state in words, low-level line, the source line it came from,
// and the buttons that suit. Ids: `thread/0/run`, `/pause`, `/continue`, `/stop`, `/state`, `/line`,
// `/source`, `/rehearsed`; if a run was refused because the stored program differs from the one sent,
// `/refused` and
// `/as_it_is`.
#include <string>

#include "gui/shell/frame.h"
#include "gui/surface/ui.h"
#include "panels/refusal_card.h"

namespace hw::panels {

inline constexpr float thread_row_height = 32;

class Threads {
 public:
  /// Draws all rows over the full width of the panel, from `top_px` down.
  void draw(gui::Frame& frame, float top_px);

 private:
  void draw_row(gui::Frame& frame, int n, const gui::Rect& row);
  void draw_first_button(gui::Frame& frame, int n, std::string_view no_link, bool words);
  void run(gui::Frame& frame, int n, bool as_it_is);
  void follow(gui::Frame& frame);
  void draw_refusal(gui::Frame& frame, int n, const gui::Rect& row);

  int thread_ = -1;  ///< run last
  IntentId asked_ = 0;
  std::string refused_;
  RefusalCard card_;
};
/// Logical; 0: this controller runs only one program at a time.
float threads_height(const Catalog& catalog, float width);
/// Its program is running, waiting or held.
bool is_busy(const ThreadState& thread);

}  // namespace hw::panels
