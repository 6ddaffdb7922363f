#pragma once
// Feeds a command string to the board one command at a time, so that a rejected command can be named.
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "core/devices/vme58/effects.h"

namespace hw::vme58 {

class Feed {
 public:
  Feed(Readings& readings, Selection& selection, Conversation& conversation, Commands& commands,
       Motions& motions, Effects& effects, Snapshot& snapshot)
      : readings_(readings),
        selection_(selection),
        conversation_(conversation),
        commands_(commands),
        motions_(motions),
        effects_(effects),
        snapshot_(snapshot) {}

  /// `plain` must have no comments. False: it contains no command.
  bool load(const std::string& plain);
  void begin();
  /// Sends as much as the board takes now. A command that waits for room stays in the ring until the next
  /// round. Returns words for a rejected command; none: none was rejected.
  Task<Result<std::optional<std::string>>> go_on();
  void end();
  /// See Effects::program_ended().
  void program_ended(bool whole) { effects_.program_ended(whole); }
  [[nodiscard]] bool is_under_way() const { return snapshot_.feed.running; }
  /// Call when the user's text selects an axis during a feed: from then on, user and program each keep their
  /// own selection.
  void user_selects() { apart_ = apart_ || is_under_way(); }
  void forget();

 private:
  struct Fed {
    std::string text;  ///< sent, not yet taken
    Context before;    ///< in which the board reads it
    int line = 0;
    bool waits = false;  ///< not taken at once by the board
  };
  Task<Result<bool>> put_next();
  Task<Result<std::optional<std::string>>> finish();
  [[nodiscard]] std::string text_for(std::string_view command, const Context& after) const;
  [[nodiscard]] std::string rejected_late() const;

  Readings& readings_;
  Selection& selection_;
  Conversation& conversation_;
  Commands& commands_;
  Motions& motions_;
  Effects& effects_;
  Snapshot& snapshot_;
  std::deque<std::pair<int, std::string>> to_feed_;  ///< line and command
  Fed fed_;
  Context context_;     ///< of the program, after the commands already put
  bool apart_ = false;  ///< user and program have selections of their own
};

int line_holding(std::string_view text, std::size_t at);

}  // namespace hw::vme58
