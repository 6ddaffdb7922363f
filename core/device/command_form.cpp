#include "core/device/command_form.h"

#include <algorithm>

#include "core/base/number_text.h"

namespace hw {

CommandForm::CommandForm(const CommandInfo& command, const std::vector<AxisInfo>& axes) {
  for (const AxisInfo& axis : axes)
    if (axis.name.size() == 1) axis_names_ += axis.name;
  const bool brackets = command.form.find('[') != command.form.npos;
  if (brackets && command.example.find('[') == command.example.npos)
    read_brackets(command.form);
  else
    read_letters(command.form, command.example);
  for (const Part& p : parts_) {
    if (p.place != Place::literal) break;
    head_ += p.literal;
  }
}

namespace {

/// "-2", "0.25": length of the number at the start of `text`; npos: none.
std::size_t length_of_number(std::string_view text) {
  std::size_t n = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
  const std::size_t first = n;
  while (n < text.size() && is_digit(text[n])) ++n;
  if (n == first) return text.npos;
  if (n + 1 < text.size() && text[n] == '.' && is_digit(text[n + 1]))
    for (++n; n < text.size() && is_digit(text[n]);) ++n;
  return n;
}

}  // namespace

// In "rsm" the m is a letter; in "SmMx" it stands for a number. A place whose example has a sign accepts a
// sign.
void CommandForm::read_letters(const std::string& form, const std::string& example) {
  std::size_t e = 0;
  for (std::size_t i = 0; i < form.size(); ++i) {
    const char c = form[i];
    const bool same = e < example.size() && example[e] == c;
    const std::string_view rest = std::string_view(example).substr(std::min(e, example.size()));
    if (!same && rest.size() > 1 && rest[0] == '-' && is_digit(rest[1])) {
      parts_.push_back({Place::number});
      e += length_of_number(rest);
      continue;
    }
    if (!same && e < example.size() && is_digit(example[e])) {
      const bool letter_follows = i + 1 < form.size() && !is_digit(form[i + 1]);
      const bool one = letter_follows && (e + 1 >= example.size() || !is_digit(example[e + 1]));
      parts_.push_back({one ? Place::digit : Place::digits});
      do ++e;
      while (!one && e < example.size() && is_digit(example[e]));
      continue;
    }
    parts_.push_back({Place::literal, c});
    if (same) ++e;
  }
}

void CommandForm::read_brackets(std::string_view form) {
  bool behind_equals = false;
  const bool goes_on = form.ends_with("...");
  while (!form.empty()) {
    if (goes_on && form.front() == '[' && form.find(',') != form.npos) {
      parts_.push_back({Place::list});
      return;
    }
    if (form == "...") {
      parts_.push_back({Place::text});
      return;
    }
    if (form.front() != '[') {
      behind_equals = behind_equals || form.front() == '=';
      parts_.push_back({Place::literal, form.front()});
      form.remove_prefix(1);
      continue;
    }
    const auto end = std::min(form.find(']'), form.size() - 1);
    const std::string_view inside = form.substr(1, end - 1);
    const bool numbers = !inside.empty() && std::all_of(inside.begin(), inside.end(), [](char c) {
      return is_digit(c) || c == '-' || c == ',';
    });
    Place place = behind_equals ? Place::text : Place::number;
    if (inside == "axis") place = Place::axis;
    if (inside == "+/-") place = Place::sign;
    if (numbers && !behind_equals) place = Place::digits;
    parts_.push_back({place});
    form.remove_prefix(end + 1);
  }
}

std::size_t CommandForm::taken(const Part& part, std::string_view text) const {
  constexpr auto no = std::string_view::npos;
  std::size_t n = 0;
  switch (part.place) {
    case Place::literal: return text[0] == part.literal ? 1 : no;
    case Place::digit: return is_digit(text[0]) ? 1 : no;
    case Place::axis: return axis_names_.find(text[0]) != axis_names_.npos ? 1 : no;
    case Place::sign: return text[0] == '+' || text[0] == '-' ? 1 : no;
    case Place::text: return text.size();
    case Place::number: return length_of_number(text);
    case Place::list:
      n = text.find_first_not_of("0123456789+-.,; ");
      return n == no ? text.size() : n > 0 ? n : no;
    case Place::digits:
      while (n < text.size() && is_digit(text[n])) ++n;
      return n > 0 ? n : no;
  }
  return no;
}

CommandForm::Match CommandForm::match(std::string_view text) const {
  for (const Part& part : parts_) {
    if (text.empty()) return part.place == Place::text ? Match::whole : Match::begins;
    const std::size_t n = taken(part, text);
    if (n == text.npos) return Match::none;
    text.remove_prefix(n);
  }
  return text.empty() ? Match::whole : Match::none;
}

}  // namespace hw
