#include "core/devices/arcus/driver_parts.h"

namespace hw::arcus {

Known::Known(const Console& console, Conversation& talk,
             std::function<void(std::string_view how_it_shows, unsigned moved)> restarted)
    : code(console),
      borrowed(talk, [this](std::string_view name) { setup.was_borrowed(name); }),
      setup(console, talk, code, borrowed,
            {[this] { motions.loops_are_unknown(); },
             [restarted](std::string how_it_shows) { restarted(how_it_shows, 0); }}),
      list(console, talk),
      readouts(console, talk, [this](int axis, std::int64_t state) { motions.loop_is(axis, state); }),
      watch(console, talk, code, setup, {[this](int axis) { return motions.now(axis); }, restarted}),
      motions(console, setup),
      limits(console, talk),
      status(console, talk, code, list, readouts, watch, motions, limits),
      threads(console, talk, code, setup, watch),
      lines(console, talk, setup) {
  // Before the command is sent: a change that it explains is no power cycle, and what it starts or ends is
  // unknown from then on, confirmed or not.
  talk.goes_out = [this](std::string_view command) {
    watch.goes_out(command);
    threads.may_start(command);
    threads.are_told(command);
    code.goes_out(command);
  };
  // A glance is itself a poll question, so the other glance may come before it. None on a dirty line, where
  // every question waits for its deadline.
  talk.urgent = {[this, &talk] {
                   const bool clean = talk.station() && !talk.station()->is_dirty();
                   return clean && (lines.glance_is_due() || limits.glance_is_due());
                 },
                 [this] { return lines.glance_is_due() ? lines.glance() : limits.glance(); }};
  talk.not_done = [this](std::string_view command) { code.was_refused(command); };
}

Work::Work(const Console& console, Conversation& talk, Known& k, const language::Dialect& dialect)
    : moves(console, talk, k.setup, k.borrowed, k.readouts, k.watch, k.motions, k.status),
      feed(console, k.list, k.motions, k.status),
      actions(console, talk, k.setup, k.borrowed, k.list, k.readouts, k.motions, k.status, moves),
      live(console, talk, k.status, k.threads),
      stored(console, talk, k.code, live),
      guard(console, dialect, talk, k.code, k.borrowed, k.setup, k.threads, stored),
      programs(console, dialect, talk, k.code, k.status, k.threads, stored) {
  talk.goes_out = [this, first = std::move(talk.goes_out)](std::string_view command) {
    first(command);
    guard.goes_out(command);
  };
}

}  // namespace hw::arcus
