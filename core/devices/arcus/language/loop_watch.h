#pragma once
// Detects a thread that repeats a loop without effect: it reads inputs and variables, changes nothing, and
// would do so for ever (`WHILE DI1=0 ... ENDWHILE`). Such a thread needs no turns until one of the values it
// has read changes; then it continues at the statement it would have reached by now.
#include <array>
#include <cstdint>
#include <optional>

#include "core/devices/arcus/language/program.h"

namespace hw::arcus::language {

using Turn = std::int64_t;  ///< milliseconds since the clock's start

class LoopWatch {
 public:
  /// The actions of the thread, in their order.
  void runs(std::uint16_t line, Turn turn);
  void has_read(const Operand& what, std::int32_t value);
  void has_changed_something() { tracking_ = idle_ = false; }
  /// ENDWHILE sends the thread back to `head`, which runs at `turn`.
  void goes_round(std::uint16_t head, Turn turn);

  [[nodiscard]] bool idle() const { return idle_; }
  /// Whether all values read in the loop are unchanged. `read(operand)` gives present values.
  template <class Read>
  [[nodiscard]] bool unchanged(const Read& read) const {
    for (int i = 0; i < reads_; ++i)
      if (read(seen_[static_cast<std::size_t>(i)].what) != seen_[static_cast<std::size_t>(i)].value)
        return false;
    return true;
  }
  struct Place {
    std::uint16_t line;
    Turn turn;
  };
  /// The next statement of an idle thread from `turn` on.
  [[nodiscard]] Place place_at(Turn turn) const;
  /// The statement that an idle thread has run last, at `turn` or before; nothing: it is at the loop's head.
  [[nodiscard]] std::optional<std::uint16_t> ran_last(Turn turn) const;

 private:
  struct Step {
    std::uint16_t line = 0;
    std::uint16_t offset = 0;  ///< turns after the loop's head
  };
  struct Seen {
    Operand what;
    std::int32_t value = 0;
  };
  void track(Turn turn);

  bool tracking_ = false, idle_ = false;
  std::uint8_t steps_ = 0, reads_ = 0;
  Turn start_ = 0;  ///< when the head ran (tracking), or runs (idle)
  Turn period_ = 0;
  std::array<Step, 24> trace_;
  std::array<Seen, 12> seen_;
};

}  // namespace hw::arcus::language
