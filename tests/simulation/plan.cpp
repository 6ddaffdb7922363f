#include "tests/simulation/plan.h"

#include <algorithm>
#include <sstream>

#include <fmt/core.h>

#include "tests/simulation/steps.h"

namespace hw::simulation {
namespace {

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\', out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (byte < 32 || byte > 126) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string out_of_quotes(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size() && text[i] != '"'; ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      out += text[i];
    } else if (text[++i] == 'n') {
      out += '\n';
    } else if (text[i] == 'x' && i + 2 < text.size()) {
      out += static_cast<char>(std::stoi(std::string(text.substr(i + 1, 2)), nullptr, 16));
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

}  // namespace

Result<Step> Step::read(const std::string& line) {
  const auto wrong = [&](const char* why) {
    return fail(FaultKind::text, fmt::format("\"{}\": {}.", line, why));
  };
  const auto quote = std::min(line.find('"'), line.size());
  std::istringstream words(line.substr(0, quote));
  Step step;
  double at = 0;
  if (!(words >> at >> step.verb >> step.device)) return wrong("a step is TIME VERB DEVICE NUMBERS \"TEXT\"");
  step.at = Millis(static_cast<std::int64_t>(at * 1000 + 0.5));
  for (std::int64_t number = 0; words >> number;) step.numbers.push_back(number);
  if (quote < line.size()) step.text = out_of_quotes(std::string_view(line).substr(quote + 1));
  const Verb* verb = find_verb(step.verb);
  if (verb == nullptr) return wrong("there is no such verb");
  if (step.numbers.size() != verb->numbers) return wrong("it has another number of numbers");
  return step;
}

std::string Step::written() const {
  std::string line = fmt::format("{}.{:03} {} {}", at.count() / 1000, at.count() % 1000, verb, device);
  for (const std::int64_t number : numbers) line += fmt::format(" {}", number);
  if (!text.empty()) line += " " + in_quotes(text);
  return line;
}

std::string script_of(const std::vector<Step>& calls) {
  std::string script;
  for (const Step& call : calls) {
    const std::string line = call.written();
    script += line.substr(line.find(' ') + 1) + "\n";
  }
  return script;
}

Result<std::vector<Step>> calls_of(std::string_view script) {
  std::vector<Step> calls;
  std::istringstream lines{std::string(script)};
  for (std::string line; std::getline(lines, line);) {
    auto call = Step::read("0 " + line);
    if (!call) return fail(call.error());
    calls.push_back(std::move(*call));
  }
  return calls;
}

std::string Plan::address() const { return model + "@emulator" + (options.empty() ? "" : "," + options); }

std::string Plan::written() const {
  std::string all;
  if (!finding.empty()) all += fmt::format("# {}\n", finding);
  all += fmt::format("model {}\n", model);
  if (!options.empty()) all += fmt::format("options {}\n", options);
  all += fmt::format("seconds {:.3f}\n", seconds(length));
  for (const Step& step : steps) all += step.written() + "\n";
  return all;
}

Result<Plan> Plan::read(std::string_view text) {
  Plan plan;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string head;
    if (!(words >> head)) continue;
    if (head == "#") {
      if (plan.model.empty() && plan.finding.empty()) std::getline(words >> std::ws, plan.finding);
    } else if (head == "model") {
      words >> plan.model;
    } else if (head == "options") {
      words >> plan.options;
    } else if (head == "seconds") {
      double length = 0;
      words >> length;
      plan.length = Millis(static_cast<std::int64_t>(length * 1000 + 0.5));
    } else {
      auto step = Step::read(line);
      if (!step) return fail(step.error());
      plan.steps.push_back(std::move(*step));
    }
  }
  std::stable_sort(plan.steps.begin(), plan.steps.end(),
                   [](const Step& a, const Step& b) { return a.at < b.at; });
  return plan;
}

}  // namespace hw::simulation
