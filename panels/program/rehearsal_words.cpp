#include "panels/program/rehearsal_words.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/index.h"
#include "gui/model/tab.h"
#include "gui/model/units_format.h"

namespace hw::panels {

using namespace gui;
namespace {

constexpr std::size_t most_stops = 12;  // listed

std::string position_difference(const Frame& f, const StartDifference& start) {
  const int i = std::max(0, start.which);
  const std::string axis = fmt::format("axis {}", f.catalog.axes[ix(i)].name);
  const DisplayUnit& unit = f.tab.settings.unit(AxisId{static_cast<std::uint8_t>(i)});
  const NumberText began = format_position(start.began, unit);
  switch (start.match) {
    case StartMatch::elsewhere:
      return fmt::format("Rehearsed from {}; {} stands at {}", began.view(), axis,
                         format_with_unit(start.stands, unit).view());
    case StartMatch::moving: return fmt::format("Rehearsed from {}; {} is moving", began.view(), axis);
    case StartMatch::other_count:
      return fmt::format("Rehearsed as after power-up; {} counts in another unit now", axis);
    case StartMatch::unknown:
      return fmt::format("Rehearsed from {}; the position of {} is not known", began.view(), axis);
    case StartMatch::other_encoder: return fmt::format("Rehearsed before the encoder of {} changed", axis);
    case StartMatch::other_switch:
      if (start.unread)
        return fmt::format("Rehearsed with known limit switches of {}; they are not known now", axis);
      return fmt::format("Rehearsed before a limit or home switch of {} changed", axis);
    case StartMatch::doubtful: return fmt::format("The position of {} may be wrong", axis);
    default:
      if (start.unread) return fmt::format("Rehearsed with a known loop of {}; it is not known now", axis);
      return fmt::format("Rehearsed before {} was switched, or its error came or went", axis);
  }
}

std::string readout_word(const ReadoutInfo& readout, std::int64_t value) {
  for (const ParamChoice& word : readout.words)
    if (word.value == value) return word.label;
  return std::to_string(value);
}

std::string difference(const Frame& f, const StartDifference& start) {
  const Catalog& c = f.catalog;
  const auto place = static_cast<std::size_t>(std::max(0, start.which));
  const auto differs = [&](std::string_view name, std::string_view then, std::string_view now) {
    if (start.unread) return fmt::format("Rehearsed with {} {}; its present value is unknown", name, then);
    return fmt::format("Rehearsed with {} {}; it is {} now", name, then, now);
  };
  switch (start.match) {
    case StartMatch::other_bench: return "Switches on the bench have been moved since";
    case StartMatch::other_setup:
      return differs(c.params[place].mnemonic, param_words(c.params[place], start.began.value),
                     param_words(c.params[place], start.stands.value));
    case StartMatch::other_output: {
      const auto state = [](Steps on) { return on.value != 0 ? "on" : "off"; };
      return differs(place < c.outputs.size() ? c.outputs[place].name : "an output", state(start.began),
                     state(start.stands));
    }
    case StartMatch::other_input: {
      const auto level = [](Steps high) { return high.value != 0 ? "high" : "low"; };
      return differs(place < c.inputs.size() ? c.inputs[place].name : "an input", level(start.began),
                     level(start.stands));
    }
    case StartMatch::other_analog: {
      const AnalogInfo& input = c.analog[place];
      const auto reads = [&](Steps value) { return fmt::format("{} {}", value.value, input.unit); };
      return differs(input.name, reads(start.began), reads(start.stands));
    }
    case StartMatch::other_readout: {
      const ReadoutInfo& readout = c.readouts[place];
      return differs(readout.label, readout_word(readout, start.began.value),
                     readout_word(readout, start.stands.value));
    }
    case StartMatch::other_variable:
      return differs(fmt::format("V{}", place), std::to_string(start.began.value),
                     std::to_string(start.stands.value));
    case StartMatch::other_queue: return "Rehearsed with empty queues; commands wait there now";
    case StartMatch::other_program:
      if (start.unread)
        return fmt::format("Rehearsed with {} {}; its present content is unknown", c.program.slot_word,
                           place);
      return fmt::format("Rehearsed before {} {} was changed", c.program.slot_word, place);
    default: return position_difference(f, start);
  }
}

}  // namespace

std::string exact_time(double s) {
  const auto tenths = static_cast<long long>(s * 10 + 0.5);
  if (tenths >= 36000)
    return fmt::format("{} h {:02} min {:02} s", tenths / 36000, tenths / 600 % 60, tenths / 10 % 60);
  if (tenths >= 600) return fmt::format("{} min {:02}.{} s", tenths / 600, tenths / 10 % 60, tenths % 10);
  return fmt::format("{}.{} s", tenths / 10, tenths % 10);
}

std::string stand_words(const Frame& f, const Rehearsals::Outcome& outcome) {
  std::string words;
  if (outcome.start.match != StartMatch::here)
    words = difference(f, outcome.start);
  else if (!outcome.scene.switches)
    words = "The positions of the limit switches are unknown";
  return words.empty() ? words : words + ": limits are not checked.";
}

std::vector<std::string> stop_words(const Rehearsal& r) {
  std::vector<std::string> all;
  for (const RehearsedStop& stop : r.stops) {
    if (r.error.find(stop.reason) != std::string::npos) continue;  // already shown above
    const std::string line = stop.line < 0 ? std::string() : fmt::format("Line {}, ", stop.line + 1);
    all.push_back(fmt::format("{}{}: {}", line, exact_time(stop.t), stop.reason));
    if (all.size() == most_stops) break;
  }
  return all;
}

std::string memory_words(const Rehearsal& r, const ProgramFacts& facts) {
  if (facts.capacity <= 0 || r.program_size.empty()) return {};
  const bool several = r.program_size.size() > 1;
  std::string all;
  for (const auto& [program, size] : r.program_size)
    all += fmt::format("{}{}{}", all.empty() ? "" : ", ", several ? program + ": " : "",
                       format_number(size, 0).view());
  return fmt::format("{} of {} {}{}", all, format_number(facts.capacity, 0).view(), facts.capacity_unit,
                     several ? " each" : "");
}

std::string assumption_words(const Rehearsal& r) {
  std::string words;
  for (const RehearsedAssumption& a : r.assumptions)
    words += fmt::format("{}{}: {}", words.empty() ? "Unknown, so assumed: " : "; ", a.name, a.value);
  return words.empty() ? words : words + ".";
}

}  // namespace hw::panels
