// The board's window, cell by cell, for the memory map.
#include <fmt/core.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/facts.h"

namespace hw::vme58 {
namespace {

constexpr const char* value_names[axis_values] = {
    "Encoder Position",      "Command Position",
    "Command Velocity",      "Acceleration",
    "Maximum Velocity",      "Base Velocity",
    "Proportional Gain",     "Differential Gain",
    "Integral Gain",         "Acceleration Feed Forward",
    "Velocity Feed Forward", "Offset",
};

MemoryCell cell(int offset, int bytes, std::string name, std::string group, std::string help) {
  MemoryCell c;
  c.offset = offset, c.bytes = bytes;
  c.name = std::move(name), c.group = std::move(group), c.help = std::move(help);
  return c;
}

std::vector<ParamBit> axis_bits(const Variant& variant) {
  std::vector<ParamBit> bits;
  for (int i = 0; i < variant.axes(); ++i)
    bits.push_back({i, fmt::format("Axis {}", axis_letters[static_cast<std::size_t>(i)])});
  return bits;
}
std::vector<ParamBit> line_bits(int first, int count) {
  std::vector<ParamBit> bits;
  for (int i = 0; i < count; ++i) bits.push_back({i, fmt::format("Line {}", first + i)});
  return bits;
}

void add_registers(std::vector<MemoryCell>& all, const Variant& variant) {
  const auto add = [&](int offset, const char* name, const char* help, std::vector<ParamBit> bits) {
    MemoryCell c = cell(offset, 1, name, "Registers", help);
    c.bits = std::move(bits);
    all.push_back(std::move(c));
  };
  add(reg::control, "Control", "Written by the host: interrupt enables, the request for axis data, mail.",
      {{0, "Data area update request"},
       {2, "Slip interrupt"},
       {3, "Limit interrupt"},
       {4, "Done interrupt"},
       {5, "Interrupt to the board"},
       {6, "I/O 0 and 1 interrupt"},
       {7, "Interrupts enabled"}});
  add(reg::status, "Status", "Reading clears command error and the interrupt bits.",
      {{0, "Command error"},
       {1, "Initialized"},
       {2, "Encoder slip"},
       {3, "Overtravel"},
       {4, "Done"},
       {5, "Interrupt to the board"},
       {6, "Direct interrupt"},
       {7, "Interrupt to the host"}});
  add(reg::io_low, "User I/O 0-7", "Levels of the general lines, 1 is high.", line_bits(0, 8));
  add(reg::slip, "Slip flags", "Reading clears them.", axis_bits(variant));
  add(reg::done, "Done flags", "Reading clears them.", axis_bits(variant));
  add(reg::io_high, "User I/O 8-13", "Levels of the general lines, 1 is high.", line_bits(8, 6));
  add(reg::limit, "Limit switches", "A hit stays until it is read while the switch is free.",
      axis_bits(variant));
  add(reg::home, "Home switches", "As they are now.", axis_bits(variant));
  add(reg::vector, "Interrupt vector", "What the board puts on the bus when it interrupts.", {});
}

}  // namespace

void add_memory_map(Catalog& catalog, const Variant& variant) {
  std::vector<MemoryCell>& all = catalog.memory;
  add_registers(all, variant);
  all.push_back(cell(at::input_put_index, 2, "Input Put Index", "Rings",
                     "Where the board puts its next reply character."));
  all.push_back(cell(at::input_get_index, 2, "Input Get Index", "Rings", "Where the console reads next."));
  all.push_back(cell(at::output_put_index, 2, "Output Put Index", "Rings",
                     "Where the console puts its next command character."));
  all.push_back(cell(at::output_get_index, 2, "Output Get Index", "Rings", "Where the board reads next."));
  all.push_back(
      cell(at::mailbox, 4, "Mailbox", "Rings", "A letter in each half; the board takes it and puts 0."));
  all.push_back(cell(at::reserved1, 2, "Mark", "Rings",
                     "Memory that only a reset clears: the console writes a mark there."));
  for (int axis = 0; axis < variant.axes(); ++axis)
    for (int i = 0; i < axis_values; ++i) {
      const std::string letter(axis_letters.substr(static_cast<std::size_t>(axis), 1));
      MemoryCell c =
          cell(offset_of(axis, static_cast<AxisValue>(i)), 4, fmt::format("{} {}", letter, value_names[i]),
               "Axis " + letter, "Copied by the board when the control register asks for it.");
      c.axis = axis;
      c.is_signed = true;
      all.push_back(std::move(c));
    }
  catalog.memory_rings = {
      {"Replies", at::input_buffer, ring_cells, at::input_put_index, at::input_get_index},
      {"Commands", at::output_buffer, ring_cells, at::output_put_index, at::output_get_index}};
}

}  // namespace hw::vme58
