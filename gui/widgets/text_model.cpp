#include "gui/widgets/text_model.h"

#include <algorithm>
#include <cctype>

#include "gui/model/lower_case.h"

namespace hw::gui {
namespace {

bool is_inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || (c & 0x80); }
/// The end of `text` inserted at `at`.
TextPlace end_of(TextPlace at, std::string_view text) {
  const auto newlines = static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  if (newlines == 0) return {at.line, at.byte + static_cast<int>(text.size())};
  return {at.line + newlines, static_cast<int>(text.size() - text.rfind('\n') - 1)};
}

/// Files from other systems end their lines with CR LF or CR.
std::string with_unix_lines(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r')
      out += text[i];
    else if (i + 1 >= text.size() || text[i + 1] != '\n')
      out += '\n';
  }
  return out;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t") == std::string_view::npos; }

}  // namespace

void TextModel::set_text(std::string_view text) {
  const std::string clean = with_unix_lines(text);
  lines_.assign(1, {});
  put({0, 0}, clean);
  done_.clear();
  undone_.clear();
  caret_ = anchor_ = clamp(caret_);
  wanted_column_ = -1;
  ++version_;
}

std::string TextModel::text() const { return text_of({{0, 0}, end()}); }

TextPlace TextModel::end() const { return {line_count() - 1, static_cast<int>(lines_.back().size())}; }

TextPlace TextModel::clamp(TextPlace p) const {
  p.line = std::clamp(p.line, 0, line_count() - 1);
  const std::string& l = line(p.line);
  p.byte = std::clamp(p.byte, 0, static_cast<int>(l.size()));
  while (p.byte > 0 && p.byte < static_cast<int>(l.size()) &&
         is_inside_character(l[static_cast<std::size_t>(p.byte)]))
    --p.byte;
  return p;
}

std::string TextModel::text_of(const TextRange& s) const {
  const auto part = [&](int i, int from, int to) {
    return std::string_view(line(i)).substr(static_cast<std::size_t>(from),
                                            static_cast<std::size_t>(to - from));
  };
  if (s.begin.line == s.end.line) return std::string(part(s.begin.line, s.begin.byte, s.end.byte));
  std::string out(part(s.begin.line, s.begin.byte, static_cast<int>(line(s.begin.line).size())));
  for (int i = s.begin.line + 1; i < s.end.line; ++i) out.append("\n").append(line(i));
  return out.append("\n").append(part(s.end.line, 0, s.end.byte));
}

int TextModel::column(TextPlace p) const {
  int n = 0;
  const std::string& l = line(p.line);
  for (int i = 0; i < p.byte; ++i) {
    const char c = l[static_cast<std::size_t>(i)];
    if (!is_inside_character(c)) n += c == '\t' ? tab_columns : 1;
  }
  return n;
}

TextPlace TextModel::at_column(int line_index, int wanted) const {
  const std::string& l = line(line_index);
  int n = 0;
  std::size_t i = 0;
  while (i < l.size()) {
    const int width = l[i] == '\t' ? tab_columns : 1;
    if (n + (width + 1) / 2 > wanted) break;
    n += width;
    do ++i;
    while (i < l.size() && is_inside_character(l[i]));
  }
  return {line_index, static_cast<int>(i)};
}

TextRange TextModel::selection() const {
  return caret_ < anchor_ ? TextRange{caret_, anchor_} : TextRange{anchor_, caret_};
}

void TextModel::move_to(TextPlace to, bool extend) {
  caret_ = clamp(to);
  if (!extend) anchor_ = caret_;
  wanted_column_ = -1;
  if (!done_.empty()) done_.back().typing = false;
}

TextPlace TextModel::before(TextPlace p) const {
  if (p.byte == 0) return p.line == 0 ? p : TextPlace{p.line - 1, static_cast<int>(line(p.line - 1).size())};
  return clamp({p.line, p.byte - 1});
}

TextPlace TextModel::after(TextPlace p) const {
  const std::string& l = line(p.line);
  if (p.byte >= static_cast<int>(l.size())) return p.line + 1 < line_count() ? TextPlace{p.line + 1, 0} : p;
  auto i = static_cast<std::size_t>(p.byte) + 1;
  while (i < l.size() && is_inside_character(l[i])) ++i;
  return {p.line, static_cast<int>(i)};
}

TextPlace TextModel::word_before(TextPlace p) const {
  if (p.byte == 0) return before(p);
  const std::string& l = line(p.line);
  auto i = static_cast<std::size_t>(p.byte);
  while (i > 0 && !is_word(l[i - 1])) --i;
  while (i > 0 && is_word(l[i - 1])) --i;
  return {p.line, static_cast<int>(i)};
}

TextPlace TextModel::word_after(TextPlace p) const {
  const std::string& l = line(p.line);
  auto i = static_cast<std::size_t>(p.byte);
  if (i >= l.size()) return after(p);
  while (i < l.size() && is_word(l[i])) ++i;
  while (i < l.size() && !is_word(l[i])) ++i;
  return {p.line, static_cast<int>(i)};
}

