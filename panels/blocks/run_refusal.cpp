#include "panels/blocks/run_refusal.h"

#include <charconv>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;
namespace {

/// The number after the first "Line " or "line ": "12"; in "step 3.1 (move)": "3.1".
std::string_view number_behind(std::string_view words, std::string_view noun) {
  for (std::size_t at = words.find(noun); at != words.npos; at = words.find(noun, at + 1)) {
    std::string_view number = words.substr(at + noun.size());
    number = number.substr(0, number.find_first_not_of("0123456789."));
    while (number.ends_with('.')) number.remove_suffix(1);
    if (!number.empty()) return number;
  }
  return {};
}

std::string step_number(const sequence::StepPath& path) {
  std::string number;
  for (const std::size_t place : path) number += fmt::format("{}{}", number.empty() ? "" : ".", place + 1);
  return number;
}

int row_named(std::string_view words, const SequenceText& text, const BlockRows& rows) {
  const std::string_view step = number_behind(words, "tep ");
  for (std::size_t row = 0; !step.empty() && row < rows.size(); ++row)
    if (step_number(rows.path(row)) == step) return static_cast<int>(row);
  const std::string_view number = number_behind(words, "ine ");
  std::size_t line = 0;
  std::from_chars(number.data(), number.data() + number.size(), line);
  if (line == 0 || line > text.step_of_line.size()) return -1;
  const int row = text.step_of_line[line - 1];
  return row >= 0 && ix(row) < rows.size() ? row : -1;
}

}  // namespace

void RunRefusal::set(std::string words, std::string text, std::optional<int> from) {
  words_ = std::move(words), text_ = std::move(text), from_ = from;
  found_in_ = ~std::uint64_t{0};
}

/// The row is looked up again, because blocks that write no text may be moved while the card is open.
void RunRefusal::find_row(const SequenceText& text, const BlockRows& rows) {
  if (found_in_ == rows.version()) return;
  const bool has_moved = found_in_ != ~std::uint64_t{0};
  found_in_ = rows.version();
  row_ = !from_ ? row_named(words_, text, rows) : has_moved ? -1 : *from_;
  if (row_ >= 0 && ix(row_) >= rows.size()) row_ = -1;
  show_ = row_ < 0 ? "" : fmt::format("Show block {}", step_number(rows.path(ix(row_))));
}

int RunRefusal::draw(Frame& f, const SequenceText& text, const BlockRows& rows, const Rect& bar) {
  if (words_.empty()) return -1;
  if (text.text != text_) return forget(), -1;
  find_row(text, rows);
  const Action show[] = {{.id = "blocks/run_refused/show", .label = show_, .brief = "Show it"}};
  card_.begin(f,
              {.id = "blocks/run_refused",
               .about = from_ ? "Run from here" : "Run",
               .words = words_,
               .actions = std::span(show, show_.empty() ? 0 : 1)},
              bar);
  const RefusalTouch touched = card_.end();
  if (touched.closed) forget();
  return touched.action == 0 ? row_ : -1;
}

}  // namespace hw::panels
