#pragma once
// Who hears of everything that happens to the controllers, at the moment when it happens.
#include <string_view>

#include "core/device/bench.h"
#include "core/emulation/machine_truth.h"

namespace hw::simulation {

class Witness {
 public:
  virtual ~Witness() = default;
  /// Bytes have come to the controller over its wire, after all faults. Of a board: characters in its ring.
  virtual void controller_received(int device, std::string_view bytes) = 0;
  /// A board's mailbox or control register was written.
  virtual void register_written(int device, std::uint16_t offset, std::uint16_t value) = 0;
  virtual void controller_sent(int device, std::string_view bytes) = 0;
  /// How its inputs and outputs stood when it answered.
  virtual void bench_is(int device, const BenchView& view) = 0;
  /// The machine may have changed.
  virtual void machine_is(int device, const MachineTruth& truth) = 0;
};

}  // namespace hw::simulation
