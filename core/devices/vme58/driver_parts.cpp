#include "core/devices/vme58/driver_parts.h"

namespace hw::vme58 {

Talk::Talk(DriverContext& c, Readings::Listener& listener)
    : wire(c.scheduler, c.notify),
      selection(c.catalog),
      readings(wire, c.catalog, c.snapshot, listener),
      conversation(wire, readings, selection, c.texts),
      mailbox(wire, conversation),
      commands(wire, readings, conversation, selection, c.catalog, c.snapshot) {}

Known::Known(Talk& t, const Variant& variant, DriverContext& c)
    : next(c.snapshot),
      queues(c.catalog, t.selection, t.conversation, c.snapshot),
      values(c.catalog, variant, t.readings, c.snapshot),
      limits(c.snapshot),
      loops(t.wire, c.catalog, values, next, c.snapshot),
      motions(t.wire, c.catalog, t.readings, t.selection, limits, loops, next, c.snapshot),
      speeds(t.readings, t.selection, t.commands, queues, motions, c.catalog, c.snapshot),
      questions(t.wire, t.readings, t.conversation, t.selection, queues, limits, loops, motions, speeds, next,
                c.catalog, c.snapshot),
      lines(t.wire, t.readings, t.selection, t.commands, c.catalog, c.snapshot) {
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
    : drive(t.readings, t.selection, t.commands, k.values, k.loops, k.motions, k.next, c.catalog, c.snapshot),
      moves(t.wire, t.readings, t.selection, t.conversation, t.commands, k.loops, k.motions, k.speeds,
            c.catalog, c.snapshot),
      actions(t.selection, t.commands, k.loops, drive, k.motions, moves, k.speeds, k.next, c.catalog,
              c.snapshot),
      setup(t.wire, t.readings, t.selection, t.commands, k.values, drive, k.motions, k.speeds, c.catalog,
            c.snapshot) {}

Strings::Strings(Talk& t, Known& k, DriverContext& c)
    : stop_effect(t.wire, t.readings, k.motions, c.catalog),
      all_stop(t.wire, t.selection, t.conversation, t.mailbox, k.queues, k.motions, stop_effect, c.catalog,
               c.snapshot),
      effects(t.selection, t.conversation, k.lines, k.loops, k.values, k.motions, k.speeds, c.catalog),
      feed(t.readings, t.selection, t.conversation, t.commands, k.motions, effects, c.snapshot),
      programs(t.wire, t.readings, t.conversation, t.commands, k.motions, k.speeds, k.questions, all_stop,
               feed, c.snapshot),
      stops(t.wire, t.readings, t.selection, t.conversation, k.motions, k.speeds, programs, effects,
            stop_effect, all_stop, k.next, c.catalog, c.snapshot),
      texts(t.readings, t.selection, t.conversation, t.commands, k.motions, k.speeds, feed, programs, effects,
            k.next, c.catalog, c.snapshot) {
  t.commands.rejected_late = [this, &k](std::string& words) {
    k.motions.queued_was_rejected();
    programs.queued_was_rejected(words);
  };
}

void Strings::forget() {
  programs.forget();
  all_stop.forget();
  stops.forget();
  texts.forget_prepared();
}

}  // namespace hw::vme58
