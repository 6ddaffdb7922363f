#pragma once
// The newest lines of the program's log (core/base/log.h), as the console lists them: in bounded memory, some
// of them chosen. GUI thread; takes no lock after its making.
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/log_feed.h"

namespace hw::gui {

class LogLines {
 public:
  /// Selects the lines to show.
  struct View {
    std::string_view family{};  ///< of log::families(); empty: all
    log::Level least = log::Level::debug;
    std::string words{};  ///< a part of subject or sentence, in any case; empty: all
    bool operator==(const View&) const = default;
  };

  /// `wake`: any thread, when a line has come.
  explicit LogLines(std::function<void()> wake) : feed_(std::move(wake)) {}

  /// Takes the lines that have come; once a frame.
  void follow();
  void set_view(const View& view);
  [[nodiscard]] const View& view() const { return view_; }
  /// The number of lines shown.
  [[nodiscard]] std::size_t count() const { return rows_.size(); }
  /// 0 is the newest of them.
  [[nodiscard]] const log::Line& line(std::size_t row) const { return list_[rows_[rows_.size() - 1 - row]]; }
  /// Changes whenever the lines shown do.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  /// Lines that came faster than frames; they are in the file only.
  [[nodiscard]] std::uint64_t lost() const { return feed_.lines.lost(); }
  /// Appends the lines shown, rows [begin, end), one each.
  void append_text(std::string& text, std::size_t begin, std::size_t end) const;

  static constexpr std::size_t capacity = 2000;

 private:
  [[nodiscard]] bool is_shown(const log::Line& line) const;
  void choose_rows();

  log::Feed feed_;
  std::deque<log::Line> list_;
  std::vector<std::uint32_t> rows_;  ///< of list_: those shown, oldest first
  View view_;
  std::uint64_t version_ = 0;
};

}  // namespace hw::gui
