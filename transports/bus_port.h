#pragma once
// A bus over TCP: each cycle is a message. Op (01, 02, 04: read so many bytes; 81, 82, 84: write), two bytes
// of offset within the window, for writes the value; the answer to a read is the value, a write has none. All
// big-endian. Interrupts do not pass.
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/link/stream.h"
#include "core/link/window.h"
#include "core/time/scheduler.h"

namespace hw {

/// Connects to "HOST:PORT".
Task<Result<std::unique_ptr<Window>>> open_bus_port(Scheduler& scheduler, std::string where,
                                                    Duration patience = Millis(5000));
/// The same over a connection that is already made.
std::unique_ptr<Window> make_bus_port(Scheduler& scheduler, std::unique_ptr<Stream> stream,
                                      std::string where);

/// The message of one cycle.
void append_bus_message(std::string& bytes, const BusCycle& cycle);

/// The board's side of one connection: takes messages apart and puts answers together. No I/O.
class BusPortTalk {
 public:
  /// Gives each cycle to `perform`, adds what a read brought to `answers`. A fault: the bytes are no messages
  /// of a bus port, and where the next one begins cannot be known; or a cycle lies beyond the window.
  Result<> take(std::string_view bytes, const std::function<void(BusCycle&)>& perform, std::string& answers);

 private:
  std::string unfinished_;
};

}  // namespace hw
