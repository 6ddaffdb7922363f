#include "gui/model/log_lines.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "gui/model/lower_case.h"

namespace hw::gui {
namespace {

bool contains(std::string_view text, std::string_view words) {
  const auto same = [](char a, char b) { return lower_case(a) == lower_case(b); };
  return std::search(text.begin(), text.end(), words.begin(), words.end(), same) != text.end();
}

}  // namespace

void LogLines::follow() {
  const std::size_t came = feed_.lines.drain([this](log::Line& line) {
    for (char& c : line.sentence)
      if (static_cast<unsigned char>(c) < 0x20) c = ' ';  // a row is one line
    list_.push_back(std::move(line));
    if (list_.size() > capacity) list_.pop_front();
  });
  if (came > 0) choose_rows();
}

void LogLines::set_view(const View& view) {
  if (view == view_) return;
  view_ = view;
  choose_rows();
}

void LogLines::choose_rows() {
  rows_.clear();
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (is_shown(list_[i])) rows_.push_back(static_cast<std::uint32_t>(i));
  ++version_;
}

bool LogLines::is_shown(const log::Line& line) const {
  if (line.level > view_.least) return false;
  const std::string_view subject = line.subject;
  if (!view_.family.empty() && subject.substr(0, subject.find('.')) != view_.family) return false;
  return view_.words.empty() || contains(subject, view_.words) || contains(line.sentence, view_.words);
}

void LogLines::append_text(std::string& text, std::size_t begin, std::size_t end) const {
  for (std::size_t row = begin; row < std::min(end, count()); ++row) {
    const log::Line& l = line(row);
    fmt::format_to(std::back_inserter(text), "{} {} {}: {}\n", l.time, log::word_of(l.level), l.subject,
                   l.sentence);
  }
}

}  // namespace hw::gui
