#pragma once
// An opened way to a controller, and how a session gets one without knowing the transports.
#include <functional>
#include <memory>
#include <vector>

#include "core/base/asio.h"
#include "core/device/bench.h"
#include "core/link/last_will.h"
#include "core/link/stream.h"
#include "core/link/window.h"
#include "core/session/address.h"
#include "core/time/scheduler.h"

namespace hw {

class Emulator;
struct Catalog;
struct ControllerState;

/// The bench of an emulator in this process. Io thread only.
class BenchAccess {
 public:
  virtual ~BenchAccess() = default;
  /// Device and wire faults alike (Unplug, Garble, Drop are done on the wire).
  virtual Result<> operate(const BenchCommand& command) = 0;
  virtual void look(BenchView& view) const = 0;
  /// See Emulator::begin_like().
  virtual void begin_like(const ControllerState& state, const Catalog& catalog) = 0;
  /// At present time; for the record of trigger pulses.
  [[nodiscard]] virtual const Emulator& emulator() const = 0;
  /// Called (io thread) when something of look() may have changed by itself or by operate().
  std::function<void()> changed;
};

/// Exactly one of the two.
struct Wire {
  std::unique_ptr<Stream> stream;
  std::unique_ptr<Window> window;
  /// One for each device on it, in the order of the address's ids; empty: no emulators of ours.
  std::vector<std::shared_ptr<BenchAccess>> benches;
  std::shared_ptr<WillKeeper> keeper;  ///< null: there is no watchdog
};

/// Resumes with an open wire or a fault that names the place. An emulator that was unplugged opens again as
/// the same emulator: `again` is a bench of the wire that was lost, or null.
using WireOpener = std::function<Task<Result<Wire>>(Scheduler& scheduler, Address address,
                                                    std::shared_ptr<BenchAccess> again)>;

}  // namespace hw
