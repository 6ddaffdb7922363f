#include "core/device/tool_off.h"

#include <algorithm>
#include <charconv>
#include <map>

#include <fmt/format.h>

#include "core/sequence/sequence.h"
#include "core/sequence/steps_in.h"

namespace hw {
namespace {

constexpr std::string_view mark = "Tool off:";
constexpr int most_outputs_of_a_controller = 32;

/// The final state of each output that the steps switch.
void leave_outputs(const sequence::StepList& steps, int outputs, std::map<int, bool>& left) {
  for (const sequence::Step& step : steps) {
    if (step.skipped) continue;
    if (const auto* inner = steps_in(step)) leave_outputs(*inner, outputs, left);
    const auto* o = std::get_if<sequence::Output>(&step.body);
    if (!o) continue;
    if (o->output >= 0) left[o->output] = o->on;
    for (int n = 1; o->output < 0 && n <= outputs; ++n) left[n] = (o->value >> (n - 1) & 1u) != 0;
  }
}

/// Start of the list of outputs in the line; npos: the line has none.
std::size_t list_in(std::string_view line) {
  const std::size_t at = line.find(mark);
  if (at == std::string_view::npos || at == 0) return std::string_view::npos;
  const bool comment = line.substr(0, at).find_first_not_of(";#' \t") == std::string_view::npos;
  return comment ? at + mark.size() : std::string_view::npos;
}

std::string_view trimmed_of_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.remove_suffix(1);
  return text;
}

/// "output 1 off"
bool read_one(std::string_view text, ToolOutput& output) {
  constexpr std::string_view word = "output ";
  if (text.substr(0, word.size()) != word) return false;
  text.remove_prefix(word.size());
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), output.number);
  if (error != std::errc()) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  output.on = text == " on";
  return (output.on || text == " off") && output.number >= 0;
}

bool read_list(std::string_view text, ToolOff& tool) {
  for (;;) {
    const std::size_t comma = std::min(text.find(','), text.size());
    ToolOutput one{};
    if (!read_one(trimmed_of_blanks(text.substr(0, comma)), one)) return false;
    if (std::find(tool.begin(), tool.end(), one) == tool.end()) tool.push_back(one);
    if (comma == text.size()) return tool.size() <= most_outputs_of_a_controller;
    text.remove_prefix(comma + 1);
  }
}

bool any_pen(const sequence::StepList& steps) {
  return std::any_of(steps.begin(), steps.end(), [](const sequence::Step& step) {
    const sequence::StepList* inner = steps_in(step);
    return !step.skipped && (std::holds_alternative<sequence::Pen>(step.body) || (inner && any_pen(*inner)));
  });
}

}  // namespace

bool uses_tool(const sequence::Sequence& sequence) { return any_pen(sequence.steps); }

ToolOff tool_off_of(const sequence::Sequence& sequence, int outputs) {
  std::map<int, bool> up, down;
  leave_outputs(sequence.pen_up, outputs, up);
  leave_outputs(sequence.pen_down, outputs, down);
  ToolOff tool;
  for (const auto& [number, on] : up)
    if (const auto used = down.find(number); used != down.end() && used->second != on)
      tool.push_back({number, on});
  return tool;
}

std::string tool_off_line(const ToolOff& tool) {
  std::string line(mark);
  for (const ToolOutput& o : tool)
    line += fmt::format("{} output {} {}", &o == &tool.front() ? "" : ",", o.number, o.on ? "on" : "off");
  return line;
}

Result<ToolOff> tool_off_in(std::string_view text) {
  ToolOff tool;
  for (int n = 1; !text.empty(); ++n) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t list = list_in(line);
    if (list != std::string_view::npos && !read_list(line.substr(list), tool))
      return fail(FaultKind::text,
                  fmt::format("Line {} does not say how the tool is switched off: \"{}\".", n,
                              trimmed_of_blanks(line)),
                  "Nothing was sent.",
                  "Write it like \"Tool off: output 1 off, output 2 on\", or remove the line.");
  }
  return tool;
}

std::string tool_outputs_words(const ToolOff& tool) {
  std::string words = tool.size() == 1 ? "output " : "outputs ";
  for (std::size_t i = 0; i < tool.size(); ++i)
    words += fmt::format("{}{}", i == 0 ? "" : i + 1 == tool.size() ? " and " : ", ", tool[i].number);
  return words;
}

}  // namespace hw
