#include "gui/model/unread_programs.h"

#include <algorithm>
#include <utility>

#include "core/device/controller_state.h"

namespace hw::gui {

static bool is_variable(std::string_view name, std::string_view prefix) {
  if (prefix.empty() || !name.starts_with(prefix) || name.size() == prefix.size()) return false;
  name.remove_prefix(prefix.size());
  return std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void UnreadPrograms::begin() {
  wanted_.clear(), asked_.clear(), wanted_variables_.clear(), asked_variables_.clear();
  reading_ = 0;
}

bool UnreadPrograms::found(const Rehearsal& rehearsal, int rehearsed, std::string_view variable) {
  if (std::exchange(looked_at_, rehearsed) == rehearsed) return false;
  for (const RehearsedAssumption& assumption : rehearsal.assumptions)
    if (const auto slot = unread_slot(assumption); slot && asked_.insert(*slot).second) wanted_.insert(*slot);
  for (const RehearsedAssumption& assumption : rehearsal.assumptions)
    if (is_variable(assumption.name, variable) && asked_variables_.insert(assumption.name).second)
      wanted_variables_.insert(assumption.name);
  return !wanted_.empty() || !wanted_variables_.empty();
}

bool UnreadPrograms::have_been_read(const Snapshot& now, const Send& send) {
  if (reading_ != 0) {
    const IntentOutcome* outcome = now.outcome_of(reading_);
    const bool settled = outcome ? outcome->state != IntentState::pending : now.forgotten(reading_);
    if (!settled) return false;
    reading_ = 0;
  }
  if (!wanted_variables_.empty()) {
    reading_ = send(intent::ReadParams(wanted_variables_.extract(wanted_variables_.begin()).value()));
    return reading_ == 0;
  }
  if (wanted_.empty()) return true;
  reading_ = send(intent::UploadProgram(wanted_.extract(wanted_.begin()).value()));
  return reading_ == 0;
}

}  // namespace hw::gui
