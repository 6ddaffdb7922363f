#include "gui/model/status_sentence.h"

#include <cmath>
#include <cstdlib>

#include <fmt/core.h>

#include "core/device/refusals.h"
#include "gui/model/axis_look.h"
#include "gui/model/units_format.h"

namespace hw::gui {
namespace {

using Said = std::optional<StatusSentence>;

StatusSentence say(Severity severity, std::string_view text) { return {severity, text}; }
AxisId axis(int index) { return AxisId{static_cast<std::uint8_t>(index)}; }

/// "motor 1", within a sentence.
std::string plain_name(const Catalog& catalog, int index) {
  const AxisInfo& info = catalog.axes[static_cast<std::size_t>(index)];
  return info.description.empty() ? "axis " + info.name : info.description;
}
/// "Motor 1", at its beginning.
std::string name_of(const Catalog& catalog, int index) {
  std::string name = plain_name(catalog, index);
  if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

std::string_view sign_word(bool plus) { return plus ? "+" : "\u2212"; }

Said say_link(const StatusFacts& f) {
  const LinkHealth& link = f.now.link;
  switch (link.state) {
    case LinkState::lost: {
      std::string text =
          fmt::format("No answer from {} since {}. Stop does not reach it: use its power switch.",
                      f.catalog.short_name, f.time_of_day(link.lost_at));
      if (!link.sentence.empty()) text += fmt::format(" {}", link.sentence.view());
      return say(Severity::fault, std::move(text));
    }
    case LinkState::closed: return say(Severity::plain, "The connection is closed.");
    case LinkState::connecting:
      if (link.attempts > 1)
        return say(Severity::warn, fmt::format("Asking {}, attempt {}.", f.catalog.name, link.attempts));
      return say(Severity::plain, fmt::format("Asking {} what it is and where it stands.", f.catalog.name));
    case LinkState::good:
    case LinkState::late: break;
  }
  return {};
}

/// Puts programs stopped in error before the sentence; it names the cause where that is an axis.
StatusSentence with_failed(const StatusFacts& f, StatusSentence said) {
  if (!f.failed.empty()) said.text = fmt::format("{} {}", f.failed, said.text.view());
  return said;
}

Said say_motion(const StatusFacts& f);
Said say_program(const StatusFacts& f);

/// Adds what goes on beside an error.
StatusSentence with_what_goes_on(const StatusFacts& f, StatusSentence said) {
  for (const auto part : {say_motion, say_program})
    if (const Said goes_on = part(f)) {
      said.text = fmt::format("{} {}", said.text.view(), goes_on->text.view());
      break;
    }
  return said;
}

Said say_error(const StatusFacts& f) {
  if (f.now.program.run == RunState::error && !f.now.notice.empty())
    return say(Severity::fault, f.now.notice);
  for (int i = 0; i < f.now.axis_count; ++i) {
    if (f.now.axes[i].activity != Activity::error && !f.now.axes[i].alarm) continue;
    if (f.now.axes[i].activity != Activity::error)
      return with_what_goes_on(
          f, with_failed(
                 f, say(Severity::fault, fmt::format("The alarm input of {} is active, so it takes no move. "
                                                     "Look at its motor driver.",
                                                     plain_name(f.catalog, i)))));
    const StatusSentence error =
        say(Severity::fault,
            f.now.notice.empty()
                ? fmt::format("{} is in error. Stop it, and look at the terminal.", name_of(f.catalog, i))
                : std::string(f.now.notice.view()));
    return with_what_goes_on(f, with_failed(f, error));
  }
  if (f.now.program.run == RunState::error) return say(Severity::fault, "The program ended with an error.");
  return {};
}

/// The most important notice of the controller's driver. Present motion comes before it.
Said say_notice(const StatusFacts& f) {
  if (f.now.notice.empty()) return {};
  return say(Severity::warn, f.now.notice);
}

Said say_late(const StatusFacts& f) {
  if (f.now.link.state != LinkState::late) return {};
  const std::uint32_t misses = f.now.link.misses_in_a_row;
  std::string text = misses == 0 ? fmt::format("{} is not understood.", f.catalog.short_name)
                                 : fmt::format("{} answers late: {} missed.", f.catalog.short_name,
                                               misses == 1 ? std::string("one question")
                                                           : fmt::format("{} questions", misses));
  if (!f.now.link.sentence.empty()) text += fmt::format(" {}", f.now.link.sentence.view());
  return say(Severity::warn, text);
}

bool moves(const AxisState& a) {
  if (only_goes_along(a)) return false;
  return a.activity == Activity::moving || a.activity == Activity::jogging ||
         a.activity == Activity::homing || a.activity == Activity::stopping;
}

/// " in line 6"; empty when not known.
std::string say_line(const RunPlace& run, std::string_view before) {
  return run.line >= 0 ? fmt::format("{}line {}", before, run.line + 1) : std::string();
}

/// " in line 6, pass 7 of 20. 46 s left." for a running program; "." when nothing of this is known.
std::string say_place(const RunPlace& run) {
  std::string words = say_line(run, " in ");
  if (run.line < 0 && run.stored_line >= 0)
    words = fmt::format(" at line {} of its stored code", run.stored_line);
  if (run.line >= 0 && run.passes > 1) words += fmt::format(", pass {} of {}", run.pass, run.passes);
  words += '.';
  if (run.left_s) {
    const double whole_s = std::ceil(*run.left_s);  // tenths would change with each frame
    words += whole_s < 60 ? fmt::format(" {:.0f} s left.", whole_s)
                          : fmt::format(" {} left.", format_duration(whole_s).view());
  }
  return words;
}

/// "Program 0 is"
std::string say_who(const StatusFacts& f) {
  if (!f.run.who.empty()) return f.run.who;
  return fmt::format("{} {} is", f.catalog.program.slot_word, f.now.program.slot);
}

/// "Motor 1 and motor 2 move", where several just move.
std::string say_several(const StatusFacts& f) {
  std::string names;
  int count = 0, left = 0;
  const auto moves_there = [](const AxisState& a) {
    return a.activity == Activity::moving && !only_goes_along(a);
  };
  for (int i = 0; i < f.now.axis_count; ++i) left += moves_there(f.now.axes[i]);
  for (int i = 0; i < f.now.axis_count; ++i) {
    if (!moves_there(f.now.axes[i])) continue;
    if (count++ > 0) names += --left == 1 ? " and " : ", ";
    names += count == 1 ? name_of(f.catalog, i) : plain_name(f.catalog, i);
  }
  return count > 1 ? names + " move" : std::string();
}

Said say_motion(const StatusFacts& f) {
  constexpr std::string_view way_out = "Esc stops everything.";
  const bool whole_program = f.now.program.owned && f.now.program.run == RunState::running;
  const std::string several = f.held ? std::string() : say_several(f);
  if (!several.empty() && whole_program)
    return say(Severity::motion,
               fmt::format("{} running{} {}. {}", say_who(f), say_place(f.run), several, way_out));
  if (!several.empty()) return say(Severity::motion, fmt::format("{}. {}", several, way_out));
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (!moves(a)) continue;
    const std::string name = name_of(f.catalog, i);
    if (whole_program)
      return say(Severity::motion,
                 fmt::format("{} running{} {} moves{}. {}", say_who(f), say_place(f.run), name,
                             a.has_target ? " to " + f.show_position(axis(i), a.target) : "", way_out));
    if (a.activity == Activity::stopping)
      return say(Severity::motion, fmt::format("{} comes to a stop.", name));
    if (a.activity == Activity::homing)
      return say(Severity::motion,
                 fmt::format("{} is looking for home, {}. {}", name, sign_word(a.direction > 0), way_out));
    if (f.held && f.held->axis == axis(i)) {
      const std::string at = a.speed.value > 0 ? " at " + f.show_speed(axis(i), a.speed) : std::string();
      return say(Severity::motion, fmt::format("You hold {}{}. {} moves{} until you let go. {}",
                                               f.catalog.axes[static_cast<std::size_t>(i)].name,
                                               sign_word(f.held->sign == Sign::plus), name, at, way_out));
    }
    if (a.loop == Loop::following && a.speed.value == 0 && a.direction == 0 && a.activity == Activity::moving)
      return say(Severity::motion,
                 fmt::format("{} settles, {} from its command. {}", name,
                             f.show_position(axis(i), Steps(std::abs(a.following_error().value))), way_out));
    if (a.has_target)
      return say(Severity::motion,
                 fmt::format("{} moves to {}. {}", name, f.show_position(axis(i), a.target), way_out));
    const std::string way = a.direction == 0 ? "" : fmt::format(" {}", sign_word(a.direction > 0));
    return say(Severity::motion, fmt::format("{} moves{}. {}", name, way, way_out));
  }
  return {};
}

Said say_program(const StatusFacts& f) {
  const ProgramState& p = f.now.program;
  if (!p.owned) return {};
  const std::string what = fmt::format("{} {}", f.catalog.program.slot_word, p.slot);
  if (p.run == RunState::running)
    return say(Severity::motion, say_who(f) + " running" + say_place(f.run) + " Esc stops everything.");
  if (p.run == RunState::waiting)
    return say(Severity::motion,
               what + " waits" + say_line(f.run, " in ") +
                   ". It continues by itself when its condition is met. Esc stops everything.");
  if (p.run == RunState::held)
    return say(Severity::warn, what + " is held before " +
                                   (f.run.line >= 0 ? say_line(f.run, "") : std::string("its next command")) +
                                   ". Step, go on, or stop it.");
  return {};
}

Said say_pieces(const StatusFacts& f) {
  const PiecesState& p = f.now.pieces;
  if (!p.running) return {};
  if (p.held)
    return say(Severity::warn,
               fmt::format("Held at piece {} of {}. Go on, or stop it.", p.done + 1, p.total));
  return say(Severity::motion,
             fmt::format("Piece {} of {} is under way. Esc stops everything.", p.done + 1, p.total));
}

/// One of several programs is in error, whatever the others do.
Said say_failed(const StatusFacts& f) {
  if (f.failed.empty()) return {};
  for (const auto part : {say_motion, say_program})
    if (const Said goes_on = part(f)) return with_failed(f, say(Severity::fault, goes_on->text));
  return say(Severity::fault, f.failed + " Run starts it again, Stop clears the error.");
}

Said say_position(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (!a.position_known)
      return say(Severity::warn,
                 fmt::format("The position of {} is not known. Home it, or say where it stands.",
                             plain_name(f.catalog, i)));
    if (a.trust.doubtful())
      return say(
          Severity::warn,
          fmt::format("The position of {} cannot be trusted: {} ({}). Home it, or say where it stands.",
                      spoken_name(f.catalog, i), words_of(a.trust.cause), f.time_of_day(a.trust.since)));
  }
  return {};
}

Said say_slip(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i)
    if (f.now.axes[i].slipped)
      return say(Severity::warn,
                 fmt::format("{} has slipped: its encoder was further off than is allowed. Find "
                             "what held it, then clear its flag.",
                             name_of(f.catalog, i)));
  return {};
}

