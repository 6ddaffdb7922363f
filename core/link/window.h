#pragma once
// What a transport implements for a controller that is no stream of bytes but a piece of memory on a bus:
// each access is a cycle of its own and may have an effect. Io thread only.
//
// Offsets are those within the window; big-endian. A cycle of 4 bytes is two of 2 bytes, high half first.
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
  std::uint32_t value = 0;  ///< of a read: put here

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
    /// The controller has interrupted its host with this vector. Not every way to a bus tells of interrupts.
    virtual void interrupted(std::uint8_t vector) = 0;
  };

  virtual ~Window() = default;
  /// Null: nobody listens.
  virtual void listen(Listener* listener) = 0;
  /// All cycles in their order; the values of reads are put in place. One call at a time. A fault: some of
  /// them may have been done. `cycles` outlives the call.
  virtual Task<Result<>> run(std::span<BusCycle> cycles) = 0;
  /// Nobody wants what a run() that is under way will bring: it ends soon, with a fault.
  virtual void abandon() {}
  /// Interrupts of the controller reach its host this way. False: they must stay off.
  [[nodiscard]] virtual bool tells_interrupts() const { return false; }
  /// How a watchdog reaches it too; none: it ends with this program.
  [[nodiscard]] virtual WireShare share() const { return {}; }
  /// Where it leads, for a person: "bus port 127.0.0.1:5000".
  [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace hw
