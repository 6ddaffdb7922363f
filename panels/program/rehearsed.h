#pragma once
// Says whether Run would run the text as rehearsed, from the present state of the controller.
#include <string>
#include <string_view>

#include "gui/model/rehearsals.h"
#include "gui/shell/frame.h"

namespace hw::panels {

struct Rehearsed {
  bool holds = false;      ///< the rehearsal is of this text, from here, without findings
  std::string_view words;  ///< otherwise the change since then, or the outcome
};
/// For the chosen text, as Run would start it.
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame);
/// For a run that starts a stored program of the controller and loads nothing.
[[nodiscard]] Rehearsed rehearsed_thread(const gui::Frame& frame, int program);
/// `text` is the text that would be run; `outcome` is null if there is none.
[[nodiscard]] Rehearsed rehearsed(const gui::Frame& frame, const gui::Rehearsals::Outcome* outcome,
                                  const std::string& text);

}  // namespace hw::panels
