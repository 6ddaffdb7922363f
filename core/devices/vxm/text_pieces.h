#pragma once
// Cuts a raw text so that nothing is sent while the controller answers (the overrun of the manual's p.30
// locks it until power-off), and notes the commands that it takes in its present state. Pure.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/vxm/codec_text.h"
#include "core/link/framing.h"
#include "core/link/outstanding_replies.h"
#include "core/time/clock.h"

namespace hw::vxm {

inline constexpr Duration usual_patience = Millis(200);
/// `rsm` is answered once the memory is written.
inline constexpr Duration store_patience = std::chrono::seconds(10);

/// How the reply to a command ends.
struct AnswerShape {
  ReplyShape shape;
  std::size_t (*unsolicited_length)(std::string_view) = nullptr;
  Duration patience = usual_patience;
  ReplyKind reply_kind = ReplyKind::any;
  /// Answered only if the program has ended since it was last seen to run; else dropped.
  bool perhaps = false;
};

/// At most its last command is answered, so it may be sent in one go.
struct Piece {
  std::string text;
  std::optional<AnswerShape> answer;
  std::vector<TextCommand> taken;
  bool stores = false;           ///< rsm
  bool kills = false;            ///< K
  bool resets = false;           ///< res
  bool only_separators = false;  ///< nothing but the ender of the piece before
  std::int64_t new_rate = 0;     ///< setB: its number; later pieces are sent at the new rate
};

/// The state that decides which commands the controller takes, updated along a text.
struct Listening {
  bool local = false, running = false, halted = false, to_slave = false;
  int digitized_lines = 2;

  [[nodiscard]] bool takes(const TextCommand& command) const;
  void follow(const TextCommand& command);
};

std::vector<Piece> pieces_of(std::string_view text, const std::vector<TextCommand>& commands, Listening now);

/// The last piece that is more than an ender; null: none.
const Piece* last_command_of(const std::vector<Piece>& pieces);

/// A sentence about known commands that the controller drops silently in its state; empty: none.
std::string dropped_of(const std::vector<TextCommand>& commands, Listening now);
/// Whether the last command is dropped.
bool last_is_dropped(const std::vector<TextCommand>& commands, Listening now);

}  // namespace hw::vxm
