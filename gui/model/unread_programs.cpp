#include "gui/model/unread_programs.h"

#include <utility>

#include "core/device/controller_state.h"

namespace hw::gui {

void UnreadPrograms::begin() {
  wanted_.clear(), asked_.clear();
  reading_ = 0;
}

bool UnreadPrograms::found(const Rehearsal& rehearsal, int rehearsed) {
  if (std::exchange(looked_at_, rehearsed) == rehearsed) return false;
  for (const RehearsedAssumption& assumption : rehearsal.assumptions)
    if (const auto slot = unread_slot(assumption); slot && asked_.insert(*slot).second) wanted_.insert(*slot);
  return !wanted_.empty();
}

bool UnreadPrograms::have_been_read(const Snapshot& now, const Send& send) {
  if (reading_ != 0) {
    const IntentFate* fate = now.fate_of(reading_);
    const bool settled = fate ? fate->fate != Fate::pending : now.forgotten(reading_);
    if (!settled) return false;
    reading_ = 0;
  }
  if (wanted_.empty()) return true;
  reading_ = send(intent::UploadProgram(wanted_.extract(wanted_.begin()).value()));
  return reading_ == 0;
}

}  // namespace hw::gui
