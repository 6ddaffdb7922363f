#pragma once
// Reads command text one command at a time: its meaning, canonical form and cost, and whether it is finished.
// For the console's side of the wire; pure. Follows the manual p.9, 16 to 25 and the appendices.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hw::vxm {

enum class Verb : std::uint8_t {
  index_by,       ///< ImMx, ImM-x
  index_to,       ///< IAmMx
  zero_here,      ///< IAmM-0
  home,           ///< ImM0, ImM-0
  speed,          ///< SmMx
  speed_analog,   ///< SmM-x
  acceleration,   ///< AmMx
  loop_forever,   ///< L0
  marker_set,     ///< LM0, and L-0 of the NF90
  marker_reset,   ///< LM-0
  loop,           ///< Lx, L-x
  loop_always,    ///< LAx, LA-x
  loop_reverse,   ///< LM-2, LM-3
  jump,           ///< Jx
  jump_return,    ///< JMx
  jump_pick,      ///< JM-x
  pause,          ///< Px, P-x
  pause_output,   ///< PAx, PA-x
  user,           ///< Ux
  pair_begins,    ///< (
  pair_ends,      ///< )
  slave_begins,   ///< [
  slave_ends,     ///< ]
  select,         ///< PMx
  empty,          ///< PM-x
  ask_selected,   ///< PM
  associate,      ///< PMAx
  ask_associate,  ///< PMA
  set,            ///< set... , Bx, Ox
  get,            ///< get... , B, O
  letter,         ///< X, V, R ...: acts at once
  word,           ///< lst, rsm, res, del
};

enum class Flaw : std::uint8_t {
  none,
  unknown,   ///< no command of the VXM
  no_value,  ///< the number is missing
  range,     ///< the number is out of range
  open,      ///< the text ends inside the command
};

struct TextCommand {
  Verb verb = Verb::letter;
  Flaw flaw = Flaw::none;
  char letter = 0;          ///< of Verb::letter
  std::uint8_t motor = 0;   ///< 1 to 4; in a short form, the motor addressed last
  bool full_power = false;  ///< SA, setMA
  bool minus = false;       ///< a minus sign stands before the number, also before 0
  std::int64_t value = 0;   ///< magnitude
  std::string name;         ///< mnemonic of set and get: "j1M"; the word of Verb::word; the text if unknown
  std::size_t begin = 0, end = 0;  ///< place in the text, ender included

  [[nodiscard]] std::int64_t signed_value() const { return minus ? -value : value; }
  [[nodiscard]] bool stored() const { return verb <= Verb::pair_ends; }
};

/// Reads a text as the controller would: a line feed is ignored, a remark lasts to the carriage return.
/// `motor`: addressed last before the text.
std::vector<TextCommand> read_text(std::string_view text, int motor = 1);
/// The same for a listing.
std::vector<TextCommand> commands_of(const std::vector<std::string>& lines);
/// True if the controller would read the next byte as part of the last command.
bool ends_open(std::string_view text);
/// As `lst` writes it: motor always shown, no ender.
std::string canonical(const TextCommand& command);
/// Bytes of program memory.
int program_cost(const TextCommand& command);
/// Whether the controller accepts the command's motor and number.
bool possible(const TextCommand& command);
/// Range of the command's value: "1 to 6000 steps/s". Empty: it has no value.
std::string allowed_values(const TextCommand& command);

}  // namespace hw::vxm