/// "KPY and KIY": the gains that drive the axis to its command, if all are known to be 0; else empty.
std::string gains_at_zero(const StatusFacts& f, int index) {
  std::string names;
  for (std::size_t i = 0; i < f.catalog.params.size() && i < f.now.params.size(); ++i) {
    const ParamInfo& p = f.catalog.params[i];
    if (!p.drives || p.axis != index) continue;
    if (!f.now.params[i].known || f.now.params[i].value != 0) return {};
    names += (names.empty() ? "" : " and ") + p.mnemonic;
  }
  return names;
}

Said say_servo(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (a.loop != Loop::off_place) continue;
    const std::string zero = gains_at_zero(f, i);
    const std::string why = zero.empty() ? "Check whether something blocks it, and check its gains."
                                         : fmt::format("Nothing drives it while {} are 0.", zero);
    return say(Severity::warn,
               fmt::format("{} is not in place: it stands {} from its command, {}. {}", name_of(f.catalog, i),
                           f.show_position(axis(i), Steps(std::abs(a.following_error().value))),
                           f.show_position(axis(i), a.command), why));
  }
  for (int i = 0; i < f.now.axis_count; ++i)
    if (f.now.axes[i].loop == Loop::open)
      return say(Severity::warn,
                 fmt::format("The loop of {} is open, so its motor is free. Motor power closes it.",
                             plain_name(f.catalog, i)));
  return {};
}

