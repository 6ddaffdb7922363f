#pragma once
// What the console says for its own ends, and what the board rejects: at once, or when its turn in a queue
// comes (decision M17). One bit of the status register tells both, and which command it was has to be worked
// out.
#include <functional>
#include <string>

#include "core/devices/vme58/conversation.h"

namespace hw::vme58 {

class Commands {
 public:
  Commands(Wire& wire, Readings& readings, Conversation& conversation, const Selection& selection,
           const Catalog& catalog, Snapshot& draft)
      : wire_(wire),
        readings_(readings),
        conversation_(conversation),
        selection_(selection),
        catalog_(catalog),
        draft_(draft) {}

  /// It has been taken, and was no command error.
  Task<Result<>> say(std::string text, Priority priority);
  /// What waits in a queue may be rejected at any time: not to be taken for the fault of what is sent next.
  Task<Result<>> settle_late(Priority priority);
  /// An error came to light by itself: what had waited in a queue was rejected when its turn came.
  void show_late();
  /// Said once of an error that nobody has asked about.
  void show_late_if_any() {
    if (readings_.take_command_error()) show_late();
  }

  [[nodiscard]] tl::unexpected<Fault> rejected(std::string_view text) const;
  /// Whose servo loop is open takes no motion; said only when the text would move it.
  [[nodiscard]] std::string open_loop_words(std::string_view text, Context context) const;
  /// Text of the console's own would be recorded with the user's contour.
  [[nodiscard]] Result<> may_talk() const;

  /// Somebody may have waited for what was rejected; he may add to the words.
  std::function<void(std::string& words)> rejected_late;

 private:
  Wire& wire_;
  Readings& readings_;
  Conversation& conversation_;
  const Selection& selection_;
  const Catalog& catalog_;
  Snapshot& draft_;
};

}  // namespace hw::vme58
