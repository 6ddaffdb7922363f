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

/// Characters that wait between get and put.
constexpr int waiting(int put, int get) { return (put - get) & (ring_cells - 1); }
/// How many more fit.
constexpr int room(int put, int get) { return ring_cells - 1 - waiting(put, get); }
constexpr int advanced(int index, int by) { return (index + by) & (ring_cells - 1); }
/// An index as the board may show it; anything else was garbled, or no board is there.
constexpr bool is_index(std::uint32_t value) { return value < static_cast<std::uint32_t>(ring_cells); }

/// Cycles that put `text` into the command ring from `put` on and then read it back. It fits: see room().
void append_text(std::vector<BusCycle>& cycles, std::string_view text, int put);
/// Cycles that read `count` characters of the reply ring from `get` on.
void append_reply_reads(std::vector<BusCycle>& cycles, int get, int count);
/// The characters that such cycles brought.
std::string reply_text(std::span<const BusCycle> cycles);

/// A command of two letters in the mailbox's two cells (decision M29), and the interrupt that announces it;
/// `control` is what else the control register holds.
void append_mail(std::vector<BusCycle>& cycles, std::string_view letters, std::uint8_t control);

// ---- replies: LF CR text LF CR, some with one CR more before and behind (decision M01)

/// Takes the first whole reply off the front of `received`, without its frame; nothing while it is
/// unfinished. With `echo` what stands outside of a frame is what the board was sent, and is let go.
std::optional<std::string> take_reply(std::string& received, bool echo = false);
/// "0,-400,12", and as other firmware prints: "+0,  200,-0012" (decision M99); nothing when one of them is no
/// number.
std::optional<std::vector<std::int64_t>> decode_numbers(std::string_view reply);
/// "3F00".
std::optional<std::uint32_t> decode_hex(std::string_view reply);

/// What a reply to some question looks like: one that looks otherwise belongs to another.
struct ReplyForm {
  enum class Of : std::uint8_t { anything, numbers, hex, greeting, flags, slips, loop };
  Of of = Of::anything;
  int count = 0;  ///< of flags and slips: axes
};
bool fits(ReplyForm form, std::string_view reply);

/// Four letters of RA and QA (decision M91).
struct AxisFlags {
  bool plus = true;  ///< direction
  bool done = false, limit = false, home = false;
};
std::optional<AxisFlags> decode_flags(std::string_view letters);
/// "PNNN,MNLN,...": RI and QI.
std::vector<AxisFlags> decode_all_flags(std::string_view reply);

/// "VME58 ver 2.24-8S".
struct Greeting {
  std::string model;    ///< "VME58"
  std::string version;  ///< "2.24"
  std::string variant;  ///< "8S"; empty: not told
};
std::optional<Greeting> decode_greeting(std::string_view reply);

/// Bit `n` of a register: an axis' flag.
constexpr bool bit(std::uint32_t bits, int n) { return (bits >> n & 1) != 0; }

// ---- data area

struct AxisData {
  std::array<std::int32_t, axis_values> values{};
  [[nodiscard]] std::int32_t operator[](AxisValue v) const { return values[static_cast<std::size_t>(v)]; }
};
/// Cycles that read the first `count` values of an axis.
void append_axis_reads(std::vector<BusCycle>& cycles, int axis, int count);

// ---- commands

/// "MA1000,,500;": places of axes that are not meant stay empty.
std::string encode_list(std::string_view letters, std::span<const std::optional<std::int64_t>> by_axis);
/// Text that was sent, as it is shown: without what ends it.
std::string_view without_end(std::string_view text);
/// As the board takes it: a fraction of up to `decimals` digits, none when it is whole.
std::string encode_number(std::int64_t value, int decimals);

}  // namespace hw::vme58
