#pragma once
// The rings: commands in, replies out. Here alone bytes become messages, and here alone it is decided whose a
// reply is.
//
// The board answers in the order of its ring. A question that was given up (a stop came, or its time) leaves
// a reply behind that may come at any time, and looks like the next one's. Whether it has come shows by a
// question whose answer cannot be mistaken: WY. Until its greeting comes nothing is asked, and nothing that
// comes is believed. Several questions in one text end with a WY too: one reply more or less is seen then.
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

  // ---- whose rings they are
  /// The host's two indexes stand in the window, as whoever spoke last has left them. Replies that nobody has
  /// read are let go.
  Task<Result<>> take_over();
  /// Until that nothing may be put.
  [[nodiscard]] bool is_known() const { return known_; }
  /// The wire is gone, or a new one is there.
  void lose();
  /// Only where the ring ends: enough to take back what stands in it.
  Task<Result<>> find_end(Priority priority);

  /// What was said so far answers nothing.
  Task<Result<>> let_go();

  // ---- commands
  /// One burst, whole or not at all: nobody else's text gets in between. False: it does not fit now.
  Task<Result<bool>> put(std::string text, Priority priority);
  /// Returns when the board has taken it. Text that would wait behind a full queue and act at an unexpected
  /// time is taken back, unless it may wait.
  Task<Result<>> write(std::string text, Priority priority, WhenStuck when_stuck = WhenStuck::withdraw);
  /// What write() gave up was taken back before the board came to any of it.
  [[nodiscard]] bool took_back() const { return taken_back_; }
  /// The board stands at the axis that the user's text has selected, also after text was taken back.
  Task<Result<>> select_again(Priority priority);
  /// All that was put has been taken.
  Task<Result<bool>> is_taken(Priority priority);
  /// The same, by an index that has just been read.
  bool is_taken_up_to(int output_get, int output_put);
  /// Whatever stands in the ring, whoever has put it there, does nothing any more.
  Task<Result<>> withdraw_all(Priority priority);
  /// Text was put that the board is not known to have taken.
  [[nodiscard]] bool is_under_way() const { return on_its_way_; }
  [[nodiscard]] bool waits_in_wq() const { return in_wq_; }
  /// Moves with each text that was put: whether one was.
  [[nodiscard]] int end() const { return put_; }
  [[nodiscard]] const std::string& last_sent() const { return last_sent_; }
  /// By the user or for him: no question of a poll.
  [[nodiscard]] const std::string& last_said() const { return last_said_; }

  // ---- replies
  Task<Result<std::string>> ask(std::string question, Priority priority, ReplyForm form = {},
                                Duration patience = Millis(200));
  /// A reply for each, in their order. They are ended by a WY of our own: `text` has none.
  Task<Result<std::vector<std::string>>> ask_several(std::string text, std::size_t count, Priority priority,
                                                     ReplyForm form);
  /// What the board has said so far, as its index tells; nobody waits for it.
  Task<Result<>> hear(int input_put, Priority priority);
  /// EN was sent: between the frames stands what the board was sent.
  void echoes(bool on) { echo_ = on; }

 private:
  /// A reply that nobody waits for may still come.
  struct Owed {
    std::optional<Instant> greeting_asked;  ///< WY was put behind it then
  };
  Task<Result<>> fill(std::string_view text, int from, Priority priority);
  Task<Result<bool>> withdraw(Priority priority, int from);
  Task<Result<>> fetch(int input_put, Priority priority);
  Task<Result<>> fetch_all(Priority priority);
  Task<Result<>> let_owed_go(Priority priority);
  Task<Result<std::vector<std::string>>> converse(std::string text, std::size_t count, Priority priority,
                                                  ReplyForm form, Duration patience, bool closes);
  Task<Result<>> collect(std::vector<std::string>& replies, std::size_t count, Priority priority,
                         Instant give_up, std::string_view question, bool closes);
  bool take_greeting();
  void give_unasked();

  Wire& wire_;
  Readings& readings_;
  Selection& selection_;
  ScriptTexts& texts_;
  int put_ = 0, get_ = 0;  ///< the host's two indexes
  bool known_ = false, on_its_way_ = false;
  bool in_wq_ = false;  ///< WQ was put, and the board was not seen to read on
  bool taken_back_ = false;
  bool echo_ = false;
  std::string received_;             ///< characters that are no whole reply yet
  std::deque<std::string> replies_;  ///< whole ones that nobody has taken
  std::optional<Owed> owed_;
  std::string last_sent_, last_said_;
};

}  // namespace hw::vme58
