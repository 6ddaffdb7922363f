#include "core/devices/arcus/emulator_command.h"

namespace hw::arcus {
namespace {

constexpr std::string_view digits = "0123456789";

/// Reads and writes of settings: their forms stand in the facts.
std::optional<Answer> setting_answer(Controller& c, std::string_view text) {
  const std::string_view letters = c.model().axis_letters;
  for (const SettingFact& fact : c.model().settings) {
    if (text.front() != fact.form.front()) continue;
    const auto equals = text.find('=');
    const bool writes = equals != std::string_view::npos;
    const auto found = match(fact.form, text.substr(0, equals), letters);
    if (!found) continue;
    const bool indexed = fact.form.find('n') != std::string_view::npos;
    const auto value = writes ? c.settings().parse(fact, text.substr(equals + 1)) : std::nullopt;
    if (indexed && (found->index < 1 || found->index > fact.count)) return Answer(Refusal::bad_index);
    const int which = indexed ? static_cast<int>(found->index) - 1 : found->axis;
    if (!writes) return Answer(c.settings().text(fact, c.read_setting(fact.id, which)));
    if (!value) return Answer(Refusal::unknown);
    return Answer(c.write_setting(fact.id, *value, which));
  }
  return std::nullopt;
}

}  // namespace

std::optional<Arguments> match(std::string_view form, std::string_view text, std::string_view axis_letters) {
  Arguments found;
  for (const char f : form) {
    if (f == 'v') {
      found.value = text;
      return found;
    }
    if (text.empty()) return std::nullopt;
    if (f == 'n') {
      const std::string_view number = text.substr(0, text.find_first_not_of(digits));
      constexpr std::size_t most_digits = 9;
      if (number.empty()) return std::nullopt;
      found.index = number.size() > most_digits ? INT32_MAX : *parse_integer(number);
      text.remove_prefix(number.size());
      continue;
    }
    const char c = text.front();
    if (f == 'a') {
      const auto axis = axis_letters.find(c);
      if (axis == std::string_view::npos) return std::nullopt;
      found.axis = static_cast<int>(axis);
    } else if (f == 's') {
      if (c != '+' && c != '-') return std::nullopt;
      found.sign = c == '+' ? Sign::plus : Sign::minus;
    } else if (f != c) {
      return std::nullopt;
    }
    text.remove_prefix(1);
  }
  if (!text.empty()) return std::nullopt;
  return found;
}

std::string without_blanks(std::string_view text) {
  const auto trimmed = [](std::string_view t) {
    const auto begin = t.find_first_not_of(' ');
    return begin == std::string_view::npos ? std::string_view()
                                           : t.substr(begin, t.find_last_not_of(' ') - begin + 1);
  };
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) return std::string(trimmed(text));
  return std::string(trimmed(text.substr(0, equals))) + "=" + std::string(trimmed(text.substr(equals + 1)));
}

std::string answer(Controller& controller, std::span<const Command> own, std::string_view text) {
  const std::string clean = without_blanks(text);
  Answer answer(Refusal::unknown);
  const auto try_table = [&](std::span<const Command> table) {
    for (const Command& command : table) {
      if (command.form.front() != clean.front() && command.form.front() != 'a') continue;
      const auto found = match(command.form, clean, controller.model().axis_letters);
      if (!found) continue;
      answer = command.run(controller, *found);
      return true;
    }
    return false;
  };
  if (!clean.empty()) {
    if (auto done = setting_answer(controller, clean))
      answer = *done;
    else if (!try_table(common_commands()))
      try_table(own);
  }
  if (answer.refusal == Refusal::none) return answer.text;
  const std::string_view words = controller.model().refusal(answer.refusal);
  return words.empty() ? "?" + std::string(text) : std::string(words);
}

std::optional<std::int64_t> number_in(std::string_view text, std::int64_t min, std::int64_t max) {
  const auto n = parse_integer(text);
  return n && *n >= min && *n <= max ? n : std::nullopt;
}

std::optional<std::int64_t> position_in(std::string_view text) {
  return number_in(text, position_min, position_max);
}

}  // namespace hw::arcus
