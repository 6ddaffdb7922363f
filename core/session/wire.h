#pragma once
// An open wire to a controller, and how a session opens one without knowing the transports.
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
  /// Carries out device and wire commands (Unplug, Garble, Drop act on the wire).
  virtual Result<> operate(const BenchCommand& command) = 0;
  virtual void look(BenchView& view) const = 0;
  /// See Emulator::begin_like().
  virtual void begin_like(const ControllerState& state, const Catalog& catalog) = 0;
  /// At the present time; for the record of trigger pulses.
  [[nodiscard]] virtual const Emulator& emulator() const = 0;
  /// Called (io thread) when the result of look() may have changed, by itself or by operate().
  std::function<void()> changed;
};

/// Either `stream` or `window` is set.
struct Wire {
  std::unique_ptr<Stream> stream;
  std::unique_ptr<Window> window;
  /// One for each device, in the order of the address's ids; empty: no emulators of this process.
  std::vector<std::shared_ptr<BenchAccess>> benches;
  std::shared_ptr<WillKeeper> keeper;  ///< null: no watchdog runs
};

/// Resumes with an open wire or a fault that names the place. `again`: a bench of the lost wire, so that an
/// unplugged emulator is reopened as the same emulator; or null.
using WireOpener = std::function<Task<Result<Wire>>(Scheduler& scheduler, Address address,
                                                    std::shared_ptr<BenchAccess> again)>;

}  // namespace hw
