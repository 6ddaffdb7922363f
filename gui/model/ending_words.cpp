#include "gui/model/ending_words.h"

#include <cstdlib>

#include <fmt/format.h>

#include "core/base/index.h"
#include "core/device/refusals.h"

namespace hw::gui {
namespace {

std::string_view stopped_by_words(StoppedBy by) {
  switch (by) {
    case StoppedBy::button: return "by the Stop button";
    case StoppedBy::key: return "by Esc";
    case StoppedBy::script: return "by the script";
    case StoppedBy::text: return "by the command that was sent";
    case StoppedBy::console: return "by the console, because its hold was interrupted or the link was lost";
    case StoppedBy::let_go: return "when its button was released";
    case StoppedBy::unknown: break;
  }
  return "by the console";
}

std::string_view words_of(AxisError error) {
  switch (error) {
    case AxisError::limit_minus: return " on its \u2212 limit";
    case AxisError::limit_plus: return " on its + limit";
    case AxisError::limit: return " on a limit";
    case AxisError::alarm: return ": its driver gave an alarm";
    case AxisError::stalled: return ": it stalled";
    case AxisError::too_far: return ": its position error was larger than allowed";
    case AxisError::not_corrected: return ": its position could not be corrected";
    case AxisError::none: break;
  }
  return "";
}

std::string_view failure_words(AxisError error) {
  switch (error) {
    case AxisError::limit_minus: return "hit its \u2212 limit";
    case AxisError::limit_plus: return "hit its + limit";
    case AxisError::limit: return "hit a limit";
    case AxisError::alarm: return "was stopped by an alarm of its driver";
    case AxisError::stalled: return "stalled";
    case AxisError::too_far: return "had a larger position error than allowed";
    case AxisError::not_corrected: return "could not be corrected";
    case AxisError::none: break;
  }
  return "failed";
}

std::string_view limit_of(const Ending& e) {
  if (e.limit_minus == e.limit_plus) return "a";
  return e.limit_minus ? "its \u2212" : "its +";
}

LoggedEvent::Mark mark_of(const Ending& e) {
  switch (e.by) {
    case EndedBy::stop:
    case EndedBy::abort:
    case EndedBy::elsewhere:
      return e.stopped_by == StoppedBy::let_go ? LoggedEvent::Mark::reached : LoggedEvent::Mark::stopped;
    case EndedBy::limit: return LoggedEvent::Mark::limit;
    case EndedBy::error:
    case EndedBy::lost:
    case EndedBy::not_in_place: return LoggedEvent::Mark::error;
    case EndedBy::nothing: return LoggedEvent::Mark::message;
    case EndedBy::target: break;
  }
  return e.what == Ending::What::homing ? LoggedEvent::Mark::homed : LoggedEvent::Mark::reached;
}

bool is_bad(const Ending& e) {
  return e.by == EndedBy::limit || e.by == EndedBy::error || e.by == EndedBy::lost ||
         e.by == EndedBy::not_in_place || e.by == EndedBy::elsewhere;
}

/// ": at rest 84 ms later, 1.700 mm on"
std::string course_of(const Ending& e, const ShowPosition& position) {
  if (!e.timed) return {};
  const std::string slowing =
      e.to_slowing ? fmt::format("slowing down {:.0f} ms later, ", 1000 * seconds(*e.to_slowing)) : "";
  return fmt::format(": {}at rest {:.0f} ms later, {} on", slowing, 1000 * seconds(e.to_rest),
                     position(AxisId{static_cast<std::uint8_t>(e.axis)}, e.ran_on));
}

std::string axis_words(const Ending& e, const std::string& at, const ShowPosition& position) {
  const bool jog = e.what == Ending::What::jog, homing = e.what == Ending::What::homing;
  const std::string_view what = jog ? "jog" : homing ? "homing" : "motion";
  switch (e.by) {
    case EndedBy::nothing: return fmt::format("{} ended{}", what, at);
    case EndedBy::target:
      if (homing) return fmt::format("found home{}", at);
      if (e.at_travel_end) return fmt::format("jog reached its set limit{}", at);
      return jog ? fmt::format("jog ended{}", at) : fmt::format("reached its target{}", at);
    case EndedBy::limit: return fmt::format("{} ended on {} limit{}", what, limit_of(e), at);
    case EndedBy::stop:
      if (e.stopped_by == StoppedBy::let_go)
        return fmt::format("jog ended {}{}{}", stopped_by_words(e.stopped_by), course_of(e, position), at);
      return fmt::format("{} stopped {}{}{}", what, stopped_by_words(e.stopped_by), course_of(e, position),
                         at);
    case EndedBy::abort:
      return fmt::format("{} stopped at once, without a ramp, {}{}{}", what, stopped_by_words(e.stopped_by),
                         course_of(e, position), at);
    case EndedBy::elsewhere:
      return fmt::format("{} was cut short by {}{}another host or at the controller{}", what,
                         e.perhaps_limit ? "a limit switch, by " : "",
                         e.beside_program ? "the running program, by " : "", at);
    case EndedBy::error: return fmt::format("{} ended with an error{}{}", what, words_of(e.error), at);
    case EndedBy::lost:
      return fmt::format("{} ended unseen: {}{}", what,
                         e.lost_with == Doubt::none ? "the cause is not known" : words_of(e.lost_with), at);
    case EndedBy::not_in_place: break;
  }
  const Steps off(std::abs(e.off.value));
  return fmt::format("{} ended {} from its command{}", what,
                     position(AxisId{static_cast<std::uint8_t>(e.axis)}, off), at);
}

/// " at line 12 of its stored code: X hit its + limit", as far as known.
std::string cause_words(const Ending& e, const Catalog& catalog) {
  std::string sentence = e.line < 0 ? "" : fmt::format(" at line {} of its stored code", e.line);
  if (e.failed_axis >= 0)
    sentence += fmt::format(": {} {}", catalog.axes[ix(e.failed_axis)].name, failure_words(e.error));
  return sentence;
}

std::string run_words(const Ending& e, const Catalog& catalog) {
  const std::string of = e.total > 0 ? fmt::format(" after {} of {}", e.done, e.total) : std::string();
  switch (e.by) {
    case EndedBy::target:
    case EndedBy::nothing:
      return e.total > 0 ? fmt::format("of {} ran to its end", e.total) : "ran to its end";
    case EndedBy::limit: return fmt::format("ended on a limit{}{}", of, cause_words(e, catalog));
    case EndedBy::stop: return fmt::format("stopped {}{}", stopped_by_words(e.stopped_by), of);
    case EndedBy::abort:
      return fmt::format("stopped at once, without a ramp, {}{}", stopped_by_words(e.stopped_by), of);
    case EndedBy::elsewhere:
      return fmt::format("was cut short{}{}",
                         e.what == Ending::What::program ? " by another host or at the controller" : "", of);
    case EndedBy::error: return fmt::format("stopped with an error{}{}", of, cause_words(e, catalog));
    case EndedBy::not_in_place: return fmt::format("ended, and an axis is not in place{}", of);
    case EndedBy::lost: break;
  }
  return fmt::format("ended unseen: the cause is not known{}", of);
}

std::string name_of_run(const Ending& e, const Catalog& catalog) {
  if (e.what == Ending::What::list) return "List";
  if (e.what == Ending::What::pieces) return "Drawing";
  const std::string& word = catalog.program.slot_word;
  return e.slot < 0 ? word : fmt::format("{} {}", word, e.slot);
}

/// ", at 12.000 mm"
std::string place_words(const Ending& e, const ShowPosition& position) {
  if (!e.place_known) return {};
  return fmt::format(", at {}", position(AxisId{static_cast<std::uint8_t>(e.axis)}, e.place));
}

}  // namespace

LoggedEvent event_of(const Ending& e, const Catalog& catalog, const ShowPosition& position) {
  LoggedEvent event;
  event.mark = mark_of(e);
  event.bad = is_bad(e);
  event.at = e.at;
  event.took_s = seconds(e.at - e.began);
  if (e.axis < 0) {
    event.subject = name_of_run(e, catalog);
    event.words = run_words(e, catalog);
    return event;
  }
  event.subject = catalog.axes[ix(e.axis)].name;
  event.words = axis_words(e, place_words(e, position), position);
  return event;
}

std::string words_beside_run(const Ending& motion, const Ending& run, const Catalog& catalog,
                             const ShowPosition& position) {
  const std::string& name = catalog.axes[ix(motion.axis)].name;
  const std::string place = place_words(motion, position);
  const bool by_a_stop = motion.by == EndedBy::stop || motion.by == EndedBy::abort;
  if (by_a_stop && motion.by == run.by && motion.stopped_by == run.stopped_by) {
    const std::string course = course_of(motion, position);
    return fmt::format("; {} {}{}", name, course.empty() ? "stopped" : course.substr(2), place);
  }
  if (motion.by == EndedBy::elsewhere && run.by == EndedBy::elsewhere)
    return fmt::format("; {} stopped{}", name, place);
  if (run.failed_axis == motion.axis && (motion.by == EndedBy::limit || motion.by == EndedBy::error))
    return place;
  return fmt::format("; {} {}", name, axis_words(motion, place, position));
}

}  // namespace hw::gui
