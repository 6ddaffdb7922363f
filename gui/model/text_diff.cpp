#include "gui/model/text_diff.h"

#include <algorithm>

namespace hw::gui {

static int lines_in(std::string_view text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1;
}

static std::string_view take_first_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

static std::string_view take_last_line(std::string_view& text) {
  const auto begin = text.rfind('\n');
  if (begin == text.npos) {
    const std::string_view line = text;
    text = {};
    return line;
  }
  const std::string_view line = text.substr(begin + 1);
  text.remove_suffix(text.size() - begin);
  return line;
}

TextDiff::TextDiff(std::string_view older, std::string_view newer)
    : older_lines_(lines_in(older)), newer_lines_(lines_in(newer)), equal_(older == newer) {
  const int most = std::min(older_lines_, newer_lines_);
  std::string_view a = older, b = newer;
  while (same_head_ < most && take_first_line(a) == take_first_line(b)) ++same_head_;
  a = older, b = newer;
  while (same_head_ + same_tail_ < most && take_last_line(a) == take_last_line(b)) ++same_tail_;
}

int TextDiff::line_now(int line) const {
  if (line < 0 || line >= older_lines_) return -1;
  if (equal_ || line < same_head_) return line;
  if (line >= older_lines_ - same_tail_) return line + newer_lines_ - older_lines_;
  return -1;
}

}  // namespace hw::gui
