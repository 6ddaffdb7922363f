#pragma once
// Limits, inputs, outputs and the analog input: read, and shown once they can be believed. An answer of one
// byte may be any byte, so it counts when a question of another kind has been answered behind it and nothing
// strayed in between; after the line was dirty two such readings must agree.
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "core/device/in_turn.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/nameplate.h"

namespace hw::vxm {

class Signals {
 public:
  Signals(const Console& console, Conversation& talk, Nameplate& nameplate)
      : scheduler_(console.scheduler),
        draft_(console.draft),
        changed_(console.changed),
        talk_(talk),
        nameplate_(nameplate) {}

  /// A new wire.
  void begin();
  /// What was read before the line was dirty, and not since, is not known.
  void forget_what_is_doubted();

  /// All of them, more than once where one reading is not enough.
  Task<Result<>> read_all(Priority priority);
  /// ?, ~ or $, until it is shown as it is now; nothing where it tells none.
  Task<Result<>> read(char which, Priority priority);
  /// See Driver::watch_inputs().
  void watch_inputs(Instant until) { watched_until_ = until; }
  /// Between two other questions of a round: the inputs, told at once. Nothing while nobody watches them.
  Task<Result<>> glance(Priority priority);
  /// The next of all in turn; to be followed by another question, and that by confirm().
  Task<Result<>> ask_next(Priority priority);
  /// ?, ~ or $, followed in the same way.
  Task<Result<>> ask(char which, Priority priority);
  /// The latest question of these.
  [[nodiscard]] Instant asked_at() const { return asked_at_; }
  /// Something else has been answered. False: what was asked is not believed yet.
  bool confirm();

 private:
  static constexpr std::string_view all = "?~$";
  Task<Result<>> read_analog(Priority priority);
  [[nodiscard]] bool is_told(char which) const { return which != '$' || nameplate_.tells_outputs(); }
  bool believe(std::size_t which, unsigned char byte);
  void show(std::size_t which, unsigned char byte);

  Scheduler& scheduler_;
  Snapshot& draft_;
  std::function<void()> changed_;
  Conversation& talk_;
  Nameplate& nameplate_;
  std::array<std::optional<unsigned char>, 3> asked_{};  ///< answered, to be confirmed
  std::array<std::optional<unsigned char>, 3> once_{};   ///< read once since the line was cleaned
  std::array<std::uint32_t, 3> cleaned_{};               ///< how often it had been, when this was believed
  std::uint32_t strays_ = 0;                             ///< before the first of `asked_`
  InTurn turn_;
  Instant asked_at_{};
  Instant limits_at_{};  ///< read last
  Instant watched_until_{}, inputs_asked_at_{};
};

}  // namespace hw::vxm
