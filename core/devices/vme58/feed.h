#pragma once
// A command string on its way to the board, each command by itself, so that the one that is rejected can be
// named.
#include <deque>
#include <optional>
#include <string>
#include <utility>

#include "core/devices/vme58/effects.h"

namespace hw::vme58 {

class Feed {
 public:
  Feed(Readings& readings, Selection& selection, Conversation& conversation, Commands& commands,
       Motions& motions, Effects& effects, Snapshot& draft)
      : readings_(readings),
        selection_(selection),
        conversation_(conversation),
        commands_(commands),
        motions_(motions),
        effects_(effects),
        draft_(draft) {}

  /// The text has no comments. False: there is nothing in it.
  bool load(const std::string& plain);
  void begin();
  /// As much as the board takes now. A command that waits for room stays in the ring until the next round.
  /// Returns what was rejected, in words.
  Task<Result<std::optional<std::string>>> go_on();
  void end();
  [[nodiscard]] bool is_under_way() const { return draft_.feed.running; }
  /// The user's text selects an axis meanwhile: each keeps its own.
  void user_selects() { apart_ = apart_ || is_under_way(); }
  void forget();

 private:
  struct Fed {
    std::string text;  ///< sent, not taken yet
    Context before;    ///< in which it is read
    int line = 0;
    bool waits = false;  ///< the board did not take it at once
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
  Snapshot& draft_;
  std::deque<std::pair<int, std::string>> to_feed_;  ///< line and command
  Fed fed_;
  Context context_;     ///< of the program, as far as it was put
  bool apart_ = false;  ///< the user's text has selected an axis meanwhile: each keeps its own
};

int line_holding(std::string_view text, std::size_t at);

}  // namespace hw::vme58
