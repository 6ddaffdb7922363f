#pragma once
// The places to which a raw text sends the axes: interprets its commands one after another, without time.
// Pure.
#include <array>
#include <optional>
#include <string_view>

#include "core/device/snapshot.h"
#include "core/device/text_goals.h"
#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/selection.h"

namespace hw::vme58 {

/// The moves that MA, MR, MT and ML in texts have prepared for the next GO of their queue. GO takes them
/// (decision M51).
class PreparedMoves {
 public:
  struct Move {
    double counts = 0;
    bool relative = false;
  };
  using Moves = std::array<std::optional<Move>, most_axes>;

  void note(const TextCommand& command, const UserUnits& units);
  /// The board may have carried out the command, or not.
  void doubt(const TextCommand& command);
  /// The moves of the queue that `context` addresses.
  [[nodiscard]] const Moves& of(const Context& context) const { return queues_[queue_of(context)]; }
  void forget() { queues_ = {}; }
  /// Forgets the moves of the axes' own queues, bit per axis, and those of AA and AM.
  void forget(unsigned axes, bool groups);

 private:
  [[nodiscard]] static std::size_t queue_of(const Context& context);
  std::array<Moves, most_axes + 2> queues_{};  ///< of the axes, AA, AM
};

/// `context` and `units`: in which the board reads the text.
TextGoals goals_of(std::string_view text, Context context, const UserUnits& units,
                   const PreparedMoves& prepared, const Snapshot& now);

}  // namespace hw::vme58
