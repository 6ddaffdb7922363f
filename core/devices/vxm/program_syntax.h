#pragma once
// Reads command text like the controller, one character at a time (V03 to V11), and gives the meaning of a
// command. Shared by the emulator and the analysis of program texts, so that both agree.
#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

#include "core/devices/vxm/program.h"

namespace hw::vxm {

enum class Head : std::uint8_t {
  I,
  IA,
  S,
  SA,
  A,
  L,
  LA,
  LM,
  J,
  JM,
  P,
  PA,
  U,  // stored
  PM,
  PMA,
  B,
  O,  // act at once, or ask if no number follows
  set_M,
  set_MA,
  set_B,
  set_DM,
  set_D0,
  set_DA,
  set_j,
  set_J,
  set_jA,
  set_JA,
  set_L,
  set_P,
  set_PA,
  set_I,
  get_M,
  get_DM,
  get_D0,
  get_D1,
  get_D2,
  get_DA,
  get_j,
  get_J,
  get_jA,
  get_JA,
  get_L,
  get_P,
  get_PA,
  get_I,
  lst,
  del,
  res,
  rsm,
};

enum class Part : std::uint8_t { none, optional, required };

struct Form {
  Head head;
  std::string_view text;
  Part motor, value;
};
[[nodiscard]] const Form& form_of(Head head);

/// Result of the characters read so far. Places count all characters given to the reader.
struct Reading {
  enum class Kind : std::uint8_t {
    letter,   ///< a single character that acts at once
    word,     ///< a whole command
    unknown,  ///< a character that starts nothing: dropped
    broken,   ///< abandoned: an unfitting character came
    no_number,
  };
  Kind kind = Kind::letter;
  char letter = 0;
  Head head = Head::I;
  int motor = 0;  ///< 0: none given
  bool minus = false, has_value = false;
  std::int64_t value = 0;           ///< magnitude; beyond any range when absurdly long
  std::int64_t begin = 0, end = 0;  ///< characters [begin, end), the ender not counted
};

class Reader {
 public:
  struct Readings {
    std::array<Reading, 2> items;
    int count = 0;
    [[nodiscard]] const Reading* begin() const { return items.data(); }
    [[nodiscard]] const Reading* end() const { return items.data() + count; }
  };
  /// At most two: the abandoned command, and the effect of the character itself.
  Readings feed(char c);
  void reset() { *this = Reader(); }
  [[nodiscard]] bool in_comment() const { return comment_; }
  /// No command or remark is open.
  [[nodiscard]] bool idle() const { return stage_ == Stage::start && !comment_; }
  [[nodiscard]] std::int64_t place() const { return place_; }

 private:
  enum class Stage : std::uint8_t { start, head, motor_or_value, value, skip };
  void start_with(char c, Readings& out);
  bool go_on_with(char c, Readings& out);
  bool take_head(char c);
  bool take_number(char c, Readings& out);
  bool take_value(char c);
  void end_command(Readings& out);
  void give(Readings& out, Reading::Kind kind);
  void begin_again() { stage_ = Stage::start, text_size_ = 0, current_ = Reading(); }
  [[nodiscard]] std::string_view text() const { return {text_.data(), text_size_}; }

  Stage stage_ = Stage::start;
  std::array<char, 8> text_{};
  std::size_t text_size_ = 0;
  Reading current_;
  std::int64_t number_ = 0;
  int digits_ = 0;
  bool comment_ = false;
  std::int64_t place_ = 0;
};

/// Why a complete command is refused.
struct Refusal {
  enum class Kind : std::uint8_t { range, motor, choice } kind = Kind::range;
  std::int64_t min = 0, max = 0;  ///< range
  bool nf90_only = false;
};

/// The stored command for a word of a stored form. `current`: the motor where the word names none.
[[nodiscard]] std::variant<Command, Refusal> meaning(const Reading& word, int current, bool nf90);
[[nodiscard]] bool is_stored(Head head);
/// Stored forms that may leave out the motor.
[[nodiscard]] bool takes_motor(Head head);

}  // namespace hw::vxm
