#pragma once
// How slow the replies on one wire have been, and how long a shared wire therefore waits for a prompt one, so
// that a device that is switched off does not delay the others. Io thread only.
#include <algorithm>

#include "core/time/scheduler.h"

namespace hw {

class ReplyTimes {
 public:
  /// A reply came; of a prompt question `waited` after the time on the wire.
  void answered(bool prompt, Duration waited) {
    silent_in_a_row_ = 0;
    if (!prompt) return;
    prompt_answers_ = std::min(prompt_answers_ + 1, prompt_answers_needed);
    slowest_prompt_ = std::max(waited, slowest_prompt_ - slowest_prompt_ / 256);
  }
  void missed() { ++silent_in_a_row_; }
  /// For a prompt question with this patience of its own on a wire of `stations` stations.
  [[nodiscard]] Duration patience_of_prompt(Duration patience, std::size_t stations) const {
    const bool all_silent = silent_in_a_row_ > 2 * static_cast<int>(stations);  // the wire is slow, or dead
    if (stations < 2 || prompt_answers_ < prompt_answers_needed || all_silent) return patience;
    return std::min(patience, std::max(least_patience, 3 * slowest_prompt_));
  }

 private:
  static constexpr Duration least_patience = Millis(50);  ///< as adapters deliver bytes in pieces
  static constexpr int prompt_answers_needed = 16;        ///< to know the wire

  /// Slowest recent delay of a prompt reply, beyond its time on the wire; decays slowly.
  Duration slowest_prompt_{};
  int prompt_answers_ = 0;
  int silent_in_a_row_ = 0;  ///< questions in a row that no station answered
};

}  // namespace hw
