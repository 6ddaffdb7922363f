#include "core/device/state_log.h"

#include <utility>

#include "core/base/index.h"
#include "core/device/refusals.h"

namespace hw {
namespace {

constexpr std::string_view link_state_names[] = {"connecting", "good", "late", "lost", "closed"};
static_assert(std::size(link_state_names) == static_cast<std::size_t>(LinkState::closed) + 1);
constexpr std::string_view run_state_names[] = {"idle", "running", "waiting", "held", "error"};
static_assert(std::size(run_state_names) == static_cast<std::size_t>(RunState::error) + 1);
constexpr std::string_view guard_names[] = {"unknown", "absent", "without room", "installed"};
static_assert(std::size(guard_names) == static_cast<std::size_t>(JogGuard::State::installed) + 1);
constexpr std::string_view activity_names[] = {"unknown", "idle",     "moving", "jogging",
                                               "homing",  "stopping", "error"};
static_assert(std::size(activity_names) == static_cast<std::size_t>(Activity::error) + 1);
constexpr std::string_view trust_names[] = {"counted from an unknown zero", "homed", "set by hand",
                                            "doubtful"};
static_assert(std::size(trust_names) == static_cast<std::size_t>(Trust::untrusted) + 1);

constexpr std::string_view endings[] = {"",
                                        ", at its target",
                                        ", by a limit",
                                        ", by a stop of the console",
                                        ", by an abort of the console",
                                        ", by another host or at the controller",
                                        ", by an error",
                                        ", with the link",
                                        ", not in place"};
static_assert(std::size(endings) == static_cast<std::size_t>(EndedBy::not_in_place) + 1);

template <class State, std::size_t n>
std::string_view word(const std::string_view (&words)[n], State state) {
  return words[static_cast<std::size_t>(state)];
}

bool runs(RunState run) { return run == RunState::running || run == RunState::waiting; }

}  // namespace

StateLog::Seen StateLog::seen_in(const Snapshot& now) {
  Seen seen;
  seen.link = now.link.state;
  seen.restarts = now.restarts;
  seen.run = now.program.run, seen.slot = now.program.slot, seen.run_ended_by = now.program.ended_by;
  seen.slots_torn = now.slots_torn;
  seen.unsaved = now.unsaved_setup;
  seen.guard = now.jog_guard;
  seen.identity = now.identity;
  for (int i = 0; i < now.axis_count; ++i) {
    const AxisState& axis = now.axes[ix(i)];
    seen.trust[ix(i)] = axis.trust, seen.activity[ix(i)] = axis.activity,
    seen.ended_by[ix(i)] = axis.ended_by;
  }
  return seen;
}

void StateLog::look(const Snapshot& now) {
  if (!log_.wants(log::Level::debug)) {
    looks_ = false;
    return;
  }
  const Seen before = std::exchange(last_, seen_in(now));
  if (!std::exchange(looks_, true)) return;
  log_controller(before, last_);
  for (int i = 0; i < now.axis_count; ++i) log_axis(i, before, last_);
}

void StateLog::log_controller(const Seen& before, const Seen& now) const {
  const LogName device{catalog_};
  if (now.link != before.link)
    log_.debug("{}: link {}, was {}", device, word(link_state_names, now.link),
               word(link_state_names, before.link));
  if (!(now.identity == before.identity))
    log_.debug("{}: it names itself {}, firmware {}{}{}", device, now.identity.model.view(),
               now.identity.firmware.view(), now.identity.serial.empty() ? "" : ", serial number ",
               now.identity.serial.view());
  if (now.restarts != before.restarts) log_.debug("{}: it has restarted, time {}", device, now.restarts);
  if (now.run != before.run || now.slot != before.slot)
    log_.debug("{}: program {} {}, was {}{}", device, now.slot, word(run_state_names, now.run),
               word(run_state_names, before.run),
               runs(before.run) && !runs(now.run) ? word(endings, now.run_ended_by) : std::string_view());
  if (now.slots_torn != before.slots_torn)
    log_.debug("{}: programs that differ from the text sent: bits {:08b}", device, now.slots_torn);
  if (now.unsaved != before.unsaved)
    log_.debug("{}: its set-up {}", device, now.unsaved ? "differs from what is stored" : "is stored");
  if (!(now.guard == before.guard))
    log_.debug("{}: guard of held jogs {}", device, word(guard_names, now.guard.state));
}

void StateLog::log_axis(int axis, const Seen& before, const Seen& now) const {
  const PositionTrust& trust = now.trust[ix(axis)];
  if (!(trust == before.trust[ix(axis)]))
    log_.debug("{}: the count of {} is {}{}{}{}", LogName{catalog_}, spoken_name(catalog_, axis),
               word(trust_names, trust.kind), trust.doubtful() ? ": " : "",
               trust.doubtful() ? words_of(trust.cause) : std::string_view(),
               trust.restored ? ", from an earlier session" : "");
  const Activity activity = now.activity[ix(axis)], was = before.activity[ix(axis)];
  if (activity != was)
    log_.debug("{}: {} {}, was {}{}", LogName{catalog_}, spoken_name(catalog_, axis),
               word(activity_names, activity), word(activity_names, was),
               activity == Activity::idle && was != Activity::unknown ? word(endings, now.ended_by[ix(axis)])
                                                                      : std::string_view());
}

}  // namespace hw
