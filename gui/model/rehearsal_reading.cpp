#include "gui/model/rehearsal_reading.h"

#include <string_view>

namespace hw::gui {

bool awaits_set_up(IntentId& asked, const Snapshot& now, const UnreadPrograms::Send& send) {
  if (asked == 0) asked = send(intent::ReadParams());
  const IntentOutcome* outcome = now.outcome_of(asked);
  const bool settled = outcome ? outcome->state != IntentState::pending : now.forgotten(asked);
  return !settled && asked != 0;
}

bool reached_unread(UnreadPrograms& unread, const Rehearsals::Outcome& outcome, const Snapshot& now,
                    const Catalog& catalog) {
  if (!outcome.result) return false;
  const VariableFacts& variables = catalog.variables;
  const std::string_view variable = variables.count > 0 ? std::string_view(variables.prefix) : "";
  if (!unread.found(*outcome.result, outcome.number, variable)) return false;
  const bool runs = now.program.run != RunState::idle && now.program.run != RunState::error;
  return now.link.connected() && !runs && !now.any_axis_moving();
}

}  // namespace hw::gui
