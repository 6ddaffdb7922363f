#include "core/session/tool_routine.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/base/number_text.h"
#include "core/device/tool_off.h"

namespace hw {
namespace {

using RoutineWords = std::vector<std::string>;

constexpr std::size_t drawing_axes = 2;

RoutineWords words_of_routine(std::string_view text) {
  RoutineWords words;
  for (std::string word; !text.empty(); text.remove_prefix(1)) {
    const char c = text.front();
    const bool ends = c == ' ' || c == '\t' || text.size() == 1;
    if (c != ' ' && c != '\t') word += c;
    if (ends && !word.empty()) words.push_back(std::exchange(word, {}));
  }
  return words;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

double turned(double to, double per_unit) { return per_unit < 0 && to != 0 ? -to : to; }

class RoutineReader {
 public:
  RoutineReader(const Catalog& catalog, const PerUnit& per_unit, std::vector<sequence::Axis>& axes)
      : catalog_(catalog), per_unit_(per_unit), axes_(axes) {}

  Result<sequence::StepList> read(std::string_view text) {
    while (!text.empty()) {
      const std::string_view part = text.substr(0, text.find(','));
      text.remove_prefix(std::min(text.size(), part.size() + 1));
      const RoutineWords words = words_of_routine(part);
      if (words.empty()) continue;
      auto step = read(words);
      if (!step) return fail(step.error());
    }
    return std::move(steps_);
  }

 private:
  Result<> read(const RoutineWords& words) {
    const bool ms = words.size() == 3 && words[2] == "ms";
    if (same_word(words[0], "wait") && (words.size() == 2 || ms)) return read_wait(words);
    if (words.size() == 3 && same_word(words[1], "to")) return read_move(words);
    if (words.size() > 1 && (same_word(words.back(), "on") || same_word(words.back(), "off")))
      return read_output(words);
    return not_understood(words);
  }
  Result<> read_wait(const RoutineWords& words) {
    const auto ms = finite_number(words[1]);
    if (!ms || *ms < 0) return not_understood(words);
    steps_.push_back({sequence::Delay{*ms}});
    return {};
  }
  /// "DO2 on", "User 1 off", "output 2 on", "2 on"
  Result<> read_output(const RoutineWords& words) {
    const std::string name = fmt::format("{}", fmt::join(words.begin(), words.end() - 1, " "));
    for (std::size_t i = 0; i < catalog_.outputs.size(); ++i) {
      const int number = catalog_.output_number(i);
      const std::string digits = std::to_string(number);
      if (!same_word(catalog_.outputs[i].name, name) && digits != name &&
          !same_word("output " + digits, name))
        continue;
      steps_.push_back({sequence::Output{number, same_word(words.back(), "on")}});
      return {};
    }
    return refuse(fmt::format("{} has no output \"{}\".", catalog_.short_name, name));
  }
  Result<> read_move(const RoutineWords& words) {
    const auto to = finite_number(words[2]);
    if (!to) return not_understood(words);
    const auto found = std::find_if(catalog_.axes.begin(), catalog_.axes.end(),
                                    [&](const AxisInfo& axis) { return same_word(axis.name, words[0]); });
    if (found == catalog_.axes.end())
      return refuse(fmt::format("{} has no axis \"{}\".", catalog_.short_name, words[0]));
    std::size_t place = 0;
    while (place < axes_.size() && axes_[place].name != found->name) ++place;
    if (place < drawing_axes)
      return refuse(fmt::format("{} draws, so it cannot move the tool up or down.", found->name));
    const double per_unit = per_unit_(found->name);
    if (place == axes_.size()) axes_.push_back({found->name, std::abs(per_unit)});
    sequence::Move move;
    move.to[place] = turned(*to, per_unit);
    steps_.push_back({move});
    steps_.push_back({sequence::WaitMotion{static_cast<int>(place)}});
    return {};
  }
  Result<> not_understood(const RoutineWords& words) const {
    return refuse(fmt::format("\"{}\" is not understood.", fmt::join(words, " ")));
  }
  [[nodiscard]] tl::unexpected<Fault> refuse(std::string what) const {
    std::string axis;
    for (const AxisInfo& info : catalog_.axes)
      if (axes_.size() < drawing_axes || (info.name != axes_[0].name && info.name != axes_[1].name))
        axis = info.name + " to -2, ";
    const std::string output = catalog_.outputs.empty() ? "" : catalog_.outputs.front().name + " on, ";
    return fail(FaultKind::text, std::move(what), {}, fmt::format("Write: {}{}wait 250 ms.", axis, output));
  }

  const Catalog& catalog_;
  const PerUnit& per_unit_;
  std::vector<sequence::Axis>& axes_;
  sequence::StepList steps_;
};

}  // namespace

void put_tool(const PlainTool& tool, std::vector<sequence::Axis>& axes, sequence::StepList& pen_down,
              sequence::StepList& pen_up) {
  if (!tool.axis.empty()) {
    const std::size_t place = axes.size();
    axes.push_back({tool.axis, std::abs(tool.per_unit)});
    for (auto [to, routine] : {std::pair{tool.down, &pen_down}, std::pair{tool.up, &pen_up}}) {
      sequence::Move move;
      move.to[place] = turned(to, tool.per_unit);
      routine->push_back({move});
      routine->push_back({sequence::WaitMotion{static_cast<int>(place)}});
    }
  }
  if (tool.output) {
    pen_down.push_back({sequence::Output{*tool.output, true}});
    pen_up.insert(pen_up.begin(), {sequence::Output{*tool.output, false}});
  }
  if (tool.down_delay_ms > 0) pen_down.push_back({sequence::Delay{tool.down_delay_ms}});
  if (tool.up_delay_ms > 0) pen_up.push_back({sequence::Delay{tool.up_delay_ms}});
}

Result<sequence::StepList> read_routine(std::string_view text, const Catalog& catalog,
                                        const PerUnit& per_unit, std::vector<sequence::Axis>& axes) {
  return RoutineReader(catalog, per_unit, axes).read(text);
}

Result<> switches_back(const sequence::StepList& down, const sequence::StepList& up, const Catalog& catalog) {
  sequence::Sequence routines;
  routines.pen_down = down, routines.pen_up = up;
  const ToolOff back = tool_off_of(routines, static_cast<int>(catalog.outputs.size()));
  struct Switched {
    bool first = false, last = false;
  };
  std::map<int, Switched> switched;
  for (const sequence::Step& step : down)
    if (const auto* o = std::get_if<sequence::Output>(&step.body))
      switched.try_emplace(o->output, Switched{o->on, o->on}).first->second.last = o->on;
  for (const auto& [number, state] : switched) {
    const bool is_back =
        std::any_of(back.begin(), back.end(), [n = number](auto& o) { return o.number == n; });
    const bool is_pulse = state.first != state.last;  // lowering itself ends it
    const int place = catalog.find_output(number);
    if (is_back || is_pulse || place < 0) continue;
    const std::string& name = catalog.outputs[ix(place)].name;
    return fail(FaultKind::text,
                fmt::format("{} is switched {} with the tool, and nothing switches it back.", name,
                            state.last ? "on" : "off"),
                {},
                fmt::format("Add this to the steps that switch the tool off: {} {}.", name,
                            state.last ? "off" : "on"));
  }
  return {};
}

std::string write_routine(const sequence::StepList& steps, const Catalog& catalog,
                          const std::vector<sequence::Axis>& axes) {
  std::string text;
  const auto add = [&text](const std::string& step) { text += (text.empty() ? "" : ", ") + step; };
  for (const sequence::Step& step : steps) {
    if (const auto* delay = std::get_if<sequence::Delay>(&step.body))
      add(fmt::format("wait {} ms", delay->ms));
    if (const auto* output = std::get_if<sequence::Output>(&step.body)) {
      const int place = catalog.find_output(output->output);
      add(fmt::format("{} {}", place >= 0 ? catalog.outputs[ix(place)].name : std::to_string(output->output),
                      output->on ? "on" : "off"));
    }
    if (const auto* move = std::get_if<sequence::Move>(&step.body))
      for (std::size_t a = 0; a < axes.size(); ++a)
        if (move->to[a]) add(fmt::format("{} to {}", axes[a].name, *move->to[a]));
  }
  return text;
}

}  // namespace hw
