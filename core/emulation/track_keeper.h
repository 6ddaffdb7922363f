#pragma once
// Records the positions of a rehearsal: at each event, and at intervals while something moves.
#include <optional>
#include <vector>

#include "core/device/language.h"
#include "core/device/track.h"
#include "core/emulation/emulator.h"

namespace hw {

class TrackKeeper {
 public:
  /// Keeps nothing where the options do not ask for it.
  TrackKeeper(const Emulator& emulator, const RehearseOptions& options)
      : emulator_(emulator), every_(from_seconds(options.track_every_s)) {}

  /// When the next sample is due. None: at the next event.
  [[nodiscard]] std::optional<Instant> next() const { return due_; }
  /// To be called when the emulator has advanced to `now`.
  void look(Instant now);
  [[nodiscard]] std::vector<RehearsedPlace> take() { return track_.take(); }

 private:
  const Emulator& emulator_;
  const Duration every_;
  std::optional<Instant> due_;
  Track track_;
};

}  // namespace hw
