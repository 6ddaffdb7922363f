#pragma once
// The rings: commands in, replies out. Only this class turns bytes into messages and assigns replies to
// questions.
//
// The board answers in the order of its ring. The reply to an abandoned question (after a stop or a timeout)
// may still come at any time, and may look like the reply to the next one. WY is sent after such a question,
// as the reply to WY is unmistakable. Until that greeting comes no question is asked and no reply is trusted.
// A text of several questions also ends with WY, which exposes a missing or extra reply.
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/script_texts.h"
#include "core/devices/vme58/codec.h"
#include "core/devices/vme58/readings.h"
#include "core/devices/vme58/selection.h"
#include "core/devices/vme58/wire.h"

namespace hw::vme58 {

class Conversation {
 public:
  enum class WhenStuck : std::uint8_t { withdraw, leave };

  Conversation(Wire& wire, Readings& readings, Selection& selection, ScriptTexts& texts)
      : wire_(wire), readings_(readings), selection_(selection), texts_(texts) {}

  // ---- ownership of the rings
  /// Adopts the host's two indexes from the window, as the previous host left them. Unread replies are
  /// discarded.
  Task<Result<>> take_over();
  /// Whether take_over() has succeeded. Before that nothing may be put.
  [[nodiscard]] bool is_known() const { return known_; }
  /// The wire was lost or replaced.
  void lose();
  /// Reads only the end of the command ring: enough to take back text waiting in it.
  Task<Result<>> find_end(Priority priority);

  /// Discards the replies waiting in the ring.
  Task<Result<>> let_go();

  // ---- commands
  /// Puts the text into the ring whole or not at all, so that no other text gets in between. False: no room
  /// now.
  Task<Result<bool>> put(std::string text, Priority priority);
  /// Puts the text and returns once the board has taken it. A text stuck behind a full queue would act at an
  /// unexpected time: it is taken back, unless `when_stuck` is `leave`.
  Task<Result<>> write(std::string text, Priority priority, WhenStuck when_stuck = WhenStuck::withdraw);
  /// The text that write() gave up was taken back before the board read any of it.
  [[nodiscard]] bool was_taken_back() const { return taken_back_; }
  /// Restores the axis selected by the user's text, if text taken back has left it in doubt.
  Task<Result<>> select_again(Priority priority);
  /// Whether the board has taken all text.
  Task<Result<bool>> is_taken(Priority priority);
  /// The same, by indexes that have just been read.
  bool is_taken_up_to(int output_get, int output_put);
  /// Blanks all text waiting in the ring, whoever put it there.
  Task<Result<>> withdraw_all(Priority priority);
  /// Whether text was put that the board is not known to have taken.
  [[nodiscard]] bool is_under_way() const { return on_its_way_; }
  [[nodiscard]] bool waits_in_wq() const { return in_wq_; }
  /// End of the command ring. It changes with each text put, so it shows whether a text was put.
  [[nodiscard]] int end() const { return put_; }
  [[nodiscard]] const std::string& last_sent() const { return last_sent_; }
  /// The latest text that was not a poll: the user's own, or one sent for the user.
  [[nodiscard]] const std::string& last_not_polled() const { return last_not_polled_; }

  // ---- replies
  Task<Result<std::string>> ask(std::string question, Priority priority, ReplyForm form = {},
                                Duration patience = Millis(200));
  /// Returns the replies in the order of the questions. Appends a WY of its own: `text` must contain none.
  Task<Result<std::vector<std::string>>> ask_several(std::string text, std::size_t count, Priority priority,
                                                     ReplyForm form);
  /// Fetches unsolicited replies up to `input_put`.
  Task<Result<>> receive(int input_put, Priority priority);
  /// Echo is on (EN): sent text is received again between the reply frames.
  void echoes(bool on) { echo_ = on; }

 private:
  /// The reply to an abandoned question may still come.
  struct Owed {
    std::optional<Instant> greeting_asked;  ///< when WY was put behind the question
  };
  Task<Result<>> fill(std::string_view text, int from, Priority priority);
  Task<Result<bool>> withdraw(Priority priority, int from);
  Task<Result<>> fetch(int input_put, Priority priority);
  Task<Result<>> fetch_all(Priority priority);
  Task<Result<>> wait_for_abandoned(Priority priority);
  Task<Result<std::vector<std::string>>> converse(std::string text, std::size_t count, Priority priority,
                                                  ReplyForm form, Duration patience, bool closes);
  Task<Result<>> collect(std::vector<std::string>& replies, std::size_t count, Priority priority,
                         Instant give_up, std::string_view question, bool closes);
  bool take_greeting();
  void give_unsolicited();

  Wire& wire_;
  Readings& readings_;
  Selection& selection_;
  ScriptTexts& texts_;
  int put_ = 0, get_ = 0;  ///< the host's two indexes
  bool known_ = false, on_its_way_ = false;
  bool in_wq_ = false;  ///< WQ was put, and the board has not been seen reading on
  bool taken_back_ = false;
  bool echo_ = false;
  std::string received_;             ///< characters of an incomplete reply
  std::deque<std::string> replies_;  ///< complete replies not yet taken
  std::optional<Owed> owed_;
  std::string last_sent_, last_not_polled_;
};

}  // namespace hw::vme58
