#pragma once
// What the console says to its watchdog: one message each on a socket of the kind that keeps them apart.
// Nothing but this header and the C library is compiled into the watchdog.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/link/wire_share.h"

namespace hw::watchdog {

enum class Kind : std::uint8_t {
  alive = 'A',  ///< the console's io thread lives
  will = 'W',   ///< to be carried out; a descriptor comes with it, where the way to the wire has one
  taken_back = 'T',
  dying = 'D'  ///< from a handler of a fatal signal: carry all of them out now
};

struct Words {
  std::uint32_t after_ms = 0;
  std::string bytes;  ///< of a window: messages of the bus port
  bool operator==(const Words&) const = default;
};

struct Message {
  Kind kind = Kind::alive;
  std::uint32_t id = 0;  ///< of a will
  WireShare::How how = WireShare::How::none;
  std::uint32_t base = 0;
  std::string place;
  std::vector<Words> words;
};

inline constexpr std::size_t longest_message = 4096;
inline constexpr std::size_t usb_transfer = 64;
inline constexpr unsigned char usb_endpoint_out = 0x02;
inline constexpr std::size_t window_bytes = 0x1000;
/// The console says that it lives; the wills are carried out when it has not for so long.
inline constexpr int alive_every_ms = 200, longest_silence_ms = 1000;
/// A console that was silent for so long takes its wills for carried out.
inline constexpr int believed_for_ms = 900;
/// The socket, in the watchdog.
inline constexpr int socket_number = 3;

std::string encode(const Message& message);
/// Empty: not one of ours.
std::optional<Message> decode(std::string_view bytes);

}  // namespace hw::watchdog