void TextModel::left(Step step, bool extend) {
  if (has_selection() && !extend && step == Step::character) return move_to(selection().begin, false);
  switch (step) {
    case Step::character: return move_to(before(caret_), extend);
    case Step::word: return move_to(word_before(caret_), extend);
    case Step::text_end: return move_to({0, 0}, extend);
    case Step::line_end: break;
  }
  // Home goes to the first letter, then to the start of the line.
  const std::size_t indent = std::min(line(caret_.line).find_first_not_of(" \t"), line(caret_.line).size());
  move_to({caret_.line, caret_.byte == static_cast<int>(indent) ? 0 : static_cast<int>(indent)}, extend);
}

void TextModel::right(Step step, bool extend) {
  if (has_selection() && !extend && step == Step::character) return move_to(selection().end, false);
  switch (step) {
    case Step::character: return move_to(after(caret_), extend);
    case Step::word: return move_to(word_after(caret_), extend);
    case Step::text_end: return move_to(end(), extend);
    case Step::line_end: break;
  }
  move_to({caret_.line, static_cast<int>(line(caret_.line).size())}, extend);
}

void TextModel::down(int lines, bool extend) {
  const int wanted = wanted_column_ >= 0 ? wanted_column_ : column(caret_);
  const int target = caret_.line + lines;
  if (target < 0)
    move_to({0, 0}, extend);
  else if (target >= line_count())
    move_to(end(), extend);
  else
    move_to(at_column(target, wanted), extend);
  wanted_column_ = wanted;
}

void TextModel::select_all() {
  move_to({0, 0}, false);
  move_to(end(), true);
}

void TextModel::select_word() {
  const std::string& l = line(caret_.line);
  auto from = static_cast<std::size_t>(caret_.byte), to = from;
  while (from > 0 && is_word(l[from - 1])) --from;
  while (to < l.size() && is_word(l[to])) ++to;
  const int at = caret_.line;
  move_to({at, static_cast<int>(from)}, false);
  move_to({at, static_cast<int>(to)}, true);
}

void TextModel::select_line() {
  const int at = caret_.line;
  move_to({at, 0}, false);
  move_to(at + 1 < line_count() ? TextPlace{at + 1, 0} : end(), true);
}

TextPlace TextModel::put(TextPlace at, std::string_view text) {
  std::string& first = lines_[static_cast<std::size_t>(at.line)];
  const std::string tail = first.substr(static_cast<std::size_t>(at.byte));
  first.resize(static_cast<std::size_t>(at.byte));
  std::vector<std::string> more;
  std::size_t newline = text.find('\n');
  first.append(text.substr(0, newline));
  while (newline != std::string_view::npos) {
    const std::size_t next = text.find('\n', newline + 1);
    more.emplace_back(text.substr(newline + 1, next == std::string_view::npos ? next : next - newline - 1));
    newline = next;
  }
  (more.empty() ? first : more.back()).append(tail);
  lines_.insert(lines_.begin() + at.line + 1, std::make_move_iterator(more.begin()),
                std::make_move_iterator(more.end()));
  return end_of(at, text);
}

void TextModel::cut(const TextRange& s) {
  std::string& first = lines_[static_cast<std::size_t>(s.begin.line)];
  const std::string tail = line(s.end.line).substr(static_cast<std::size_t>(s.end.byte));
  first.resize(static_cast<std::size_t>(s.begin.byte));
  first += tail;
  lines_.erase(lines_.begin() + s.begin.line + 1, lines_.begin() + s.end.line + 1);
}

bool TextModel::joins(const Edit& last, const TextRange& what, std::string_view by) const {
  return last.typing && what.begin == what.end && by != "\n" && what.begin == end_of(last.at, last.added);
}

void TextModel::apply(const TextRange& what, std::string_view by, bool typing) {
  if (what.begin == what.end && by.empty()) return;
  if (typing && !done_.empty() && joins(done_.back(), what, by)) {
    done_.back().added += by;
  } else {
    done_.push_back(Edit{what.begin, text_of(what), std::string(by), caret_, anchor_, typing});
  }
  undone_.clear();
  cut(what);
  caret_ = anchor_ = put(what.begin, by);
  wanted_column_ = -1;
  ++version_;
}

void TextModel::insert(std::string_view typed) {
  const std::string clean = with_unix_lines(typed);
  apply(selection(), clean, clean.size() <= 4 && clean != "\n");
}

void TextModel::backspace(bool word) {
  apply(has_selection() ? selection() : TextRange{word ? word_before(caret_) : before(caret_), caret_}, {},
        false);
}

void TextModel::erase(bool word) {
  apply(has_selection() ? selection() : TextRange{caret_, word ? word_after(caret_) : after(caret_)}, {},
        false);
}

