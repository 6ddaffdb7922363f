#pragma once
// A bus over TCP with a message for each cycle: op (01, 02, 04: read so many bytes; 81, 82, 84: write), two
// bytes of offset within the window, and for writes the value. The reply to a read is the value; a write has
// no reply. All values are big-endian. Interrupts are not transmitted.
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/link/stream.h"
#include "core/link/window.h"
#include "core/time/scheduler.h"

namespace hw {

/// Connects to "HOST:PORT". Fails after `patience` without a connection.
Task<Result<std::unique_ptr<Window>>> open_bus_port(Scheduler& scheduler, std::string where,
                                                    Duration patience = Millis(5000));
/// A bus port over an existing connection.
std::unique_ptr<Window> make_bus_port(Scheduler& scheduler, std::unique_ptr<Stream> stream,
                                      std::string where);

/// Appends the message of a cycle.
void append_bus_message(std::string& bytes, const BusCycle& cycle);

/// The board's side of a connection: parses messages and builds replies. No I/O.
class BusPortTalk {
 public:
  /// Passes each cycle to `perform` and appends the values read to `answers`. Fails if the bytes are not bus
  /// port messages, so that the start of the next message is unknown, or if a cycle is beyond the window.
  Result<> take(std::string_view bytes, const std::function<void(BusCycle&)>& perform, std::string& answers);

 private:
  std::string unfinished_;
};

}  // namespace hw
