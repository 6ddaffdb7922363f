#pragma once
// Messages from the console to its watchdog, on a socket that preserves message boundaries. The watchdog
// needs only this header and the C library.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/link/wire_share.h"

namespace hw::watchdog {

enum class Kind : std::uint8_t {
  alive = 'A',  ///< the console's io thread works
  will = 'W',   ///< a will to be carried out, with the wire's descriptor if it has one
  taken_back = 'T',
  dying = 'D'  ///< from the handler of a fatal signal: carry out all wills now
};

struct Words {
  std::uint32_t after_ms = 0;
  std::string bytes;  ///< for a window these are bus port messages
  bool operator==(const Words&) const = default;
};

struct Message {
  Kind kind = Kind::alive;
  std::uint32_t id = 0;  ///< id of a will
  WireShare::How how = WireShare::How::none;
  std::uint32_t base = 0;
  std::string place;
  std::vector<Words> words;
};

inline constexpr std::size_t longest_message = 4096;
inline constexpr std::size_t usb_transfer = 64;
inline constexpr unsigned char usb_endpoint_out = 0x02;
inline constexpr std::size_t window_bytes = 0x1000;
/// Period of `alive`, and the silence after which the watchdog carries out the wills.
inline constexpr int alive_every_ms = 200, longest_silence_ms = 1000;
/// When the console itself was silent for so long, it assumes that its wills were carried out.
inline constexpr int believed_for_ms = 900;
/// The descriptor of the socket in the watchdog.
inline constexpr int socket_number = 3;

std::string encode(const Message& message);
/// Decodes a message; nullopt: it is not valid.
std::optional<Message> decode(std::string_view bytes);

}  // namespace hw::watchdog
