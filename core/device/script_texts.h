#pragma once
// Unsolicited texts, and replies to texts whose senders do not wait: kept until a script reads them. Io
// thread only.
#include <algorithm>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace hw {

class ScriptTexts {
 public:
  void add(std::string text) {
    if (texts_.size() >= most) texts_.pop_front();
    texts_.push_back({next_++, std::move(text)});
  }
  /// The oldest; false: there is none.
  bool take(std::string& text) {
    if (texts_.empty()) return false;
    text = std::move(texts_.front().text);
    texts_.pop_front();
    return true;
  }
  /// The number of the next text.
  [[nodiscard]] std::uint64_t next() const { return next_; }
  /// The same, as the answer to a text sent at `number`: an answer that another sender has taken counts too.
  std::optional<std::string> answer_since(std::uint64_t number) {
    const std::uint64_t before = next_;
    if (auto text = take_since(number)) {
      answered_ = before;
      answer_ = *text;
      return text;
    }
    return answered_ > number ? std::optional(answer_) : std::nullopt;
  }
  /// The oldest text from `number` on that begins with `first` (0: any).
  std::optional<std::string> take_since(std::uint64_t number, char first = 0) {
    const auto found = std::find_if(texts_.begin(), texts_.end(), [&](const Text& t) {
      return t.number >= number && (first == 0 || t.text.starts_with(first));
    });
    if (found == texts_.end()) return std::nullopt;
    std::string text = std::move(found->text);
    texts_.erase(found);
    return text;
  }

 private:
  static constexpr std::size_t most = 256;
  struct Text {
    std::uint64_t number;
    std::string text;
  };
  std::deque<Text> texts_;
  std::uint64_t next_ = 0;
  std::uint64_t answered_ = 0;  ///< next() when the latest answer was taken
  std::string answer_;
};

}  // namespace hw
