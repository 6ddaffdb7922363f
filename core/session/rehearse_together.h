#pragma once
// Rehearses work that is done act by act or in pieces: on emulators of the controllers, through the console's
// own protocol code, at the pace of the wire, in virtual time.
#include <memory>
#include <vector>

#include "core/device/controller_state.h"
#include "core/device/language.h"
#include "core/device/pieces.h"
#include "core/sequence/sequence.h"
#include "core/session/wire.h"

namespace hw {

/// With the axes of catalog_together(); outputs are those of the controller that switches the tool. Each
/// event marks the begin of a step, as an index in the sequence's own list.
struct RehearsedTogether : Rehearsal {
  std::vector<double> piece_seconds;  ///< of each finished piece, with the travel to it
};

/// One controller's pieces, as far as they got in the allowed time.
struct RehearsedPieces {
  struct Arrival {
    int step = 0;  ///< as in PiecesState::step
    double t = 0;
  };
  double duration_s = 0;
  bool finished = false;
  std::vector<Arrival> came_to;  ///< `step` and `t` increase
  /// Messages for the user on the way, for example that lines go slower than asked; may be empty.
  std::string messages;
  /// Time of arrival at `step`, interpolated between reported steps.
  [[nodiscard]] double when(int step) const;
};

/// Rehearses a sequence on controllers of one axis each. `bus`: their address, emulated or not. `states`: one
/// for each, in the order of their ids; empty: as after power-up. The fault says why it was aborted;
/// exceeding `at_most` is no fault. Long: on a worker thread.
[[nodiscard]] Result<RehearsedTogether> rehearse_together(const sequence::Sequence& sequence,
                                                          const Address& bus,
                                                          const std::vector<ControllerState>& states,
                                                          const WireOpener& opener, Duration at_most);

/// The same on one controller, with motor power on and the necessary loops open. The fault says why it was
/// aborted; exceeding `at_most` is no fault.
[[nodiscard]] Result<RehearsedPieces> rehearse_pieces(std::shared_ptr<const Pieces> pieces,
                                                      const Address& controller, const ControllerState& state,
                                                      const WireOpener& opener, Duration at_most);

}  // namespace hw
