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

template <class State, std::size_t n>
std::string_view word(const std::string_view (&words)[n], State state) {
  return words[static_cast<std::size_t>(state)];
}

}  // namespace

StateLog::Seen StateLog::seen_in(const Snapshot& now) {
  Seen seen;
  seen.link = now.link.state;
  seen.restarts = now.restarts;
  seen.run = now.program.run, seen.slot = now.program.slot;
  seen.slots_torn = now.slots_torn;
  seen.unsaved = now.unsaved_setup;
  seen.guard = now.jog_guard;
  seen.identity = now.identity;
  for (int i = 0; i < now.axis_count; ++i)
    seen.trust[ix(i)] = now.axes[ix(i)].trust, seen.activity[ix(i)] = now.axes[ix(i)].activity;
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
  const Whose whose{catalog_};
  if (now.link != before.link)
    log_.debug("{}: link {}, was {}", whose, word(link_state_names, now.link),
               word(link_state_names, before.link));
  if (!(now.identity == before.identity))
    log_.debug("{}: it names itself {}, firmware {}, serial number {}", whose, now.identity.model.view(),
               now.identity.firmware.view(), now.identity.serial.view());
  if (now.restarts != before.restarts) log_.debug("{}: it has restarted, time {}", whose, now.restarts);
  if (now.run != before.run || now.slot != before.slot)
    log_.debug("{}: program {} {}, was {}", whose, now.slot, word(run_state_names, now.run),
               word(run_state_names, before.run));
  if (now.slots_torn != before.slots_torn)
    log_.debug("{}: programs that are not what was sent: bits {:08b}", whose, now.slots_torn);
  if (now.unsaved != before.unsaved)
    log_.debug("{}: its set-up {}", whose, now.unsaved ? "differs from what is stored" : "is stored");
  if (!(now.guard == before.guard))
    log_.debug("{}: guard of held jogs {}", whose, word(guard_names, now.guard.state));
}

void StateLog::log_axis(int axis, const Seen& before, const Seen& now) const {
  const PositionTrust& trust = now.trust[ix(axis)];
  if (!(trust == before.trust[ix(axis)]))
    log_.debug("{}: the count of {} is {}{}{}{}", Whose{catalog_}, spoken_name(catalog_, axis),
               word(trust_names, trust.kind), trust.doubtful() ? ": " : "",
               trust.doubtful() ? words_of(trust.cause) : std::string_view(),
               trust.restored ? ", from an earlier session" : "");
  const Activity activity = now.activity[ix(axis)], was = before.activity[ix(axis)];
  if (activity != was)
    log_.debug("{}: {} {}, was {}", Whose{catalog_}, spoken_name(catalog_, axis),
               word(activity_names, activity), word(activity_names, was));
}

}  // namespace hw
