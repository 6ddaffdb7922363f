#pragma once
// The telnet layer of RFC 2217: a data stream with embedded commands that begin with IAC. Pure, so that a
// test can play both ends.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace hw::telnet {

enum : unsigned char { iac = 255, dont = 254, do_ = 253, wont = 252, will = 251, sb = 250, se = 240 };
enum Option : unsigned char { binary = 0, suppress_go_ahead = 3, com_port = 44 };
/// Client to server; the server answers with 100 more (RFC 2217, section 3).
enum ComPort : unsigned char {
  set_baudrate = 1,
  set_datasize = 2,
  set_parity = 3,
  set_stopsize = 4,
  set_control = 5,
  set_linestate_mask = 10,
  set_modemstate_mask = 11,
};
inline constexpr unsigned char answered = 100;

/// Appends the data as sent on the wire: IAC doubled.
void escape(std::string_view data, std::string& wire);
/// The options that the client offers first.
std::string offer();
/// Appends the request for a rate.
void ask_rate(int baud, std::string& wire);
/// Requests `baud`, 8N1, no flow control and no reports of line and modem states.
std::string ask_settings(int baud);

/// The settings that the server has reported so far.
struct ServerWord {
  std::optional<bool> com_port;                         ///< whether its port can be set
  std::optional<int> baud, datasize, parity, stopsize;  ///< as confirmed
  int rates = 0;                                        ///< number of rates reported
  [[nodiscard]] bool settings_complete() const { return baud && datasize && parity && stopsize; }
};

/// Parses a received stream.
class Receiver {
 public:
  /// Appends the data in `wire` to `data` and the necessary answers to `reply`.
  void take(std::string_view wire, std::string& data, std::string& reply);
  [[nodiscard]] const ServerWord& word() const { return word_; }
  ServerWord& word() { return word_; }

 private:
  enum class State : std::uint8_t { data, command, option, sub, sub_command };
  void negotiate(unsigned char verb, unsigned char option, std::string& reply);
  void take_suboption();

  State state_ = State::data;
  unsigned char verb_ = 0;
  std::string sub_;
  ServerWord word_;
  std::array<bool, 256> refused_do_{}, refused_will_{};
};

}  // namespace hw::telnet
