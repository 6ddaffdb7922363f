#pragma once
// A sequence that controllers of one axis each do together on their wire, done beforehand: by emulators of
// them, through the console's own conversation, at the pace of the wire, in virtual time.
#include <vector>

#include "core/device/controller_state.h"
#include "core/sequence/sequence.h"
#include "core/session/wire.h"

namespace hw {

struct RehearsedTogether {
  double duration_s = 0;
  std::vector<double> piece_seconds;  ///< of each, with the way to it
};

/// `bus`: their address, of emulators or not. `states`: of each, in the order of their ids; empty: as after
/// power-up. The fault says why it does not come to its end within `at_most`. Long: on a worker's thread.
[[nodiscard]] Result<RehearsedTogether> rehearse_together(const sequence::Sequence& sequence,
                                                          const Address& bus,
                                                          const std::vector<ControllerState>& states,
                                                          const WireOpener& opener, Duration at_most);

}  // namespace hw
