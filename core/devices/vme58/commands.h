#pragma once
// Commands of the console's own, and rejections by the board: at once, or when a command's turn in a queue
// comes (decision M17). One bit of the status register reports both, so the rejected command must be worked
// out.
#include <functional>
#include <string>

#include "core/devices/vme58/conversation.h"

namespace hw::vme58 {

class Commands {
 public:
  Commands(Wire& wire, Readings& readings, Conversation& conversation, const Selection& selection,
           const Catalog& catalog, Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        conversation_(conversation),
        selection_(selection),
        catalog_(catalog),
        snapshot_(snapshot) {}

  /// Sends `text`. Succeeds once the board has taken it without a command error.
  Task<Result<>> transmit(std::string text, Priority priority);
  /// Call before sending: reports the rejection of a queued command, so that the next text is not blamed for
  /// it.
  Task<Result<>> settle_late(Priority priority);
  /// Reports a command error that no sent text explains: a queued command was rejected when its turn came.
  void show_late();
  /// Reports a pending command error once.
  void show_late_if_any() {
    if (readings_.take_command_error()) show_late();
  }

  [[nodiscard]] tl::unexpected<Fault> rejected(std::string_view text) const;
  /// Words saying that an axis whose servo loop is open takes no motion; empty unless `text` would move such
  /// an axis.
  [[nodiscard]] std::string open_loop_words(std::string_view text, Context context) const;
  /// Fails without a connection, or while a contour is recorded: the console's own text would become part of
  /// it.
  [[nodiscard]] Result<> may_talk() const;

  /// Called when a queued command was rejected; may add to the words.
  std::function<void(std::string& words)> rejected_late;

 private:
  Wire& wire_;
  Readings& readings_;
  Conversation& conversation_;
  const Selection& selection_;
  const Catalog& catalog_;
  Snapshot& snapshot_;
};

}  // namespace hw::vme58
