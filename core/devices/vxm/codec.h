#pragma once
// Encodes commands and decodes replies of the VXM. Pure functions; any bytes have a meaning, if only "not
// understood".
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/units.h"

namespace hw::vxm {

// ---- commands, ender included, ready to be sent one after another

std::string index_by(int motor, Steps distance);
std::string index_to(int motor, Steps position);
std::string home(int motor, Sign sign);
std::string zero_here(int motor);
std::string speed(int motor, int steps_per_second);
std::string acceleration(int motor, int code);
/// Moves both at once: one motor of the Slave (3, 4) and one of the Master (1, 2).
std::string index_pair(int slave_motor, Steps slave_distance, int motor, Steps distance);
/// Stored command that switches an output of this controller, 1 to 4.
std::string output(int number, bool on);
std::string select_program(int slot);
std::string empty_program(int slot);
/// X, Y, Z or T.
std::string ask_position(int motor);
/// By the catalog's mnemonic ("j1M", "Bx", "O", "PMA").
std::string set_param(std::string_view mnemonic, std::int64_t value);
std::string get_param(std::string_view mnemonic);

// ---- replies. Each decoder takes the whole reply, its end included; nullopt: no such reply.

std::optional<Steps> decode_position(std::string_view reply);
/// Decimal number and carriage return. PMA-0 reads as -5 (a number has no minus zero).
std::optional<std::int64_t> decode_number(std::string_view reply);
/// B, R, J or b.
std::optional<char> decode_state(std::string_view reply);
/// "1.30" of getD0, "12-29-04" of getD1.
std::optional<std::string> decode_text_line(std::string_view reply);

struct Listing {
  int slot = -1;
  int free_bytes = 0;
  std::vector<std::string> commands;  ///< one per line, as the controller writes them
};
/// A listing has no end mark; a USB adapter may hold bytes back for 16 ms.
inline constexpr std::uint16_t listing_quiet_ms = 60;
std::optional<Listing> decode_listing(std::string_view reply);

struct Digitized {  ///< the answer to D in Local mode
  std::vector<Steps> positions;
};
std::optional<Digitized> decode_digitized(std::string_view reply, int motors);

/// True if a reply is an error report. That of the Stop input does not count: nothing was refused.
bool reports_error(std::string_view reply);

/// Raw status bytes, by the catalog's numbering.
bool limit_active(unsigned char byte, int axis, Sign sign);
/// Bit n-1 = input n of the catalog (In 1 to 4, then the jog inputs); 1 = high.
std::uint32_t inputs_of(unsigned char byte);

// ---- unsolicited messages

struct Message {
  enum class Kind : std::uint8_t {
    unfinished,  ///< more bytes are needed
    prompt,      ///< ^ a program or move has ended
    limit,       ///< O a limit switch was hit
    waits,       ///< W waits for G
    passed,      ///< @ an index of nonstop indexing has ended
    held,        ///< : and the command before which the controller holds
    error,       ///< E and a letter, or the barred E
    end,         ///< a carriage return alone (G mode)
    unknown,     ///< one byte that belongs to no message
  };
  Kind kind = Kind::unfinished;
  std::size_t length = 0;  ///< in bytes; 0 when unfinished
  std::string_view text;   ///< held: the command
  char letter = 0;         ///< error: its letter
};
/// The first message in unsolicited bytes (not empty).
Message next_message(std::string_view bytes);

// Number of bytes at the front that are no part of the reply: Transaction::unsolicited_length.
std::size_t before_number(std::string_view received);   ///< replies that begin with a digit or sign
std::size_t before_state(std::string_view received);    ///< V
std::size_t before_prompt(std::string_view received);   ///< K, rsm
std::size_t before_listing(std::string_view received);  ///< lst

/// Bytes as shown in a sentence: "<cr>", "<FF>".
std::string printable(std::string_view bytes);

/// Whether a raw status byte of this value could be mistaken for a message.
bool could_be_message(char byte);

struct ErrorWords {
  std::string what, advice;
  bool halts = false;   ///< the controller halts until K
  bool resets = false;  ///< the controller restarts
};
/// The manual's explanation of an error report.
ErrorWords explain_error(char letter);

}  // namespace hw::vxm
