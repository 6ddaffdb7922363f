#include "core/devices/vme58/effects.h"

#include "core/base/index.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {

void Effects::note(const TextCommand& command) {
  if (!command.fact || !command.flaw.empty()) return;
  const bool drives = loops_.warn_of_closing(command);
  values_.note(command);
  motions_.note(command);
  const int axis = command.context.axis;
  const bool one = command.context.mode == where::single;
  const Op op = command.fact->op;
  if (stops_motion(op)) speeds_.forget_put(one && op == Op::ST ? axis : -1);
  switch (op) {
    case Op::HN:
    case Op::HF:
      if (one) loops_.know(axis, op == Op::HN);
      break;
    case Op::EN: conversation_.echoes(true); break;
    case Op::ET:
      if (one) loops_.leaves_its_place(axis);  // the axis follows its encoder input
      break;
    case Op::AC:
    case Op::VL: speeds_.note(command); break;
    case Op::FL:
    case Op::FP: speeds_.forget_put(one ? axis : -1); break;
    case Op::LP: note_counters(command); break;
    case Op::AN:
    case Op::AF:
      if (one) lines_.know_auxiliary(axis, op == Op::AN);
      break;
    case Op::CD: contour_ports_.clear(); break;
    case Op::contour_AN:
    case Op::contour_AF: note_contour_ports(command); break;
    case Op::CX:
      for (const auto& port : contour_ports_) lines_.doubt_auxiliary(port.first);
      break;
    case Op::UU:
    case Op::UF: selection_.note_units(command); break;
    default: break;
  }
  if (drives) motions_.begins_to_settle(axis);
}

void Effects::note_queued(const TextCommand& command) {
  note(command);
  if (!command.fact || !command.flaw.empty()) return;
  const Op op = command.fact->op;
  const bool one = command.context.mode == where::single;
  if (one && (op == Op::AN || op == Op::AF)) lines_.queue_auxiliary(command.context.axis, op == Op::AN);
  if (op == Op::CX)
    for (const auto& [port, on] : contour_ports_) lines_.queue_auxiliary(port, on);
}

void Effects::note_contour_ports(const TextCommand& command) {
  for (const auto& port : command.numbers)
    if (port) contour_ports_[static_cast<int>(*port)] = command.fact->op == Op::contour_AN;
}

void Effects::note_counters(const TextCommand& command) {
  const bool one = command.context.mode == where::single;
  for (int i = 0; i < static_cast<int>(catalog_.axes.size()); ++i) {
    motions_.counts(i);
    const bool listed = ix(i) < command.numbers.size() && command.numbers[ix(i)];
    if (one ? i == command.context.axis : listed) motions_.trust(i, Trust::set);
  }
}

}  // namespace hw::vme58
