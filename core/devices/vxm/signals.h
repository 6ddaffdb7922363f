#pragma once
// Reads limits, inputs, outputs and the analog input, and shows them once the readings are certain. A
// one-byte reply may be any byte: it counts once a question of another kind has been answered after it with
// no unexpected byte in between. After the line was dirty, two such readings must agree.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "core/device/in_turn.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/identification.h"

namespace hw::vxm {

class Signals {
 public:
  Signals(const Console& console, Conversation& conversation, Identification& identification)
      : scheduler_(console.scheduler),
        snapshot_(console.snapshot),
        changed_(console.changed),
        conversation_(conversation),
        identification_(identification) {}

  /// A new wire.
  void begin();
  /// Readings from before the line was dirty become unknown until read again.
  void forget_doubtful();

  /// Reads all, more than once where one reading is not enough.
  Task<Result<>> read_all(Priority priority);
  /// Reads `which` of ?, ~ and $ until their present state is shown, except those not reported. `which` must
  /// outlive it.
  Task<Result<>> read(std::string_view which, Priority priority);
  /// See Driver::watch_inputs().
  void watch_inputs(Instant until) { inputs_until_ = until; }
  void watch_limits(Instant until) { limits_until_ = until; }
  /// Reads watched inputs and limits and shows them at once. Call between two other questions of a round.
  Task<Result<>> glance(Priority priority);
  /// Asks the next of all in turn. Must be followed by another question, and that by confirm().
  Task<Result<>> ask_next(Priority priority);
  /// Asks ?, ~ or $; to be followed in the same way.
  Task<Result<>> ask(char which, Priority priority);
  /// When ask_next() was last called.
  [[nodiscard]] Instant asked_at() const { return asked_at_; }
  /// Another question has been answered. False: the readings are not believed yet.
  bool confirm();

 private:
  static constexpr std::string_view all = "?~$";
  Task<Result<>> read_analog(Priority priority);
  [[nodiscard]] bool is_reported(char which) const {
    return which != '$' || identification_.reports_outputs();
  }
  bool believe(std::size_t which, unsigned char byte);
  void show(std::size_t which, unsigned char byte);

  Scheduler& scheduler_;
  Snapshot& snapshot_;
  std::function<void()> changed_;
  Conversation& conversation_;
  Identification& identification_;
  std::array<std::optional<unsigned char>, 3> asked_{};  ///< answered, to be confirmed
  std::array<std::optional<unsigned char>, 3> once_{};   ///< read once since the line was cleaned
  std::array<std::uint32_t, 3> cleaned_{};               ///< times_cleaned() when last believed
  std::uint32_t unexpected_ = 0;                         ///< count before the first of `asked_`
  InTurn turn_;
  Instant asked_at_{};
  Instant limits_at_{};                      ///< read last
  Instant inputs_until_{}, limits_until_{};  ///< watched until then
  Instant inputs_asked_at_{};
};

}  // namespace hw::vxm
