#pragma once
// How the lines of an edited text relate to those of an older one: the lines before the first change and
// after the last one are the same.
#include <string_view>

namespace hw::gui {

class TextDiff {
 public:
  TextDiff(std::string_view older, std::string_view newer);
  [[nodiscard]] bool equal() const { return equal_; }
  /// First line (from 0) that differs; -1 when the texts are equal.
  [[nodiscard]] int first_changed() const { return equal_ ? -1 : same_head_; }
  /// The present line of a line of the older text; -1: changed or gone.
  [[nodiscard]] int line_now(int older_line) const;

 private:
  int same_head_ = 0, same_tail_ = 0, older_lines_ = 0, newer_lines_ = 0;
  bool equal_ = true;
};

}  // namespace hw::gui
