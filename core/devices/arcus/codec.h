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

/// Ends whatever was left half said on the line, as no command: by a CR alone the beginning of one would be
/// carried out, X38 of X3822.
inline constexpr std::string_view cut_off = "~\r";

/// How many bytes at the front are a message that nobody asked for ($NNP CR). npos: they may be one, more
/// must come. 0: they are none.
std::size_t unasked_at_front(std::string_view bytes);
/// The same of the refusal of what was cut off so.
std::size_t refusal_of_cut_at_front(std::string_view bytes);
/// The same of such a message, or of a whole device name, which answers no other question than DN.
std::size_t unasked_or_name_at_front(const Model& model, std::string_view bytes);
/// The same of whatever is whole and no device name: no answer to DN.
std::size_t no_name_at_front(const Model& model, std::string_view bytes);
/// The number in a device name: "DMK07" -> 7.
std::optional<int> number_in_name(const Model& model, std::string_view name);
/// The device that tells that it is in position.
std::optional<int> in_position(std::string_view message);

// ---- values
std::optional<std::int64_t> decode_number(std::string_view text);
/// "1:-2:3" -> three numbers; none when any of them is no number or there are not `count` at least.
std::optional<std::vector<std::int64_t>> decode_numbers(std::string_view text, std::size_t count);
/// As a parameter of the catalog counts it: "0.800" -> 800, "4EX07" -> 7.
std::optional<std::int64_t> decode_value(const ParamInfo& info, std::string_view text);
std::string encode_value(const ParamInfo& info, std::int64_t value);

// ---- commands
/// A form with its places filled in; the axis letter only where the form has one.
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

/// A text that sets a position or encoder counter to zero, or may.
bool may_set_counter(std::string_view text);
/// One that puts the position where the encoder stands, or may: clearing an error, switching StepNLoop.
bool may_set_target(std::string_view text);
/// Motor power, by EO; not EOBOOT, which acts at power-up.
bool may_switch_motor(std::string_view text);

/// As the controllers read it: without blanks at its ends and around '='.
std::string bare_text(std::string_view text);
/// The same of what stands in a framed text.
std::string command_in(std::string_view bytes);

/// The thread of SR0=1.
std::optional<int> thread_named_in(std::string_view text);
/// Commands that end motion (STOP, ABORT), or a program (SR0=0).
bool ends_motion(std::string_view text);
bool ends_program(std::string_view text);
/// Starts one (SR0=1, GS0), or lets one go on.
bool runs_program(std::string_view text);

/// Bits of a status word.
bool has_bit(std::int64_t word, int bit);
/// Running, by the bits that both tables have in their lowest places.
bool says_moving(std::int64_t word);

/// What a reply that begins with ? means, as a sentence with what to do.
std::string explain_refusal(const Model& model, std::string_view reply);

}  // namespace hw::arcus
