#include "core/devices/arcus/driver_parts.h"

namespace hw::arcus {

Known::Known(const Console& console, Conversation& conversation,
             std::function<void(std::string_view how_it_shows, unsigned moved)> restarted)
    : code(console),
      borrowed(conversation, [this](std::string_view name) { setup.was_borrowed(name); }),
      setup(console, conversation, code, borrowed,
            {[this] { motions.loops_are_unknown(); },
             [restarted](std::string how_it_shows) { restarted(how_it_shows, 0); }}),
      list(console, conversation),
      readouts(console, conversation, [this](int axis, std::int64_t state) { motions.loop_is(axis, state); }),
      watch(console, conversation, code, setup, {[this](int axis) { return motions.now(axis); }, restarted}),
      motions(console, setup),
      limits(console, conversation),
      status(console, conversation, code, list, readouts, watch, motions, limits),
      threads(console, conversation, code, setup, watch),
      lines(console, conversation, setup) {
  // To be called before a command is sent. A change that the command explains is no power cycle, and the
  // state of what it starts or ends is unknown from then on, confirmed or not.
  conversation.goes_out = [this](std::string_view command) {
    watch.goes_out(command);
    threads.may_start(command);
    threads.command_sent(command);
    code.goes_out(command);
  };
  // A glance is itself a poll question, so the other glance may come before it. None on a dirty line, where
  // every question waits for its deadline.
  conversation.urgent = {[this, &conversation] {
                           const bool clean = conversation.station() && !conversation.station()->is_dirty();
                           return clean && (lines.glance_is_due() || limits.glance_is_due());
                         },
                         [this] { return lines.glance_is_due() ? lines.glance() : limits.glance(); }};
  conversation.not_done = [this](std::string_view command) { code.was_refused(command); };
}

Work::Work(const Console& console, Conversation& conversation, Known& k, const language::Dialect& dialect)
    : moves(console, conversation, k.setup, k.borrowed, k.readouts, k.watch, k.motions, k.status),
      feed(console, k.list, k.motions, k.status),
      actions(console, conversation, k.setup, k.borrowed, k.list, k.readouts, k.motions, k.status, moves),
      live(console, conversation, k.status, k.threads),
      stored(console, conversation, k.code, live),
      guard(console, dialect, conversation, k.code, k.borrowed, k.setup, k.threads, stored),
      programs(console, dialect, conversation, k.code, k.status, k.threads, stored) {
  conversation.goes_out = [this, first = std::move(conversation.goes_out)](std::string_view command) {
    first(command);
    guard.goes_out(command);
  };
}

}  // namespace hw::arcus
