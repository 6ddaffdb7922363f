#include "gui/model/status_sentence.h"

#include <cmath>
#include <cstdlib>

#include <fmt/core.h>

#include "core/device/refusals.h"
#include "gui/model/axis_look.h"
#include "gui/model/units_format.h"

namespace hw::gui {
namespace {

using Sentence = std::optional<StatusSentence>;

StatusSentence compose(Severity severity, std::string_view text) { return {severity, text}; }
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

Sentence describe_link(const StatusFacts& f) {
  const LinkHealth& link = f.now.link;
  switch (link.state) {
    case LinkState::lost: {
      std::string text =
          fmt::format("No answer from {} since {}. Stop does not reach it: use its power switch.",
                      f.catalog.short_name, f.time_of_day(link.lost_at));
      if (!link.sentence.empty()) text += fmt::format(" {}", link.sentence.view());
      return compose(Severity::fault, std::move(text));
    }
    case LinkState::closed: return compose(Severity::plain, "The connection is closed.");
    case LinkState::connecting:
      if (link.attempts > 1)
        return compose(Severity::warn, fmt::format("Asking {}, attempt {}.", f.catalog.name, link.attempts));
      return compose(Severity::plain,
                     fmt::format("Asking {} for its model and its position.", f.catalog.name));
    case LinkState::good:
    case LinkState::late: break;
  }
  return {};
}

/// Puts programs stopped in error before the sentence; it names the cause where that is an axis.
StatusSentence with_failed(const StatusFacts& f, StatusSentence sentence) {
  if (!f.failed.empty()) sentence.text = fmt::format("{} {}", f.failed, sentence.text.view());
  return sentence;
}

Sentence describe_motion(const StatusFacts& f);
Sentence describe_program(const StatusFacts& f);
Sentence describe_pieces(const StatusFacts& f);

/// Adds the motion beside a fault.
StatusSentence with_motion_words(const StatusFacts& f, StatusSentence sentence) {
  for (const auto part : {describe_motion, describe_program, describe_pieces})
    if (const Sentence goes_on = part(f)) {
      add_running_words(sentence, goes_on->text);
      break;
    }
  return sentence;
}

Sentence describe_error(const StatusFacts& f) {
  if (f.now.program.run == RunState::error && !f.now.notice.empty())
    return with_motion_words(f, compose(Severity::fault, f.now.notice));
  for (int i = 0; i < f.now.axis_count; ++i) {
    if (f.now.axes[i].activity != Activity::error && !f.now.axes[i].alarm) continue;
    if (f.now.axes[i].activity != Activity::error)
      return with_motion_words(
          f, with_failed(f, compose(Severity::fault,
                                    fmt::format("The alarm input of {} is active, so it takes no move. "
                                                "Look at its motor driver.",
                                                plain_name(f.catalog, i)))));
    const StatusSentence error =
        compose(Severity::fault,
                f.now.notice.empty()
                    ? fmt::format("{} is in error. Stop it, and look at the terminal.", name_of(f.catalog, i))
                    : std::string(f.now.notice.view()));
    return with_motion_words(f, with_failed(f, error));
  }
  if (f.now.program.run == RunState::error)
    return with_motion_words(f, compose(Severity::fault, "The program ended with an error."));
  return {};
}

/// The most important notice of the controller's driver.
Sentence describe_notice(const StatusFacts& f) {
  if (f.now.notice.empty()) return {};
  return compose(Severity::warn, f.now.notice);
}

/// Programs in error stand behind it: their state may be old.
Sentence describe_late(const StatusFacts& f) {
  if (f.now.link.state != LinkState::late) return {};
  const std::uint32_t misses = f.now.link.misses_in_a_row;
  std::string text =
      misses == 0 ? fmt::format("{} is not understood.", f.catalog.short_name)
                  : fmt::format("{} answers late: {} missed.", f.catalog.short_name,
                                misses == 1 ? std::string("one query") : fmt::format("{} queries", misses));
  if (!f.now.link.sentence.empty()) text += fmt::format(" {}", f.now.link.sentence.view());
  if (f.failed.empty()) return compose(Severity::warn, text);
  return compose(Severity::fault, fmt::format("{} {}", text, f.failed));
}

bool moves(const AxisState& a) { return a.moves() && !only_goes_along(a); }

/// " in line 6"; empty when not known.
std::string describe_line(const RunPlace& run, std::string_view before) {
  return run.line >= 0 ? fmt::format("{}line {}", before, run.line + 1) : std::string();
}

/// " in line 6, pass 7 of 20. 46 s left." for a running program; "." when nothing of this is known.
std::string describe_place(const RunPlace& run) {
  std::string words = describe_line(run, " in ");
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
std::string describe_subject(const StatusFacts& f) {
  if (!f.run.subject.empty()) return f.run.subject;
  return fmt::format("{} {} is", f.catalog.program.slot_word, f.now.program.slot);
}

/// "Motor 1 and motor 2 move", where several just move.
std::string describe_several(const StatusFacts& f) {
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

Sentence describe_motion(const StatusFacts& f) {
  constexpr std::string_view way_out = "Esc stops everything.";
  const bool whole_program = f.now.program.owned && f.now.program.run == RunState::running;
  const std::string several = f.held ? std::string() : describe_several(f);
  if (!several.empty() && whole_program)
    return compose(Severity::motion, fmt::format("{} running{} {}. {}", describe_subject(f),
                                                 describe_place(f.run), several, way_out));
  if (!several.empty()) return compose(Severity::motion, fmt::format("{}. {}", several, way_out));
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (!moves(a)) continue;
    const std::string name = name_of(f.catalog, i);
    if (whole_program)
      return compose(
          Severity::motion,
          fmt::format("{} running{} {} moves{}. {}", describe_subject(f), describe_place(f.run), name,
                      a.has_target ? " to " + f.show_position(axis(i), a.target) : "", way_out));
    if (a.activity == Activity::stopping)
      return compose(Severity::motion, fmt::format("{} is stopping.", name));
    if (a.activity == Activity::homing)
      return compose(Severity::motion, fmt::format("{} is looking for home, {}. {}", name,
                                                   sign_word(a.direction > 0), way_out));
    if (f.held && f.held->axis == axis(i)) {
      const std::string at = a.speed.value > 0 ? " at " + f.show_speed(axis(i), a.speed) : std::string();
      return compose(Severity::motion, fmt::format("You hold {}{}. {} moves{} until you release it. {}",
                                                   f.catalog.axes[static_cast<std::size_t>(i)].name,
                                                   sign_word(f.held->sign == Sign::plus), name, at, way_out));
    }
    if (a.loop == Loop::following && a.speed.value == 0 && a.direction == 0 && a.activity == Activity::moving)
      return compose(
          Severity::motion,
          fmt::format("{} settles, {} from its command. {}", name,
                      f.show_position(axis(i), Steps(std::abs(a.following_error().value))), way_out));
    if (a.has_target)
      return compose(Severity::motion,
                     fmt::format("{} moves to {}. {}", name, f.show_position(axis(i), a.target), way_out));
    const std::string way = a.direction == 0 ? "" : fmt::format(" {}", sign_word(a.direction > 0));
    return compose(Severity::motion, fmt::format("{} moves{}. {}", name, way, way_out));
  }
  return {};
}

Sentence describe_program(const StatusFacts& f) {
  const ProgramState& p = f.now.program;
  if (!p.owned) return {};
  const std::string what = fmt::format("{} {}", f.catalog.program.slot_word, p.slot);
  if (p.run == RunState::running)
    return compose(Severity::motion,
                   describe_subject(f) + " running" + describe_place(f.run) + " Esc stops everything.");
  if (p.run == RunState::waiting)
    return compose(Severity::motion,
                   what + " waits" + describe_line(f.run, " in ") +
                       ". It continues by itself when its condition is met. Esc stops everything.");
  if (p.run == RunState::held)
    return compose(Severity::warn,
                   what + " is held before " +
                       (f.run.line >= 0 ? describe_line(f.run, "") : std::string("its next command")) +
                       ". Step, resume or stop it.");
  return {};
}

Sentence describe_pieces(const StatusFacts& f) {
  const PiecesState& p = f.now.pieces;
  if (!p.running) return {};
  if (p.held)
    return compose(Severity::warn,
                   fmt::format("Held at piece {} of {}. Resume or stop it.", p.done + 1, p.total));
  return compose(Severity::motion,
                 fmt::format("Piece {} of {} is under way. Esc stops everything.", p.done + 1, p.total));
}

/// One of several programs is in error, even if others run.
Sentence describe_failed(const StatusFacts& f) {
  if (f.failed.empty()) return {};
  const StatusSentence in_error = with_motion_words(f, compose(Severity::fault, f.failed));
  if (in_error.goes_on > 0) return in_error;
  return compose(Severity::fault, f.failed + " Run starts it again, Stop clears the error.");
}

Sentence describe_position(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (a.activity == Activity::homing) continue;  // the sentence asks for homing
    if (!a.position_known)
      return compose(Severity::warn,
                     fmt::format("The position of {} is not known. Home it, or set its position.",
                                 plain_name(f.catalog, i)));
    if (a.trust.doubtful())
      return compose(
          Severity::warn,
          fmt::format("The position of {} cannot be trusted: {} ({}). Home it, or set its position.",
                      spoken_name(f.catalog, i), words_of(a.trust.cause), f.time_of_day(a.trust.since)));
  }
  return {};
}

Sentence describe_slip(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i)
    if (f.now.axes[i].slipped)
      return compose(Severity::warn, fmt::format("{} has slipped: its position error was larger than "
                                                 "allowed. Find out what blocked it, then clear its flag.",
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

Sentence describe_servo(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (a.loop != Loop::off_place) continue;
    const std::string zero = gains_at_zero(f, i);
    const std::string why = zero.empty() ? "Check whether something blocks it, and check its gains."
                                         : fmt::format("Nothing drives it while {} are 0.", zero);
    return compose(
        Severity::warn,
        fmt::format("{} is not in place: it stands {} from its command, {}. {}", name_of(f.catalog, i),
                    f.show_position(axis(i), Steps(std::abs(a.following_error().value))),
                    f.show_position(axis(i), a.command), why));
  }
  for (int i = 0; i < f.now.axis_count; ++i)
    if (f.now.axes[i].loop == Loop::open)
      return compose(Severity::warn,
                     fmt::format("The loop of {} is open, so its motor is free. Motor power closes it.",
                                 plain_name(f.catalog, i)));
  return {};
}

Sentence describe_limit(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i) {
    const AxisState& a = f.now.axes[i];
    if (!a.limits_known || (!a.limit_minus && !a.limit_plus) || moves(a)) continue;
    const std::string name = name_of(f.catalog, i);
    if (a.limit_minus && a.limit_plus)
      return compose(
          Severity::warn,
          fmt::format("Both limits of {} are active, so it cannot move. Check its switches and their cable.",
                      plain_name(f.catalog, i)));
    return compose(Severity::warn, fmt::format("{} is on its {} limit. It can only move {}.", name,
                                               sign_word(a.limit_plus), sign_word(a.limit_minus)));
  }
  return {};
}

Sentence describe_unset(const StatusFacts& f) {
  if (f.unset_read) return {};
  for (int i = 0; i < f.now.axis_count; ++i)
    if (const int param = unset_before_moving(f.catalog, f.now, axis(i)); param >= 0)
      return compose(Severity::warn, f.catalog.params[static_cast<std::size_t>(param)].before_moving);
  return {};
}

Sentence describe_stale(const StatusFacts& f) {
  for (int i = 0; i < f.now.axis_count; ++i)
    if (is_stale(f.now.axes[i].seen_at, f.clock, f.now.poll_period))
      return compose(Severity::warn,
                     fmt::format("The position of {} is {} old.", plain_name(f.catalog, i),
                                 format_duration(seconds(f.clock - f.now.axes[i].seen_at)).view()));
  return {};
}

/// No axis can move before its motor has power.
Sentence describe_power(const StatusFacts& f) {
  if (f.now.axis_count == 0) return {};
  for (int i = 0; i < f.now.axis_count; ++i)
    if (!powerless(f.catalog, f.now, axis(i))) return {};
  if (f.now.axis_count > 1) return compose(Severity::plain, "Motor power is off. Switch it on to move.");
  return compose(Severity::plain,
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

void add_running_words(StatusSentence& sentence, std::string_view words) {
  sentence.text = fmt::format("{} {}", sentence.text.view(), words);
  sentence.goes_on += words.size() + (sentence.goes_on > 0 ? 1 : 0);
}

/// The worst first, whatever moves: the motion comes after it.
StatusSentence status_sentence(const StatusFacts& facts) {
  for (const auto fault : {describe_link, describe_error})
    if (Sentence sentence = fault(facts)) return std::move(*sentence);
  if (Sentence late = describe_late(facts)) return with_motion_words(facts, std::move(*late));
  if (Sentence failed = describe_failed(facts)) return std::move(*failed);
  for (const auto warning : {describe_notice, describe_unset, describe_position, describe_slip,
                             describe_servo, describe_limit, describe_stale})
    if (Sentence sentence = warning(facts)) return with_motion_words(facts, std::move(*sentence));
  for (const auto part : {describe_motion, describe_program, describe_pieces, describe_power})
    if (Sentence sentence = part(facts)) return std::move(*sentence);
  return compose(Severity::plain, facts.catalog.program.slots > 0
                                      ? "Idle. Hold a jog button, type where to go, or run a program."
                                      : "Idle. Hold a jog button or type where to go.");
}

}  // namespace hw::gui
