#include "transports/watchdog/will_message.h"

#include <cstring>

namespace hw::watchdog {
namespace {

void put(std::string& bytes, std::uint32_t value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}
void put(std::string& bytes, std::string_view text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  std::uint32_t number() {
    std::uint32_t value = 0;
    if (rest_.size() < sizeof value) return bad(), 0;
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
    return value;
  }
  std::string text() {
    const std::uint32_t length = number();
    if (rest_.size() < length) return bad(), std::string();
    std::string text(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return text;
  }
  [[nodiscard]] bool good() const { return good_; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  void bad() {
    good_ = false;
    rest_ = {};
  }
  std::string_view rest_;
  bool good_ = true;
};

bool is_kind(char c) {
  for (const Kind kind : {Kind::alive, Kind::will, Kind::taken_back, Kind::dying})
    if (c == static_cast<char>(kind)) return true;
  return false;
}

}  // namespace

std::string encode(const Message& message) {
  std::string bytes(1, static_cast<char>(message.kind));
  if (message.kind == Kind::alive || message.kind == Kind::dying) return bytes;
  put(bytes, message.id);
  if (message.kind == Kind::taken_back) return bytes;
  put(bytes, static_cast<std::uint32_t>(message.how));
  put(bytes, message.base);
  put(bytes, message.place);
  for (const Words& words : message.words) {
    put(bytes, words.after_ms);
    put(bytes, words.bytes);
  }
  return bytes;
}

std::optional<Message> decode(std::string_view bytes) {
  if (bytes.empty() || !is_kind(bytes.front())) return std::nullopt;
  Message message;
  message.kind = static_cast<Kind>(bytes.front());
  Reader reader(bytes.substr(1));
  if (message.kind == Kind::will || message.kind == Kind::taken_back) message.id = reader.number();
  if (message.kind == Kind::will) {
    const std::uint32_t how = reader.number();
    if (how > static_cast<std::uint32_t>(WireShare::How::memory)) return std::nullopt;
    message.how = static_cast<WireShare::How>(how);
    message.base = reader.number();
    message.place = reader.text();
    while (reader.good() && !reader.at_end()) {
      Words words;
      words.after_ms = reader.number();
      words.bytes = reader.text();
      if (reader.good()) message.words.push_back(std::move(words));
    }
  }
  if (!reader.good() || !reader.at_end()) return std::nullopt;
  return message;
}

}  // namespace hw::watchdog