void TextModel::replace(const TextRange& what, std::string_view by) {
  apply({clamp(what.begin), clamp(what.end)}, with_unix_lines(by), false);
}

TextModel::Lines TextModel::chosen_lines() const {
  const TextRange chosen = selection();
  // A selection that ends at the start of a line does not include that line.
  const bool before_it = chosen.end.byte == 0 && chosen.end.line > chosen.begin.line;
  return {chosen.begin.line, chosen.end.line - before_it};
}

template <class Change>
void TextModel::change_lines(const Lines& which, Change change) {
  std::string changed;
  for (int i = which.first; i <= which.last; ++i) {
    if (i > which.first) changed += '\n';
    change(changed, std::string_view(line(i)));
  }
  const TextRange whole{{which.first, 0}, {which.last, static_cast<int>(line(which.last).size())}};
  if (changed == text_of(whole)) return;
  TextPlace caret = caret_, anchor = anchor_;
  const auto size_of = [this](const TextPlace& p) { return static_cast<int>(line(p.line).size()); };
  const int caret_line = size_of(caret), anchor_line = size_of(anchor);
  replace(whole, changed);
  // Caret and anchor stay at their letter, except at the beginning of the line.
  if (caret.byte > 0) caret.byte = std::max(0, caret.byte + size_of(caret) - caret_line);
  if (anchor.byte > 0) anchor.byte = std::max(0, anchor.byte + size_of(anchor) - anchor_line);
  caret_ = clamp(caret);
  anchor_ = clamp(anchor);
}

void TextModel::toggle_comment(std::string_view mark) {
  const Lines which = chosen_lines();
  const std::string_view bare = mark.substr(0, mark.find_last_not_of(' ') + 1);
  bool all = true;
  for (int i = which.first; i <= which.last; ++i) all &= is_blank(line(i)) || line(i).starts_with(bare);
  change_lines(which, [&](std::string& out, std::string_view l) {
    if (is_blank(l))
      out += l;
    else if (all)
      out += l.substr(l.starts_with(mark) ? mark.size() : bare.size());
    else
      out.append(mark).append(l);
  });
}

void TextModel::indent(int direction) {
  constexpr std::string_view step = "  ";
  const Lines which = chosen_lines();
  const bool one = which.first == which.last;
  change_lines(which, [&](std::string& out, std::string_view l) {
    if (direction > 0)
      out.append(is_blank(l) && !one ? std::string_view() : step).append(l);
    else if (l.starts_with('\t'))
      out += l.substr(1);
    else
      out += l.substr(std::min(l.find_first_not_of(' '), std::min(step.size(), l.size())));
  });
  if (one && direction > 0 && !has_selection() && is_blank(line(which.first))) right(Step::line_end, false);
}

bool TextModel::undo() {
  if (done_.empty()) return false;
  Edit edit = std::move(done_.back());
  done_.pop_back();
  cut({edit.at, end_of(edit.at, edit.added)});
  put(edit.at, edit.removed);
  caret_ = edit.caret_before;
  anchor_ = edit.anchor_before;
  edit.typing = false;
  undone_.push_back(std::move(edit));
  ++version_;
  return true;
}

bool TextModel::redo() {
  if (undone_.empty()) return false;
  Edit edit = std::move(undone_.back());
  undone_.pop_back();
  cut({edit.at, end_of(edit.at, edit.removed)});
  caret_ = anchor_ = put(edit.at, edit.added);
  done_.push_back(std::move(edit));
  ++version_;
  return true;
}

std::optional<int> TextModel::find_in_line(std::string_view needle, int line_index, int from,
                                           bool forward) const {
  const std::string& l = line(line_index);
  const auto same = [](char a, char b) { return lower_case(a) == lower_case(b); };
  if (forward) {
    if (from > static_cast<int>(l.size())) return {};
    const auto hit = std::search(l.begin() + from, l.end(), needle.begin(), needle.end(), same);
    if (hit == l.end()) return {};
    return static_cast<int>(hit - l.begin());
  }
  const auto stop = l.begin() + std::clamp(from, 0, static_cast<int>(l.size()));
  const auto hit = std::find_end(l.begin(), stop, needle.begin(), needle.end(), same);
  if (hit == stop) return {};
  return static_cast<int>(hit - l.begin());
}

std::optional<TextRange> TextModel::find(std::string_view needle, TextPlace from, bool forward) const {
  if (needle.empty()) return {};
  const int n = line_count(), size = static_cast<int>(needle.size());
  for (int i = 0; i <= n; ++i) {
    const int at = (from.line + (forward ? i : n - i % n)) % n;
    const int all = static_cast<int>(line(at).size());
    const int start = i == 0 ? from.byte : forward ? 0 : all;
    if (const std::optional<int> hit = find_in_line(needle, at, start, forward))
      return TextRange{{at, *hit}, {at, *hit + size}};
  }
  return {};
}

}  // namespace hw::gui
