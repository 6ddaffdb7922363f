#include "core/devices/vxm/unsolicited_messages.h"

#include <fmt/core.h>

#include "core/base/index.h"
#include "core/devices/vxm/facts.h"

namespace hw::vxm {

void UnsolicitedMessages::received(const Message& m) {
  switch (m.kind) {
    case Message::Kind::prompt: received_prompt(); break;
    case Message::Kind::limit: received_limit(); break;
    case Message::Kind::waits:
      if (under_way_.program_runs()) console_.snapshot.program.run = RunState::waiting;
      console_.texts.add("W");
      break;
    case Message::Kind::passed: console_.texts.add("@"); break;
    case Message::Kind::held: received_held(m.text); break;
    case Message::Kind::error: received_error(m.letter); break;
    case Message::Kind::end:
    case Message::Kind::unknown:
    case Message::Kind::unfinished: return;
  }
  under_way_.news().notify();
  if (console_.changed) console_.changed();
}

void UnsolicitedMessages::received_prompt() {
  const bool of_kill =
      under_way_.killed_at() != Instant{} && console_.scheduler.now() - under_way_.killed_at() < Millis(100);
  if (under_way_.job().active()) {
    under_way_.job().leg_is_over();  // the end of the leg is shown once the positions have been read
    if (under_way_.job().end_is_asked() && !of_kill) console_.texts.add(std::string(1, prompt));
    return;
  }
  if (under_way_.program_runs()) under_way_.run_ended(EndedBy::target);
  if (!of_kill) console_.texts.add(std::string(1, prompt));
}

// The controller lists the command before which it holds (firmware 1.21 on). Of several equal commands, the
// first after the previous one is taken.
void UnsolicitedMessages::received_held(std::string_view command) {
  console_.texts.add(fmt::format(":{}", command));
  if (under_way_.job().active()) {
    hold_.was_switched(true);
    hold_.release_soon();  // a hold left on must not keep a move of the console
    return;
  }
  ProgramState& p = console_.snapshot.program;
  p.run = RunState::held;
  p.stepping = true;
  hold_.showed();
  p.command_reported = false;
  const int before = p.command;
  p.command = -1;
  if (!slots_.listing(p.slot)) return;
  const auto& listing = *slots_.listing(p.slot);
  int matches = 0, first = -1, next = -1;
  for (int i = 0; i < static_cast<int>(listing.size()); ++i) {
    if (listing[static_cast<std::size_t>(i)] != command) continue;
    ++matches;
    if (first < 0) first = i;
    if (next < 0 && i > before) next = i;
  }
  p.command = static_cast<std::int16_t>(next >= 0 ? next : first);
  p.command_reported = matches == 1;
}

void UnsolicitedMessages::received_limit() {
  const ParamState& report = console_.snapshot.params[ix(console_.catalog.find_param("O"))];
  const bool ends_program =
      report.known && (report.value & limit_ends_program) != 0;  // the end of the program explains it then
  if (under_way_.job().active())
    under_way_.job().report_limit();
  else if (!under_way_.program_runs())
    console_.report(Notice::Kind::warning, "A limit switch was hit. The controller has stopped that motor.");
  else if (!ends_program)
    console_.report(
        Notice::Kind::warning,
        "A limit switch was hit. The controller has stopped that motor, and its program continues.");
  if (under_way_.program_runs()) console_.snapshot.program.ended_by = EndedBy::limit;
  console_.texts.add("O");
}

void UnsolicitedMessages::received_error(char letter) {
  const ErrorWords words = explain_error(letter);
  console_.report(Notice::Kind::error, words.what + " " + words.advice);
  console_.texts.add(std::string("E") + letter);
  if (letter == error_stopped) {
    if (under_way_.job().active()) under_way_.job().ends_by(EndedBy::elsewhere);
    if (under_way_.program_runs()) console_.snapshot.program.ended_by = EndedBy::elsewhere;
    console_.snapshot.program.command = -1;
    return;
  }
  if (words.halts) {
    presence_.halted_by(letter);
    console_.snapshot.inputs_known = console_.snapshot.outputs_known = console_.snapshot.analog_known =
        0;  // not reported now
    under_way_.run_ended(EndedBy::error);
    console_.snapshot.program.run = RunState::error;
    for (int i = 0; i < console_.snapshot.axis_count; ++i)
      console_.snapshot.axes[i].activity = Activity::error;
    headline_.show();
  }
  if (letter == error_bus) identification_.lose_slave();
  // A restart is found by the next V: it answers J.
}

}  // namespace hw::vxm
