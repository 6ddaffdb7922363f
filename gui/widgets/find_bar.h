#pragma once
// Search in an editor: a row above the text. Ctrl+F opens it. Enter and F3 find the next match. Esc or the
// cross closes it.
#include <string>
#include <string_view>

#include "gui/surface/ui.h"
#include "gui/widgets/text_model.h"

namespace hw::gui {

class FindBar {
 public:
  void open(Ui& ui, std::string_view id, const TextModel& model);
  [[nodiscard]] bool is_open() const { return open_; }
  [[nodiscard]] const std::string& needle() const { return needle_; }
  /// Draws the row, 40 high, when open. Returns true when the caret moved to a match.
  bool draw(Ui& ui, std::string_view id, TextModel& model);
  /// Returns true when there is a match.
  bool next(TextModel& model, bool forward);

 private:
  void count(const TextModel& model);
  std::string needle_, counted_needle_;
  std::uint64_t counted_version_ = 0;
  int count_ = 0;
  bool open_ = false, failed_ = false;
};

}  // namespace hw::gui
