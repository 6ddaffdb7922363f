#pragma once
// The VME58's window in bytes and texts: command text to cells of the ring, cells to replies, values of the
// data area, status letters. Pure.
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/vme58/facts.h"
#include "core/link/window.h"

namespace hw::vme58 {

// ---- rings: one character to a cell of 16 bits, indexes from 0 to 255, equal: empty (decisions M22, M23)

/// Characters waiting between get and put.
constexpr int waiting(int put, int get) { return (put - get) & (ring_cells - 1); }
/// Number of characters that still fit.
constexpr int room(int put, int get) { return ring_cells - 1 - waiting(put, get); }
constexpr int advanced(int index, int by) { return (index + by) & (ring_cells - 1); }
/// Whether `value` is a valid index; if not, it was garbled or there is no board.
constexpr bool is_index(std::uint32_t value) { return value < static_cast<std::uint32_t>(ring_cells); }

/// Appends cycles that write `text` into the command ring from `put` on and then read it back. The text must
/// fit: see room().
void append_text(std::vector<BusCycle>& cycles, std::string_view text, int put);
/// Appends cycles that read `count` characters of the reply ring from `get` on.
void append_reply_reads(std::vector<BusCycle>& cycles, int get, int count);
/// The characters read by such cycles.
std::string reply_text(std::span<const BusCycle> cycles);

/// Appends cycles that write a two-letter command into the mailbox's two cells (decision M29) and raise the
/// interrupt that announces it; `control` holds the other bits of the control register.
void append_mail(std::vector<BusCycle>& cycles, std::string_view letters, std::uint8_t control);

// ---- replies: LF CR text LF CR, some with an extra CR before and after (decision M01)

/// Takes the first whole reply off the front of `received`, without its frame; none while it is incomplete.
/// With `echo`, text outside a frame is an echo and is discarded.
std::optional<std::string> take_reply(std::string& received, bool echo = false);
/// "0,-400,12", or as other firmware prints it: "+0, 200,-0012" (decision M99); none if any field is not a
/// number.
std::optional<std::vector<std::int64_t>> decode_numbers(std::string_view reply);
/// Decodes "3F00".
std::optional<std::uint32_t> decode_hex(std::string_view reply);

/// The form of a reply to a question: a reply of another form belongs to another question.
struct ReplyForm {
  enum class Of : std::uint8_t { anything, numbers, hex, greeting, flags, slips, loop };
  Of of = Of::anything;
  int count = 0;  ///< number of axes, for flags and slips
};
bool fits(ReplyForm form, std::string_view reply);

/// Four letters of RA and QA (decision M91).
struct AxisFlags {
  bool plus = true;  ///< direction
  bool done = false, limit = false, home = false;
};
std::optional<AxisFlags> decode_flags(std::string_view letters);
/// Decodes the reply to RI and QI: "PNNN,MNLN,...".
std::vector<AxisFlags> decode_all_flags(std::string_view reply);

/// "VME58 ver 2.24-8S".
struct Greeting {
  std::string model;    ///< "VME58"
  std::string version;  ///< "2.24"
  std::string variant;  ///< "8S"; empty: not reported
};
std::optional<Greeting> decode_greeting(std::string_view reply);

/// Bit `n` of a register: the flag of an axis.
constexpr bool bit(std::uint32_t bits, int n) { return (bits >> n & 1) != 0; }

// ---- data area

struct AxisData {
  std::array<std::int32_t, axis_values> values{};
  [[nodiscard]] std::int32_t operator[](AxisValue v) const { return values[static_cast<std::size_t>(v)]; }
};
/// Appends cycles that read the first `count` values of an axis.
void append_axis_reads(std::vector<BusCycle>& cycles, int axis, int count);

// ---- commands

/// "MA1000,,500;": the places of axes without a value stay empty.
std::string encode_list(std::string_view letters, std::span<const std::optional<std::int64_t>> by_axis);
/// Sent text as shown to the user: without its terminator.
std::string_view without_end(std::string_view text);
/// A number as the board accepts it: a fraction of up to `decimals` digits, none if it is whole.
std::string encode_number(std::int64_t value, int decimals);

}  // namespace hw::vme58
