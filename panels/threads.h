#pragma once
// The programs that run at once, a row each: state in words, low-level line, the source line it came from,
// and the buttons that suit. Ids: `thread/0/run`, `/pause`, `/continue`, `/stop`, `/state`, `/line`,
// `/source`.
#include "gui/frame.h"
#include "gui/ui.h"

namespace hw::panels {

inline constexpr float thread_row_height = 32;

/// All rows, over the whole width of the panel, from `top_px` down.
void draw_threads(gui::Frame& frame, float top_px);
/// Logical; 0: this controller runs one program at a time.
float threads_height(const Catalog& catalog, float width);
/// Busy with its program: running, waiting or held.
bool is_busy(const ThreadState& thread);

}  // namespace hw::panels
