#pragma once
// Draws actions that each set a readout to another value (ActionInfo::sets) as a choice that shows the
// present value, or as a lamp for on and off.
#include <vector>

#include "gui/shell/frame.h"
#include "panels/control/action_form.h"

namespace hw::panels {

/// Whether the action is one of several that set a readout.
[[nodiscard]] bool is_of_choice(const Catalog& catalog, const ActionForm& action);
/// End of the run of actions that set the same readout as the one at `first`.
[[nodiscard]] std::size_t end_of_choice(const Catalog& catalog, const std::vector<ActionForm>& actions,
                                        std::size_t first);
/// Draws that run below the name of its readout, at ImGui's cursor; leaves the cursor below. `width` is
/// logical.
void draw_action_choice(gui::Frame& frame, std::vector<ActionForm>& actions, std::size_t first, float width);

/// Whether the action has one number and a readout that shows its effect. Name, field, button and readout are
/// then in one line.
[[nodiscard]] bool is_setter(const Catalog& catalog, const ActionForm& action);
inline constexpr float setter_height = 40;
void draw_setter(gui::Frame& frame, ActionForm& action, float width);

}  // namespace hw::panels
