#pragma once
// A raw text as it goes out: cut so that nothing is sent while the controller answers (the overrun of the
// manual's p.30 locks it until power-off), with what the controller takes of it in its present state. Pure.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/vxm/codec_text.h"
#include "core/link/framing.h"
#include "core/link/owed_answers.h"
#include "core/time/clock.h"

namespace hw::vxm {

inline constexpr Duration usual_patience = Millis(200);
/// `rsm` answers when it has written its memory.
inline constexpr Duration store_patience = std::chrono::seconds(10);

/// How the answer to a command ends.
struct AnswerShape {
  ReplyShape shape;
  std::size_t (*stranger)(std::string_view) = nullptr;
  Duration patience = usual_patience;
  Look look = Look::any;
  /// Only if the program has ended since it was last seen to run; else it is dropped.
  bool perhaps = false;
};

/// At most the last command of it is answered, so it may go out at once.
struct Piece {
  std::string text;
  std::optional<AnswerShape> answer;
  std::vector<TextCommand> taken;
  bool stores = false;    ///< rsm
  bool kills = false;     ///< K
  bool resets = false;    ///< res
  bool mere_end = false;  ///< nothing but the end of the piece before
};

/// What decides which commands the controller takes, as it changes on the way through a text.
struct Listening {
  bool local = false, running = false, halted = false, to_slave = false;
  int digitized_lines = 2;

  [[nodiscard]] bool takes(const TextCommand& command) const;
  void follow(const TextCommand& command);
};

std::vector<Piece> pieces_of(std::string_view text, const std::vector<TextCommand>& commands, Listening now);

/// The last of them that is more than an end; null: there is none.
const Piece* last_command_of(const std::vector<Piece>& pieces);

/// A sentence about known commands that the controller's state drops without a word; empty: none.
std::string dropped_of(const std::vector<TextCommand>& commands, Listening now);
/// The last known one is among them.
bool last_is_dropped(const std::vector<TextCommand>& commands, Listening now);

}  // namespace hw::vxm
