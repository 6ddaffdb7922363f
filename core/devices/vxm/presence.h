#pragma once
// Whether and how the controller listens, as far as is known: on-line or in Local mode, halted by an error,
// restarted.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/devices/vxm/conversation.h"

namespace hw::vxm {

class Presence {
 public:
  Presence(const Scheduler& scheduler, Conversation& conversation)
      : scheduler_(scheduler), conversation_(conversation) {}

  /// Sends F until the controller is on-line.
  Task<Result<>> go_on_line();

  // ---- its mode: unknown until it has been asked on this wire
  [[nodiscard]] bool is_unknown() const { return mode_ == Mode::unknown; }
  [[nodiscard]] bool is_on_line() const { return mode_ == Mode::on_line; }
  [[nodiscard]] bool is_local() const { return mode_ == Mode::local; }
  void forget_mode() { mode_ = Mode::unknown; }
  /// The controller has reported so.
  void seen_on_line() {
    mode_ = Mode::on_line;
    restart_counted_ = false;
  }

  // ---- Local mode on purpose: Q was sent
  [[nodiscard]] bool stays_local() const { return stay_local_; }
  void was_sent_to_local() {
    stay_local_ = true;
    mode_ = Mode::local;
  }
  void was_sent_on_line() {
    stay_local_ = false;
    mode_ = Mode::on_line;
  }
  /// The controller is to be on-line, whatever its present mode.
  void wants_on_line() { stay_local_ = false; }
  /// yes: F ended Local mode before that could be counted as a restart. perhaps: the mode is unknown. For a
  /// controller that was never found before, Local mode is no sign of a restart.
  enum class LeftLocal : std::uint8_t { no, perhaps, yes };
  void left_local(LeftLocal left) {
    if (found_before_) left_local_ = std::max(left_local_, left);
  }
  LeftLocal take_left_local() { return std::exchange(left_local_, LeftLocal::no); }

  // ---- found before, and restarted since
  [[nodiscard]] bool was_found_before() const { return found_before_; }
  void is_found() { found_before_ = true; }
  /// The restart was counted, and the controller not seen on-line since.
  [[nodiscard]] bool restart_is_counted() const { return restart_counted_; }
  void count_restart() {
    restart_counted_ = true;
    left_local_ = LeftLocal::no;
  }
  /// res was sent; its restart has not been seen.
  [[nodiscard]] bool reset_was_sent() const { return reset_sent_; }
  void note_reset_sent() { reset_sent_ = true; }
  void reset_is_over() { reset_sent_ = false; }

  // ---- after an error that halts it, it accepts nothing but K
  [[nodiscard]] bool is_halted() const { return halted_ != 0; }
  /// Letter of that error; 0: not halted.
  [[nodiscard]] char error() const { return halted_; }
  void halted_by(char letter);
  void note_answers_again() { halted_ = 0; }
  /// True once a second.
  bool is_to_be_asked_again();

 private:
  enum class Mode : std::uint8_t { unknown, on_line, local };

  const Scheduler& scheduler_;
  Conversation& conversation_;
  Mode mode_ = Mode::unknown;
  LeftLocal left_local_ = LeftLocal::no;
  bool found_before_ = false, stay_local_ = false;
  bool restart_counted_ = false, reset_sent_ = false;
  char halted_ = 0;
  Instant ask_again_at_{};
};

}  // namespace hw::vxm
