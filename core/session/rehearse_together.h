#pragma once
// What is done act by act or in pieces, done beforehand: by emulators of the controllers, through the
// console's own conversation, at the pace of the wire, in virtual time.
#include <memory>
#include <vector>

#include "core/device/controller_state.h"
#include "core/device/language.h"
#include "core/device/pieces.h"
#include "core/sequence/sequence.h"
#include "core/session/wire.h"

namespace hw {

/// Of the axes of their catalog_together(); its outputs are those of the one that switches the tool. Events
/// name the steps of the sequence, as places in its own list, when they are begun.
struct RehearsedTogether : Rehearsal {
  std::vector<double> piece_seconds;  ///< of each that was done, with the way to it
};

/// One controller's pieces, as far as they came in the time that they had.
struct RehearsedPieces {
  struct Arrival {
    int step = 0;  ///< as PiecesState::step tells it
    double t = 0;
  };
  double duration_s = 0;
  bool finished = false;
  std::vector<Arrival> came_to;  ///< both grow
  /// What the console would tell the user on the way, that lines go slower than asked for one; may be empty.
  std::string told;
  /// At which time it came to this step, or would come, were the way even between two that it told.
  [[nodiscard]] double when(int step) const;
};

/// Controllers of one axis each do it together. `bus`: their address, of emulators or not. `states`: of each,
/// in the order of their ids; empty: as after power-up. The fault says why it was broken off; what only took
/// longer than `at_most` is no fault. Long: on a worker's thread.
[[nodiscard]] Result<RehearsedTogether> rehearse_together(const sequence::Sequence& sequence,
                                                          const Address& bus,
                                                          const std::vector<ControllerState>& states,
                                                          const WireOpener& opener, Duration at_most);

/// The same of one controller, its motors with power and the loops open that must be. The fault says why it
/// was broken off; what only took too long is no fault.
[[nodiscard]] Result<RehearsedPieces> rehearse_pieces(std::shared_ptr<const Pieces> pieces,
                                                      const Address& controller, const ControllerState& state,
                                                      const WireOpener& opener, Duration at_most);

}  // namespace hw
