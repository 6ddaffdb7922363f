#pragma once
// The wire of sessions that were opened together. The first session that needs it opens it; it closes when
// the last session has left. A controller with a wire of its own is the only user. Io thread only.
#include <memory>
#include <vector>

#include "core/device/line.h"
#include "core/link/link.h"
#include "core/session/wire.h"

namespace hw {

class SharedWire : public std::enable_shared_from_this<SharedWire> {
 public:
  /// `address` names the wire with all devices on it.
  SharedWire(Scheduler& scheduler, Address address, WireOpener opener);

  /// The open link. All callers during one opening get the same result.
  Task<Result<std::shared_ptr<Link>>> link();
  /// The sessions on it.
  [[nodiscard]] const std::shared_ptr<Line>& line() const { return line_; }
  /// The bench of the device at `place` in the order of the address's ids; null: not an emulator of this
  /// process.
  [[nodiscard]] std::shared_ptr<BenchAccess> bench(std::size_t place) const;

 private:
  Task<Result<Wire>> open();
  [[nodiscard]] Address address_now();
  // Devices that lost the wire together reopen it together; one attempt serves all.
  static constexpr Duration same_attempt = Millis(20);

  Scheduler& scheduler_;
  const Address address_;
  const WireOpener opener_;
  const std::shared_ptr<Line> line_ = std::make_shared<Line>();
  std::weak_ptr<Link> link_;
  std::vector<std::shared_ptr<BenchAccess>> benches_;
  bool opening_ = false;
  Event opened_;
  std::optional<Fault> failure_;  ///< of the latest attempt
  Instant failed_at_{};
  int rate_set_ = 0;  ///< by a controller's set-up since the wire was opened; 0: the address's rate
  bool rate_set_is_next_ = false;
};

}  // namespace hw
