#include "core/devices/vme58/selection.h"

#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vme58 {

bool Selection::end_recording() { return std::exchange(context_.recording, false); }

void Selection::forget() {
  context_ = Context();
  user_unit_ = {};
}

std::string Selection::addressed(std::string_view selector, std::string_view text) const {
  const std::string back = context_.selector();
  const bool group = selector == "AA" || selector == "AM";
  std::string units;
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i) {
    if (!group && selector.back() != name(i).back()) continue;
    if (group && i > 0) units += ',';
    if (user_unit_[ix(i)] != 0) units += fmt::format("{}", user_unit_[ix(i)]);
  }
  const bool set_aside = units.find_first_not_of(',') != units.npos;
  std::string all = fmt::format("{} {}{}", selector, set_aside ? "UF " : "", text);
  if (set_aside) all += fmt::format(" UU{};", units);
  if (back != selector) all += " " + back;
  return all + "\n";
}

std::string Selection::addressed(int axis, std::string_view text) const {
  return addressed("A" + name(axis), text);
}

void Selection::note_units(const TextCommand& command) {
  const bool one = command.context.mode == where::single;
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i) {
    const std::size_t place = one ? 0 : ix(i);
    if (one && i != command.context.axis) continue;
    if (command.is(Op::UF))
      user_unit_[ix(i)] = 0;
    else if (place < command.numbers.size() && command.numbers[place])
      user_unit_[ix(i)] = *command.numbers[place];
  }
}

}  // namespace hw::vme58
