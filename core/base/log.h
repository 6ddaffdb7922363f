#pragma once
// Log lines for a person or a service manager, to stderr. Any thread. Results never go this way.
#include <string_view>

namespace hw::log {

enum class Level { quiet, error, warning, info, debug };

/// Lines above this level are dropped. Starts at `warning`.
void set_level(Level level);

/// `where`: the subject, as a path ("vxm.link").
void error(std::string_view where, std::string_view sentence);
void warning(std::string_view where, std::string_view sentence);
void info(std::string_view where, std::string_view sentence);
void debug(std::string_view where, std::string_view sentence);

}  // namespace hw::log
