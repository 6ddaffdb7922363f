#pragma once
// Another program on the same wire.
#include <cstdint>
#include <functional>
#include <string>

#include "core/session/session.h"

namespace hw {

/// It says these words to the emulated controller of `session`, by another end of its wire. `run` lets time
/// pass.
void send_as_another(IoContext& io, Session& session, const std::function<void(Duration)>& run,
                     const std::string& words);

}  // namespace hw
