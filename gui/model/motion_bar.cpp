#include "gui/model/motion_bar.h"

#include <fmt/core.h>

#include "core/device/refusals.h"
#include "gui/model/status_sentence.h"

namespace hw::gui {

MotionBar::MotionBar(const Catalog& catalog) : catalog_(catalog) {
  for (std::size_t i = 0; i < catalog.axes.size() && i < power_is_off_.size(); ++i)
    power_is_off_[i] = fmt::format("Motor power of {} is off. Switch it on first.", catalog.axes[i].name);
}

std::string_view MotionBar::why(AxisId axis, const Snapshot& now) const {
  if (!why_.empty() || !powerless(catalog_, now, axis)) return why_;
  return power_is_off_[axis.index];
}

void MotionBar::refresh(const Snapshot& now) {
  if (known_ && link_ == now.link.state && program_ == now.program) return;
  known_ = true;
  link_ = now.link.state;
  program_ = now.program;
  const ProgramState& p = program_;
  const bool busy =
      p.owned && (p.run == RunState::running || p.run == RunState::waiting || p.run == RunState::held);
  if (link_ == LinkState::connecting)
    why_ = "The controller is being identified. Jog, Go and Home are available when it has answered.";
  else if (link_ == LinkState::lost || link_ == LinkState::closed)
    why_ = "There is no link. Jog, Go and Home are available again when the controller answers.";
  else if (busy)
    why_ = fmt::format("{} {} {}. Jog, Go and Home are available again when it ends or is stopped.",
                       catalog_.program.slot_word, p.slot,
                       p.run == RunState::running ? "is running"
                       : p.run == RunState::held  ? "is held"
                                                  : "waits");
  else
    why_.clear();
}

}  // namespace hw::gui
