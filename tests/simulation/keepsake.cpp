#include "tests/simulation/keepsake.h"

#include <algorithm>
#include <cctype>

#include "tests/simulation/steps.h"

namespace hw::simulation {

Words words_of(std::string_view text) {
  Words words;
  std::string word;
  const auto end = [&] {
    const bool room =
        word.size() > 1 && word[0] == 'M' && std::isdigit(static_cast<unsigned char>(word[1])) != 0;
    if (!word.empty() && word != "-" && !room) words.insert(word);  // M242: what a listing says is free
    word.clear();
  };
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-')
      end();
    else
      word += c;
  }
  end();
  return words;
}

Words words_of(const Plan& plan) {
  Words words;
  for (const Step& step : plan.steps) {
    words.merge(words_of(step.text));
    const bool moves = find_verb(step.verb)->moves;
    for (const std::int64_t number : step.numbers)
      if (!moves) words.insert(std::to_string(number));
  }
  return words;
}

bool is_typed_in_part(const Plan& plan, std::string_view word) {
  constexpr std::size_t enough = 2;
  const auto begins_alike = [word](const std::string& typed) {
    return typed.size() >= enough && word.substr(0, enough) == std::string_view(typed).substr(0, enough);
  };
  return std::any_of(plan.steps.begin(), plan.steps.end(), [&](const Step& step) {
    const Words words = words_of(step.text);
    return step.verb.starts_with("type") && std::any_of(words.begin(), words.end(), begins_alike);
  });
}

std::vector<std::string> settings_of(const Emulator& controller, Instant now,
                                     const std::vector<std::string>& questions) {
  constexpr Duration longest_answer = std::chrono::seconds(2);
  const auto copy = controller.clone();
  copy->advance_to(now);
  std::string unsolicited;
  copy->take_output(unsolicited);
  std::vector<std::string> answers;
  for (const std::string& question : questions) {
    copy->receive(question);
    copy->advance_to(now += longest_answer);
    copy->take_output(answers.emplace_back());
  }
  return answers;
}

}  // namespace hw::simulation
