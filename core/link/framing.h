#pragma once
// The shape of a reply: how its end is recognised.
#include <cstdint>
#include <optional>
#include <string_view>

namespace hw {

struct ReplyShape {
  enum class Kind : std::uint8_t {
    none,       ///< no reply
    fixed,      ///< exactly `count` bytes
    lines,      ///< `count` lines, each ended by `terminator`
    text,       ///< one text, ended by CR or by NUL, whichever the device uses
    quiet_end,  ///< lines until nothing came for `quiet_ms` (lists without an end mark)
    message,    ///< up to its closing zero, on a wire that carries messages
  };
  Kind kind = Kind::none;
  std::uint16_t count = 0;
  char terminator = '\r';
  std::uint16_t quiet_ms = 0;

  static ReplyShape nothing() { return {}; }
  static ReplyShape bytes(std::uint16_t n) { return of(Kind::fixed, n, '\r', 0); }
  static ReplyShape line(char end = '\r') { return of(Kind::lines, 1, end, 0); }
  static ReplyShape several_lines(std::uint16_t n, char end = '\r') { return of(Kind::lines, n, end, 0); }
  static ReplyShape until_quiet(std::uint16_t ms, char end = '\r') { return of(Kind::quiet_end, 0, end, ms); }

  static ReplyShape text() { return of(Kind::text, 1, '\r', 0); }
  static ReplyShape message() { return of(Kind::message, 1, '\0', 0); }

  /// Length of the reply at the start of `received`, once it is complete. quiet_end is never complete by its
  /// bytes.
  [[nodiscard]] std::optional<std::size_t> complete(std::string_view received) const;

 private:
  static ReplyShape of(Kind k, std::uint16_t n, char end, std::uint16_t quiet) {
    ReplyShape s;
    s.kind = k, s.count = n, s.terminator = end, s.quiet_ms = quiet;
    return s;
  }
};

}  // namespace hw
