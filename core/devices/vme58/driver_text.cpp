// Raw text of users and scripts: sent command by command, so that the one that the board rejects can be
// named; and followed, so that the console knows which axis it has selected and what it has set.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/devices/vme58/driver.h"
#include "core/devices/vme58/text_meaning.h"

namespace hw::vme58 {
namespace {

constexpr std::size_t longest_text = 240;  // what the ring takes at once, with room for separators

/// With such a command a motion begins that the queue tells of.
bool moves_in_queue(Op op) {
  switch (op) {
    case Op::GO:
    case Op::GD:
    case Op::HM:
    case Op::HR:
    case Op::KM:
    case Op::KR:
    case Op::MV:
    case Op::SP:
    case Op::CX: return true;
    default: return false;
  }
}

bool is_queued(const TextCommand& command) { return command.fact && command.fact->when == When::queued; }

}  // namespace

TextMeaning Vme58Driver::meaning_of(const intent::SendText& text) const {
  return vme58::meaning_of(text.text, selection_.context(), axis_count());
}

Task<Result<>> Vme58Driver::send_text(std::string text) {
  auto sent = co_await send_commands(std::move(text), Millis(200));
  if (!sent) co_return fail(sent.error());
  if (!sent->empty()) texts_.add(std::move(*sent));
  co_return Result<>();
}

Task<Result<std::string>> Vme58Driver::query(std::string text, Duration patience) {
  if (!wire_.is_open()) co_return no_connection();
  co_return co_await send_commands(std::move(text), patience);
}

/// The replies of its queries, one on a line.
Task<Result<std::string>> Vme58Driver::send_commands(std::string text, Duration patience) {
  forget_rejection();
  Context context = selection_.context();
  const auto commands = read_commands(text, context);
  if (auto may = may_say_while_feeding(commands); !may) co_return fail(may.error());
  auto own = co_await give_speeds_back(Priority::intent);
  if (own && std::any_of(commands.begin(), commands.end(), is_queued))
    own = co_await give_speeds_behind_motions(Priority::intent);
  if (!own) co_return fail(own.error());
  auto selected = co_await conversation_.select_again(Priority::intent);
  if (!selected) co_return fail(selected.error());
  std::string answers;
  for (const TextCommand& command : commands) {
    std::string word(command.text);
    if (word.size() > longest_text)
      co_return fail(FaultKind::refused, "One command of this text is longer than the board's ring.",
                     "It was not sent.");
    word += ";\n";
    if (is_question(command) && command.flaw.empty()) {
      const ReplyForm form = reply_form(command, axis_count());
      auto reply = co_await conversation_.ask(std::move(word), Priority::intent, form, patience);
      if (!reply) co_return fail(reply.error());
      answers += (answers.empty() ? "" : "\n") + *reply;
    } else if (command.is(Op::RS) && command.flaw.empty()) {
      auto reset = co_await reset_by_text(std::move(word));
      if (!reset) co_return fail(reset.error());
    } else {
      auto put = co_await put_command(command, std::move(word));
      if (!put) co_return fail(put.error());
    }
    note_sent(command);
  }
  flags_wanted_ = true;
  co_return answers;
}

/// One that is no question.
Task<Result<>> Vme58Driver::put_command(const TextCommand& command, std::string word) {
  auto settled = co_await commands_.settle_late(Priority::intent);
  if (!settled) co_return settled;
  // Until a round of status has seen all queues empty and no axis turning.
  if (!command.fact || command.fact->when == When::queued) draft_.working = queues_due_ = true;
  note_stop_of_program(command);
  note_group(command);  // before a stop can come in between
  const int put_before = conversation_.end();
  auto written = co_await conversation_.write(std::move(word), Priority::intent, Conversation::WhenStuck::leave);
  if (!written && conversation_.end() == put_before) co_return written;
  if (!written && written.error().kind == FaultKind::stopped) co_return cut_short(command, written.error());
  if (!written) {
    if (selects(command)) note_sent(command);  // in the ring it acts later: what is sent behind it must know
    co_return written;
  }
  auto accepted = co_await accepts(command);
  if (!accepted && accepted.error().kind == FaultKind::stopped)
    co_return cut_short(command, accepted.error());
  if ((!accepted && selects(command))) selection_.lose();  // the board may have taken it
  co_return accepted;
}

/// By a stop that may take it back, or find it carried out.
Result<> Vme58Driver::cut_short(const TextCommand& command, Fault why) {
  note_effects(command);
  if (selects(command)) selection_.lose();
  return fail(when_put(std::move(why)));
}

/// It has been taken from the ring, and was no command error.
Task<Result<>> Vme58Driver::accepts(const TextCommand& command) {
  const auto bad = co_await readings_.was_rejected(Priority::intent);
  if (!bad) co_return fail(bad.error());
  if (!*bad) co_return Result<>();
  if (selection_.recording() && (command.is(Op::CE) || command.is(Op::CK))) {
    selection_.set_recording(false);  // there is no other end
    selection_.lose(), draft_.working = queues_due_ = true;
  }
  if (!command.flaw.empty())
    co_return fail(FaultKind::controller,
                   fmt::format("The board rejected \"{}\": {}", command.text, command.flaw),
                   "What stood before it was carried out, nothing behind it was sent.");
  co_return commands_.rejected(command.text);
}

/// Nothing of it is fed behind this.
void Vme58Driver::note_stop_of_program(const TextCommand& command) {
  if (draft_.program.run != RunState::running || !command.fact || !stops_motion(command.fact->op)) return;
  end_program(command.is(Op::KL) ? EndedBy::abort : EndedBy::stop);
}

/// Between CD and CE everything becomes part of the contour: of a program's what the user says, and of the
/// user's what the program says.
Result<> Vme58Driver::may_say_while_feeding(const std::vector<TextCommand>& commands) const {
  const auto stops = [](const TextCommand& command) {
    return command.fact && stops_motion(command.fact->op);
  };
  if (!draft_.feed.running || std::all_of(commands.begin(), commands.end(), stops)) return {};
  if (selection_.recording())
    return fail(FaultKind::refused,
                "The program that runs is recording a contour: this text would become part of it.",
                "Nothing was sent.", "Send it again when the contour has ended, or stop the program first.");
  const auto records = [](const TextCommand& command) { return command.is(Op::CD); };
  if (std::any_of(commands.begin(), commands.end(), records))
    return fail(FaultKind::refused,
                "A program is being sent to the board: its commands would become part of this contour.",
                "Nothing was sent.", "Wait until the program ends, or stop it.");
  return {};
}

void Vme58Driver::note_sent(const TextCommand& command) {
  if (!command.fact || !command.flaw.empty()) return;
  fed_apart_ = fed_apart_ || (draft_.feed.running && selects(command));
  const bool recorded = selection_.recording();
  selection_.hear(command);
  if (recorded && !selection_.recording()) draft_.working = queues_due_ = true;  // meanwhile nobody could ask
  note_effects(command);
}

/// All but the axis that it selects.
void Vme58Driver::note_effects(const TextCommand& command) {
  if (!command.fact || !command.flaw.empty()) return;
  const bool drives = warn_of_closing(command);
  note_param(command);
  note_motion(command);
  const int axis = command.context.axis;
  const bool one = command.context.mode == where::single;
  switch (command.fact->op) {
    case Op::HN:
    case Op::HF:
      if (one) know_loop(axis, command.fact->op == Op::HN);
      break;
    case Op::EN: conversation_.echoes(true); break;
    case Op::ET:
      if (one) minds_[ix(axis)].servo.goes_to_place = false;  // wherever its encoder input leads
      break;
    case Op::VL: note_velocity(command); break;
    case Op::FL:
    case Op::FP: forget_put_velocities(one ? axis : -1); break;
    case Op::LP:
      for (int i = 0; i < axis_count(); ++i) {
        minds_[ix(i)].counted = true;
        const bool listed = ix(i) < command.numbers.size() && command.numbers[ix(i)];
        if (one ? i == axis : listed) trusted(i, Trust::set);
      }
      break;
    case Op::AN:
    case Op::AF:
      if (const int place = catalog_.find_output(first_auxiliary + axis); one && place >= 0) {
        const std::uint32_t mask = 1u << place;
        draft_.outputs = command.fact->op == Op::AN ? draft_.outputs | mask : draft_.outputs & ~mask;
        draft_.outputs_known |= mask;
      }
      break;
    case Op::UU:
    case Op::UF: selection_.note_units(command); break;
    default: break;
  }
  if (drives) begins_to_settle(axis);
}

/// What was told of an axis' end was of another motion. And a jog leaves its queue at once, and may be so
/// slow that it seems to rest.
void Vme58Driver::note_motion(const TextCommand& command) {
  const Op op = command.fact->op;
  const bool jogs = op == Op::JG || op == Op::JF;
  if (!jogs && !stops_motion(op) && !moves_in_queue(op)) return;
  if (!stops_motion(op)) draft_.program.ended_by = EndedBy::nothing;
  const bool one = command.context.mode == where::single && (jogs || op == Op::ST || moves_in_queue(op));
  for (int i = 0; i < axis_count(); ++i) {
    if (one && i != command.context.axis) continue;
    if (stops_motion(op)) forget_put_velocities(i);
    const std::size_t place = one ? 0 : ix(i);
    const bool meant = place < command.numbers.size() && command.numbers[place].has_value();
    if (jogs && !meant) continue;
    if (AxisMind& mind = minds_[ix(i)];
        !mind.ours && !stops_motion(op) && !std::exchange(mind.by_text, true)) {
      mind.limit_hit = mind.turned = false;
      if (!moving(i)) mind.from_limit = (limits_ >> i & 1) != 0;
      draft_.axes[i].ended_by = EndedBy::nothing;
    }
    ServoMind& servo = minds_[ix(i)].servo;
    servo.goes_to_place = !jogs && !stops_motion(op);
    servo.settling = servo.settling && servo.goes_to_place;
    AtHome& at_home = minds_[ix(i)].at_home;
    if (op == Op::HM || op == Op::HR)
      at_home = one ? AtHome::sets_counter : AtHome::nothing;
    else if (op == Op::KM || op == Op::KR)
      at_home = AtHome::stops_dead;
    else if (jogs || stops_motion(op))
      at_home = AtHome::nothing;
    const double speed = jogs ? std::abs(*command.numbers[place]) : 0;
    begins_to_creep(i, speed > 0 ? jog_gap(i, speed) : Duration::zero());
  }
}

/// Lists of AA and AM name the axes that they move, and a GO may come long behind its list.
void Vme58Driver::note_group(const TextCommand& command) {
  if (!command.fact || command.fact->when != When::queued || command.context.mode == where::single) return;
  const bool contour = command.is(Op::CX), begins = command.is(Op::GO) || command.is(Op::GD);
  const bool all = command.is(Op::KM) || command.is(Op::KR) || (contour && command.context.contour_axes == 0);
  for (int i = 0; i < axis_count(); ++i) {
    AxisMind& mind = minds_[ix(i)];
    const bool named = ix(i) < command.numbers.size() && command.numbers[ix(i)].has_value();
    const bool listed = command.fact->shape == Shape::list && named;
    const bool drawn = contour && (command.context.contour_axes >> i & 1) != 0;
    mind.listed = mind.listed || listed;
    if (all || drawn || listed || (begins && mind.listed)) mind.in_group = true;
  }
}

}  // namespace hw::vme58
