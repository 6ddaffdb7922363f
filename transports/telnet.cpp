#include "transports/telnet.h"

namespace hw::telnet {
namespace {

constexpr std::size_t longest_suboption = 64;

void put(std::string& wire, std::initializer_list<unsigned char> bytes) {
  for (const unsigned char b : bytes) wire += static_cast<char>(b);
}

void ask(ComPort what, unsigned char value, std::string& wire) {
  put(wire, {iac, sb, com_port, what, value, iac, se});  // no value of ours is 255
}

bool ours(unsigned char option) {
  return option == binary || option == suppress_go_ahead || option == com_port;
}

}  // namespace

void escape(std::string_view data, std::string& wire) {
  for (const char c : data) {
    wire += c;
    if (static_cast<unsigned char>(c) == iac) wire += c;
  }
}

std::string offer() {
  std::string wire;
  put(wire, {iac, will, com_port});
  put(wire, {iac, will, binary, iac, do_, binary});
  put(wire, {iac, will, suppress_go_ahead, iac, do_, suppress_go_ahead});
  return wire;
}

void ask_rate(int baud, std::string& wire) {
  put(wire, {iac, sb, com_port, set_baudrate});
  std::string number;
  for (int shift = 24; shift >= 0; shift -= 8) number += static_cast<char>((baud >> shift) & 0xFF);
  escape(number, wire);
  put(wire, {iac, se});
}

std::string ask_settings(int baud) {
  std::string wire;
  ask_rate(baud, wire);
  ask(set_datasize, 8, wire);
  ask(set_parity, 1, wire);    // none
  ask(set_stopsize, 1, wire);  // one
  ask(set_control, 1, wire);   // no flow control
  ask(set_linestate_mask, 0, wire);
  ask(set_modemstate_mask, 0, wire);
  return wire;
}

void Receiver::take(std::string_view wire, std::string& data, std::string& reply) {
  for (const char c : wire) {
    const auto byte = static_cast<unsigned char>(c);
    switch (state_) {
      case State::data:
        if (byte == iac) {
          state_ = State::command;
        } else {
          data += c;
        }
        break;
      case State::command:
        state_ = State::data;
        if (byte == iac) {
          data += c;
        } else if (byte == sb) {
          sub_.clear();
          state_ = State::sub;
        } else if (byte >= will && byte <= dont) {
          verb_ = byte;
          state_ = State::option;
        }
        break;
      case State::option:
        negotiate(verb_, byte, reply);
        state_ = State::data;
        break;
      case State::sub:
        if (byte == iac) {
          state_ = State::sub_command;
        } else if (sub_.size() < longest_suboption) {
          sub_ += c;
        }
        break;
      case State::sub_command:
        if (byte == se) {
          take_suboption();
          state_ = State::data;
        } else {
          if (sub_.size() < longest_suboption) sub_ += c;
          state_ = State::sub;
        }
        break;
    }
  }
}

// Agreement to our own offers needs no reply. Each other option is declined once.
void Receiver::negotiate(unsigned char verb, unsigned char option, std::string& reply) {
  if (option == com_port && (verb == do_ || verb == dont)) word_.com_port = verb == do_;
  if (ours(option)) return;
  if (verb == do_ && !std::exchange(refused_do_[option], true)) put(reply, {iac, wont, option});
  if (verb == will && !std::exchange(refused_will_[option], true)) put(reply, {iac, dont, option});
}

void Receiver::take_suboption() {
  const auto at = [this](std::size_t i) { return static_cast<unsigned char>(sub_[i]); };
  if (sub_.size() < 3 || at(0) != com_port) return;
  switch (at(1)) {
    case set_baudrate + answered:
      if (sub_.size() < 6) break;
      word_.baud = at(2) << 24 | at(3) << 16 | at(4) << 8 | at(5);
      ++word_.rates;
      break;
    case set_datasize + answered: word_.datasize = at(2); break;
    case set_parity + answered: word_.parity = at(2); break;
    case set_stopsize + answered: word_.stopsize = at(2); break;
    default: break;  // states and modem lines: ignored
  }
}

}  // namespace hw::telnet
