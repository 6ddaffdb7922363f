#pragma once
// Draws a row for each program that runs at the same time: state in words, low-level line, its source line,
// and the buttons that apply. Ids: `thread/0/run`, `/pause`, `/continue`, `/stop`, `/state`, `/line`,
// `/source`, `/rehearsed`; if a run was refused because the stored program differs from the one sent,
// `/refused` and `/as_it_is`.
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

  int thread_ = -1;  ///< thread that was run last
  IntentId asked_ = 0;
  std::string refused_;
  RefusalCard card_;
};
/// The height, logical; 0: this controller runs only one program at a time.
float threads_height(const Catalog& catalog, float width);
/// Whether the program of the thread is running, waiting or held.
bool is_busy(const ThreadState& thread);

}  // namespace hw::panels
