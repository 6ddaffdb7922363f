#pragma once
// The interface of a transport for a controller that is memory on a bus instead of a stream of bytes: each
// access is a cycle of its own and may have an effect. Io thread only.
//
// Offsets are within the window; big-endian. A cycle of 4 bytes is two of 2 bytes, high half first.
#include <cstdint>
#include <span>
#include <string>

#include "core/base/asio.h"
#include "core/base/result.h"
#include "core/link/wire_share.h"

namespace hw {

struct BusCycle {
  bool write = false;
  std::uint8_t width = 2;  ///< bytes: 1, 2 or 4
  std::uint16_t offset = 0;
  std::uint32_t value = 0;  ///< written, or read into here

  BusCycle() = default;
  static BusCycle read(std::uint8_t bytes, std::uint16_t at) { return BusCycle(false, bytes, at, 0); }
  static BusCycle store(std::uint8_t bytes, std::uint16_t at, std::uint32_t what) {
    return BusCycle(true, bytes, at, what);
  }

 private:
  BusCycle(bool w, std::uint8_t bytes, std::uint16_t at, std::uint32_t what)
      : write(w), width(bytes), offset(at), value(what) {}
};

class Window {
 public:
  /// Called from the io thread, never from inside run().
  class Listener {
   public:
    virtual ~Listener() = default;
    /// The window is gone (cable pulled, peer closed, device removed). Every run() fails from now on.
    virtual void window_closed(const Fault& why) = 0;
    /// The controller has interrupted its host with this vector. Not every transport reports interrupts.
    virtual void interrupted(std::uint8_t vector) = 0;
  };

  virtual ~Window() = default;
  /// Null: interrupts and the end are not reported.
  virtual void listen(Listener* listener) = 0;
  /// Runs all cycles in order and stores the values read. One call at a time. After a fault some cycles may
  /// have been done. `cycles` must outlive the call.
  virtual Task<Result<>> run(std::span<BusCycle> cycles) = 0;
  /// Ends a run() that is under way soon, with a fault.
  virtual void abandon() {}
  /// Interrupts of the controller are reported. False: they must stay off.
  [[nodiscard]] virtual bool reports_interrupts() const { return false; }
  /// How the watchdog reaches the window; none: it ends with this program.
  [[nodiscard]] virtual WireShare share() const { return {}; }
  /// A name for the user: "bus port 127.0.0.1:5000".
  [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace hw
