#pragma once
// Where the axes of a rehearsal are: at each event, and every so often while something moves.
#include <optional>
#include <utility>
#include <vector>

#include "core/device/emulator.h"
#include "core/device/language.h"

namespace hw {

class TrackKeeper {
 public:
  /// Keeps nothing where the options do not ask for it.
  TrackKeeper(const Emulator& emulator, const RehearseOptions& options)
      : emulator_(emulator), every_(from_seconds(options.track_every_s)) {}

  /// When it wants to look next. None: not before the next event.
  [[nodiscard]] std::optional<Instant> next() const { return due_; }
  /// The emulator has come to this time.
  void look(Instant now);
  [[nodiscard]] std::vector<RehearsedPlace> take() { return std::move(track_); }

 private:
  void thin_out();

  const Emulator& emulator_;
  Duration every_;
  std::optional<Instant> due_;
  std::vector<RehearsedPlace> track_;
};

}  // namespace hw
