#pragma once
// Actions that each set one readout to a different value (ActionInfo::sets): a choice that shows the present
// value, or a lamp for on and off.
#include <vector>

#include "gui/shell/frame.h"
#include "panels/control/action_form.h"

namespace hw::panels {

/// The action is one of several that set a readout.
[[nodiscard]] bool is_of_choice(const Catalog& catalog, const ActionForm& action);
/// End of the run of actions that set the same readout as the one at `first`.
[[nodiscard]] std::size_t end_of_choice(const Catalog& catalog, const std::vector<ActionForm>& actions,
                                        std::size_t first);
/// Draws that run under the name of its readout, at ImGui's cursor; leaves the cursor below. `width` logical.
void draw_action_choice(gui::Frame& frame, std::vector<ActionForm>& actions, std::size_t first, float width);

/// An action of one number whose effect a readout shows: name, field, button and readout in one line.
[[nodiscard]] bool is_setter(const Catalog& catalog, const ActionForm& action);
inline constexpr float setter_height = 40;
void draw_setter(gui::Frame& frame, ActionForm& action, float width);

}  // namespace hw::panels
