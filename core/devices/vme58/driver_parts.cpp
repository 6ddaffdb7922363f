#include "core/devices/vme58/driver_parts.h"

namespace hw::vme58 {

Talk::Talk(DriverContext& c, Readings::Listener& listener)
    : wire(c.scheduler, c.notify),
      selection(c.catalog),
      readings(wire, c.catalog, c.draft, listener),
      conversation(wire, readings, selection, c.texts),
      mailbox(wire, conversation),
      commands(wire, readings, conversation, selection, c.catalog, c.draft) {}

Known::Known(Talk& t, const Variant& variant, DriverContext& c)
    : next(c.draft),
      queues(c.catalog, t.selection, t.conversation, c.draft),
      values(c.catalog, variant, t.readings, c.draft),
      limits(c.draft),
      loops(t.wire, c.catalog, values, next, c.draft),
      motions(t.wire, c.catalog, t.readings, t.selection, limits, loops, next, c.draft),
      speeds(t.readings, t.selection, t.commands, queues, motions, c.catalog, c.draft),
      questions(t.wire, t.readings, t.conversation, t.selection, queues, limits, loops, motions, speeds, next,
                c.catalog, c.draft),
      lines(t.wire, t.readings, t.selection, t.commands, c.catalog, c.draft) {
  queues.were_read = [this](const Queues::Room& room) {
    speeds.take_queues(room.all_free);
    motions.take_queues(room.all_free, room.were_empty, room.empty);
  };
  speeds.forget();
}

void Known::forget() {
  next.forget();
  queues.forget();
  limits.forget();
  loops.forget();
  motions.forget();
  questions.forget();
}

Work::Work(Talk& t, Known& k, DriverContext& c)
    : drive(t.readings, t.selection, t.commands, k.values, k.loops, k.motions, k.next, c.catalog, c.draft),
      moves(t.wire, t.readings, t.selection, t.conversation, t.commands, k.loops, k.motions, k.speeds,
            c.catalog, c.draft),
      actions(t.selection, t.commands, k.loops, drive, k.motions, moves, k.speeds, k.next, c.catalog,
              c.draft),
      setup(t.wire, t.readings, t.selection, t.commands, k.values, drive, k.motions, k.speeds, c.catalog,
            c.draft) {}

Strings::Strings(Talk& t, Known& k, DriverContext& c)
    : stop_effect(t.wire, t.readings, k.motions, c.catalog),
      all_stop(t.wire, t.selection, t.conversation, t.mailbox, k.queues, k.motions, stop_effect, c.catalog,
               c.draft),
      effects(t.selection, t.conversation, k.lines, k.loops, k.values, k.motions, k.speeds, c.catalog),
      feed(t.readings, t.selection, t.conversation, t.commands, k.motions, effects, c.draft),
      programs(t.wire, t.readings, t.conversation, t.commands, k.motions, k.speeds, k.questions, all_stop,
               feed, c.draft),
      stops(t.wire, t.readings, t.selection, t.conversation, k.motions, k.speeds, programs, effects,
            stop_effect, all_stop, k.next, c.catalog, c.draft),
      texts(t.readings, t.selection, t.conversation, t.commands, k.motions, k.speeds, feed, programs, effects,
            k.next, c.catalog, c.draft) {
  t.commands.rejected_late = [this, &k](std::string& words) {
    k.motions.queued_was_rejected();
    programs.queued_was_rejected(words);
  };
}

void Strings::forget() {
  programs.forget();
  all_stop.forget();
  stops.forget();
}

}  // namespace hw::vme58
