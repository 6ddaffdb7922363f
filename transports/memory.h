#pragma once
// A wire inside this process. Bytes sent at one end are posted to the other end in order, so that a virtual
// run replays exactly.
#include <memory>
#include <string>
#include <utility>

#include "core/link/stream.h"
#include "core/time/scheduler.h"

namespace hw {

struct MemoryWire {
  std::string name = "memory";  ///< for describe()
  int baud = 0;                 ///< common rate, which both ends read and set; 0: none
  Fault gone =
      Fault(FaultKind::lost, "The other end of the wire is gone.");  ///< fault reported to the remaining end
};

/// Destroying one end closes the other.
std::pair<std::unique_ptr<Stream>, std::unique_ptr<Stream>> make_memory_pair(Scheduler& scheduler,
                                                                             MemoryWire wire = {});

}  // namespace hw
