#pragma once
// How a motion or a program ended, as a sentence in the units of the console.
#include <functional>
#include <string>

#include "core/device/catalog.h"
#include "core/device/snapshot.h"
#include "gui/model/event_log.h"

namespace hw::gui {

using ShowPosition = std::function<std::string(AxisId, Steps)>;

LoggedEvent event_of(const Ending& ending, const Catalog& catalog, const ShowPosition& position);
/// Of a motion that ended with its program, list or drawing: the facts that the words for that leave out, to
/// be appended to them.
std::string words_beside_run(const Ending& motion, const Ending& run, const Catalog& catalog,
                             const ShowPosition& position);

}  // namespace hw::gui
