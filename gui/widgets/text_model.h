#pragma once
// A text of lines with a caret, a selection and undo, without any drawing. A place is a line and a byte
// within it, always between two characters.
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hw::gui {

struct TextPlace {
  int line = 0, byte = 0;
  auto operator<=>(const TextPlace&) const = default;
};
struct TextRange {
  TextPlace begin, end;
  bool operator==(const TextRange&) const = default;
};

class TextModel {
 public:
  TextModel() : lines_(1) {}

  /// Replaces the text: clears undo and keeps the caret as near as possible.
  void set_text(std::string_view text);
  [[nodiscard]] std::string text() const;
  [[nodiscard]] int line_count() const { return static_cast<int>(lines_.size()); }
  [[nodiscard]] const std::string& line(int i) const { return lines_[static_cast<std::size_t>(i)]; }
  /// Grows with each change of the text.
  [[nodiscard]] std::uint64_t version() const { return version_; }

  // ---- caret and selection
  [[nodiscard]] TextPlace caret() const { return caret_; }
  [[nodiscard]] bool has_selection() const { return caret_ != anchor_; }
  [[nodiscard]] TextRange selection() const;
  [[nodiscard]] std::string selected() const { return text_of(selection()); }
  /// `extend` keeps the other end of the selection.
  void move_to(TextPlace to, bool extend);
  enum class Step : std::uint8_t { character, word, line_end, text_end };
  void left(Step step, bool extend);
  void right(Step step, bool extend);
  void down(int lines, bool extend);  ///< negative: up; keeps the column
  void select_all();
  void select_word();  ///< around the caret
  void select_line();

  // ---- changes; each is one undo step; typed characters join into one
  void insert(std::string_view typed);
  void backspace(bool word);
  void erase(bool word);
  void replace(const TextRange& what, std::string_view by);
  /// Puts `mark` before each selected line, or removes it when all lines have it. Empty lines stay empty.
  void toggle_comment(std::string_view mark);
  /// Moves the selected lines by two columns to the right, or (direction < 0) back.
  void indent(int direction);
  bool undo();
  bool redo();

  /// The next match after (before) `from`, wrapping around. Case is ignored.
  [[nodiscard]] std::optional<TextRange> find(std::string_view needle, TextPlace from, bool forward) const;
  [[nodiscard]] std::string text_of(const TextRange& s) const;
  /// The nearest existing place.
  [[nodiscard]] TextPlace clamp(TextPlace p) const;
  [[nodiscard]] TextPlace end() const;
  /// Converts between a byte and a column; a tab counts as four columns.
  [[nodiscard]] int column(TextPlace p) const;
  [[nodiscard]] TextPlace at_column(int line, int column) const;
  static constexpr int tab_columns = 4;

 private:
  struct Edit {
    TextPlace at;
    std::string removed, added;
    TextPlace caret_before, anchor_before;
    bool typing = false;  // may be joined by the next typed character
  };
  struct Lines {
    int first, last;
  };
  [[nodiscard]] Lines chosen_lines() const;
  /// Replaces each of these lines by the output of `change(out, line)`, in one undo step.
  template <class Change>
  void change_lines(const Lines& which, Change change);
  TextPlace put(TextPlace at, std::string_view text);
  void cut(const TextRange& s);
  void apply(const TextRange& what, std::string_view by, bool typing);
  [[nodiscard]] bool joins(const Edit& last, const TextRange& what, std::string_view by) const;
  [[nodiscard]] TextPlace before(TextPlace p) const;
  [[nodiscard]] TextPlace after(TextPlace p) const;
  [[nodiscard]] TextPlace word_before(TextPlace p) const;
  [[nodiscard]] TextPlace word_after(TextPlace p) const;
  [[nodiscard]] std::optional<int> find_in_line(std::string_view needle, int line, int from,
                                                bool forward) const;

  std::vector<std::string> lines_;
  TextPlace caret_, anchor_;
  int wanted_column_ = -1;  // kept while moving up or down through shorter lines
  std::vector<Edit> done_, undone_;
  std::uint64_t version_ = 1;
};

}  // namespace hw::gui
