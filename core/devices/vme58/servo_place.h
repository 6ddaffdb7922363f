#pragma once
// Whether a servo axis has come to where it is sent, by what is seen of its command and its encoder.
#include <cstdint>
#include <optional>

#include "core/device/snapshot.h"
#include "core/time/clock.h"

namespace hw::vme58 {

/// HD where it is set; else what HD leaves open (decision M80: it starts at 0, which no loop holds).
inline constexpr std::int64_t usual_deadband = 10;

class ServoPlace {
 public:
  static constexpr Duration to_be_sure = Millis(100);            ///< so long within the band: it is in place
  static constexpr Duration patience = std::chrono::seconds(2);  ///< and after so long without that it is not

  /// One reading. `turns`: its command is on its way. What stands when it is first seen has long stood there.
  void look(Instant at, bool turns, std::int64_t error, std::int64_t band);
  /// Something else than its command sends it on its way: it has as long to come there as behind a command.
  void begin(Instant at);
  /// following, in_place or off_place; unknown: nothing has been seen yet.
  [[nodiscard]] Loop place() const { return place_; }
  /// Nobody can say yet whether it comes there.
  [[nodiscard]] bool undecided() const { return place_ == Loop::following; }
  /// So it is, and its command has ended.
  [[nodiscard]] bool settles() const { return undecided() && !turns_; }

 private:
  Loop place_ = Loop::unknown;
  bool turns_ = false;
  Instant due_since_{};  ///< its command has stood since then, or it has left its place then
  std::optional<Instant> within_since_;
};

}  // namespace hw::vme58
