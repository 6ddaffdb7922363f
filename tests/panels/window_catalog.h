#pragma once
// A board in a memory window with two servo axes and a step axis: no device, but all that the panels for
// memory, tuning and contours ask of a catalog.
#include <fmt/format.h>

#include "core/device/language.h"
#include "core/device/servo_tuning.h"
#include "core/drawing/contour_path.h"
#include "core/sequence/speed_stairs.h"
#include "tests/gui/model/toy_language.h"

namespace hw::test {

inline MemoryCell window_cell(int offset, int bytes, const char* name, const char* group, int axis = -1) {
  MemoryCell c;
  c.offset = offset, c.bytes = bytes, c.name = name, c.group = group, c.axis = axis;
  c.is_signed = axis >= 0;
  return c;
}

inline ParamInfo window_gain(const char* mnemonic, const char* label, int axis) {
  ParamInfo p;
  p.mnemonic = mnemonic, p.label = label, p.axis = axis, p.group = std::string(servo_loop_group);
  p.maximum = 100'000, p.decimals = 2, p.stored = false;
  return p;
}

inline Catalog window_catalog() {
  Catalog c;
  c.model = "board", c.name = "Board", c.short_name = "BOARD", c.step_word = "counts";
  for (const char* name : {"X", "Y", "Z"}) c.axes.push_back({name, "axis"});
  MemoryCell status = window_cell(0xFE3, 1, "Status", "Registers");
  status.bits = {{0, "Command error"}, {1, "Initialized"}, {4, "Done"}};
  MemoryCell limit = window_cell(0xFED, 1, "Limit", "Registers");
  limit.bits = {{0, "Axis X"}, {1, "Axis Y"}};
  c.memory = {status, limit, window_cell(0x000, 2, "Put index", "Rings"),
              window_cell(0x400, 4, "X Encoder", "Axis X", 0),
              window_cell(0x480, 4, "Y Encoder", "Axis Y", 1)};
  c.memory_rings = {{"Commands", 0x804, 256, 0x800, 0x002}};
  c.readout_groups = {"Flags", "Memory map"};
  c.memory_readout_group = 1;
  c.params = {window_gain("KPX", "Proportional gain of X", 0), window_gain("KDX", "Derivative gain of X", 0),
              window_gain("KPY", "Proportional gain of Y", 1)};
  c.outputs = {{"Out 8", "general line"}, {"Aux X", "auxiliary"}, {"Aux Y", "auxiliary"}};
  c.outputs[1].on_the_way = c.outputs[2].on_the_way = true;
  c.program.slots = 1, c.program.slot_word = "Program";
  c.can.memory_map = c.can.servo_tuning = c.can.contours = true;
  c.jog_speed_max = Pps{1'000'000};
  c.position_min = Steps{-33'500'000}, c.position_max = Steps{33'500'000};
  return c;
}

/// Writes plans as words that a test can read.
class WindowLanguage final : public Language {
 public:
  [[nodiscard]] ProgramReport analyse(std::string_view, int) const override { return {}; }
  [[nodiscard]] Result<Rehearsal> rehearse(std::string_view, const RehearseOptions&) const override {
    return Rehearsal();
  }
  [[nodiscard]] Result<SequenceText> write(const sequence::Sequence& s,
                                           const Catalog& catalog) const override {
    const sequence::Step::Body& body = s.steps.front().body;
    if (const auto* stairs = std::get_if<sequence::SpeedStairs>(&body)) return write(*stairs, s.axes[0].name);
    const auto& c = std::get<sequence::Contour>(body);
    if (drawing::contour_path(c, {1, 1}).runs.empty())
      return fail(FaultKind::text, "Step 1 (contour): the contour has no line and no arc.");
    SequenceText made;
    made.text = fmt::format("contour {} {} at {:.0f}\n", s.axes[0].name, s.axes[1].name, c.own->high);
    for (std::size_t i = 0; i < c.steps.size(); ++i) {
      if (const auto* output = std::get_if<sequence::Output>(&c.steps[i].body))
        made.text +=
            fmt::format("{} {}\n", catalog.outputs[static_cast<std::size_t>(output->output - 1)].name,
                        output->on ? "on" : "off");
      if (const auto* line = std::get_if<sequence::Move>(&c.steps[i].body))
        made.text += fmt::format("line {} {}\n", *line->to[0], *line->to[1]);
      const auto* arc = std::get_if<sequence::Arc>(&c.steps[i].body);
      if (arc && arc->x == 1000 && arc->y == 0)
        return fail(
            FaultKind::text,
            fmt::format("Step 1.{} (arc): the centre of the arc is the point where it begins.", i + 1));
      if (arc) made.text += fmt::format("arc {} {} {}\n", arc->x, arc->y, arc->degrees);
    }
    return made;
  }
  [[nodiscard]] Result<SequenceRead> read(std::string_view, const sequence::Sequence&,
                                          const Catalog&) const override {
    return fail(FaultKind::text, "Line 1: no block can represent this.");
  }

 private:
  static Result<SequenceText> write(const sequence::SpeedStairs& stairs, const std::string& axis) {
    if (const std::string why = why_no_way(stairs, {}); !why.empty()) return fail(FaultKind::text, why);
    SequenceText made;
    made.text = "stairs of " + axis;
    for (const auto& [until, speed] : stairs.stairs) made.text += fmt::format(" {} at {:.0f}", until, speed);
    made.text += fmt::format(" stop {}\n", stairs.stop_at);
    return made;
  }
};

}  // namespace hw::test
