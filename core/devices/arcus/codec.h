#pragma once
// The wire of the Arcus family in both directions: pure functions.
//   RS-485, RS-232   @NNtext CR        ->  text CR (PMX) or text NUL (DMX); with RT=1 #NNtext
//   USB              text, NUL padded  ->  text, NUL padded
//   unasked          $NNP CR: the device is in position
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/units.h"
#include "core/device/catalog.h"
#include "core/devices/arcus/forms.h"

namespace hw::arcus {

/// How a command travels.
enum class Framing : std::uint8_t {
  addressed,  ///< on a line: @NN, text, CR
  message,    ///< on USB: the text alone; the transport pads it
};

/// "PX" for device 7 -> "@07PX\r". Text that brings its own @NN keeps it.
std::string frame(Framing framing, int id, std::string_view text);
/// The address in a framed text; -1: none.
int address_of(std::string_view bytes);
/// The text in a framed command, or in a reply: without address, terminators and padding.
std::string_view text_of(std::string_view bytes);

struct Reply {
  std::string text;
  std::optional<int> id;  ///< RT=1
  [[nodiscard]] bool refused() const { return text.starts_with('?'); }
};
Reply decode_reply(std::string_view bytes);

/// Ends an incomplete command on the line without executing it: a CR alone would execute its beginning, X38
/// of X3822.
inline constexpr std::string_view cut_off = "~\r";

/// Length of the unsolicited message ($NNP CR) at the front. npos: more bytes are needed to decide. 0: there
/// is none.
std::size_t unsolicited_at_front(std::string_view bytes);
/// The same for the refusal of a command that `cut_off` ended.
std::size_t refusal_of_cut_at_front(std::string_view bytes);
/// The same for an unsolicited message or a complete device name, which answers only DN.
std::size_t unsolicited_or_name_at_front(const Model& model, std::string_view bytes);
/// The number in a device name: "DMK07" -> 7.
std::optional<int> number_in_name(const Model& model, std::string_view name);
/// The number of the device in the message that it is in position.
std::optional<int> in_position(std::string_view message);

// ---- values
std::optional<std::int64_t> decode_number(std::string_view text);
/// "1:-2:3" -> three numbers; none if one is no number or there are fewer than `count`.
std::optional<std::vector<std::int64_t>> decode_numbers(std::string_view text, std::size_t count);
/// In the unit of the catalog's parameter: "0.800" -> 800, "4EX07" -> 7.
std::optional<std::int64_t> decode_value(const ParamInfo& info, std::string_view text);
std::string encode_value(const ParamInfo& info, std::int64_t value);

// ---- commands
/// A form with its places filled in. The axis letter is written only where the form has a place for it.
std::string fill(const Forms& forms, std::string_view form, int axis, Sign sign = Sign::plus,
                 std::int64_t number = 0);
std::string set_command(std::string_view name, std::int64_t value);
std::string set_command(const ParamInfo& info, std::int64_t value);
struct AxisValue {
  int axis;
  std::int64_t value;
};
/// "X1000Y-500"
std::string move_command(const Forms& forms, const std::vector<AxisValue>& targets);

/// Commands that may move something: they are never repeated.
bool may_move(const Forms& forms, std::string_view text);

/// The text sets, or may set, a position or encoder counter to zero.
bool may_set_counter(std::string_view text);
/// The text sets, or may set, the position to the encoder's: clearing an error, switching StepNLoop.
bool may_set_target(std::string_view text);
/// Motor power, by EO; not EOBOOT, which acts at power-up.
bool may_switch_motor(std::string_view text);

/// As the controllers read it: without blanks at its ends and around '='.
std::string bare_text(std::string_view text);
/// The same for the command in a framed text.
std::string command_in(std::string_view bytes);

/// The thread of SR0=1.
std::optional<int> thread_named_in(std::string_view text);
/// Commands that end motion (STOP, ABORT), or a program (SR0=0).
bool ends_motion(std::string_view text);
bool ends_program(std::string_view text);
/// Starts stored code (SR0=1, GS0), or continues it.
bool runs_program(std::string_view text);

/// Bits of a status word.
bool has_bit(std::int64_t word, int bit);
/// In motion, by the lowest three bits, which both tables use for it.
bool reports_motion(std::int64_t word);

/// The meaning of a reply that begins with ?, as a sentence with a remedy.
std::string explain_refusal(const Model& model, std::string_view reply);

}  // namespace hw::arcus
