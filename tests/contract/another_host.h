#pragma once
// Another program on the same wire.
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/session/session.h"

namespace hw {

/// Sends these bytes to the emulated controller of `session`, from another end of its wire. `run` lets time
/// pass.
void send_as_another(IoContext& io, Session& session, const std::function<void(Duration)>& run,
                     const std::string& bytes);

/// What the suite sends to a controller in its own protocol. The first three come from another program.
struct WireTexts {
  std::string_view model;
  std::string_view stop;        ///< the first axis, with its ramp
  std::string_view zero;        ///< its count
  std::string_view short_move;  ///< of it, 100 steps on
  std::string_view question;    ///< typed: where is it?
  std::string_view setting;     ///< typed: its speed from now on
};
/// The row of this controller. A test fails, and names the file, if it has none.
const WireTexts& wire_texts(std::string_view model);

}  // namespace hw