Said say_limit(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (!a.limits_known || (!a.limit_minus && !a.limit_plus)) continue;
    const std::string name = name_of(f.catalog, i);
    if (a.limit_minus && a.limit_plus)
      return say(
          Severity::warn,
          fmt::format("Both limits of {} are active, so it cannot move. Check its switches and their cable.",
                      plain_name(f.catalog, i)));
    return say(Severity::warn, fmt::format("{} stands on its {} limit. It can only move {}.", name,
                                           sign_word(a.limit_plus), sign_word(a.limit_minus)));
  }
  return {};
}

Said say_unset(const StatusFacts& f) {
  if (f.unset_read) return {};
  for (int i = 0; i < f.now.axis_count; ++i)
    if (const int param = unset_before_moving(f.catalog, f.now, axis(i)); param >= 0)
      return say(Severity::warn, f.catalog.params[static_cast<std::size_t>(param)].before_moving);
  return {};
}

Said say_stale(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i)
    if (is_stale(f.now.axes[i].seen_at, f.clock, f.now.poll_period))
      return say(Severity::warn,
                 fmt::format("The position of {} is {} old.", plain_name(f.catalog, i),
                             format_duration(seconds(f.clock - f.now.axes[i].seen_at)).view()));
  return {};
}

/// No axis can move before its motor has power.
Said say_power(const StatusFacts& f) {
  if (f.now.axis_count == 0) return {};
  for (int i = 0; i < f.now.axis_count; ++i)
    if (!powerless(f.catalog, f.now, axis(i))) return {};
  if (f.now.axis_count > 1) return say(Severity::plain, "Motor power is off. Switch it on to move.");
  return say(Severity::plain,
             fmt::format("Motor power of {} is off. Switch it on to move it.", plain_name(f.catalog, 0)));
}

}  // namespace

int unset_before_moving(const Catalog& catalog, const Snapshot& now, AxisId wanted) {
  for (std::size_t i = 0; i < catalog.params.size() && i < now.params.size(); ++i) {
    const ParamInfo& info = catalog.params[i];
    if (info.before_moving.empty() || info.axis != wanted.index) continue;
    if (now.params[i].known && now.params[i].value == info.unset_value) return static_cast<int>(i);
  }
  return -1;
}

StatusSentence status_sentence(const StatusFacts& facts) {
  for (const auto part :
       {say_link, say_error, say_late, say_failed, say_motion, say_program, say_pieces, say_notice, say_unset,
        say_position, say_slip, say_servo, say_limit, say_stale, say_power})
    if (Said said = part(facts)) return std::move(*said);
  return say(Severity::plain, "Idle. Hold a jog button, type where to go, or run a program.");
}

}  // namespace hw::gui
