#include "gui/model/records.h"

#include <utility>

namespace hw::gui {

void Records::add(const Ending& ending, const Catalog& catalog, const EventLog::ShowPosition& position) {
  events.add(ending, catalog, position);
  stop_times.add(ending, position);
}

void Records::note(std::string words, Instant clock) {
  events.add({LoggedEvent::Mark::message, false, clock, {}, std::move(words), -1});
}

}  // namespace hw::gui
