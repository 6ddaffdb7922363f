// A change of any field that the user sees wakes the reader. Each field is changed, one at a time.
#include "core/session/snapshot_look.h"

#include <set>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

namespace hw {
namespace {

template <class T>
void change(T& value) {
  if constexpr (std::is_same_v<T, bool>)
    value = !value;
  else if constexpr (std::is_enum_v<T>)
    value = static_cast<T>(static_cast<int>(value) + 1);
  else if constexpr (std::is_arithmetic_v<T>)
    value += 1;
  else if constexpr (requires { value.flip(0); })
    value.flip(0);
  else if constexpr (requires { value.view(); })
    value = "another";
  else
    value += Millis(1);
}
void change(LinkHealth& link) { change(link.state); }
void change(Identity& identity) { change(identity.firmware); }
void change(AxisState& axis) { axis.position = axis.position + Steps(1); }
void change(ProgramState& program) { change(program.command); }
void change(ThreadState& thread) { change(thread.line); }
void change(WindowImage& window) { change(window.rings_known); }
void change(FeedState& feed) { change(feed.sent); }
void change(PiecesState& pieces) { change(pieces.step); }
void change(TransferState& transfer) { change(transfer.done); }
void change(ParamState& param) { change(param.stored); }
void change(IntentOutcome& outcome) { change(outcome.state); }
void change(JogGuard& guard) { change(guard.state); }
template <class T>
void change_field(T& value) {
  if constexpr (requires { std::tuple_size<T>::value; })
    change(value[0]);
  else
    change(value);
}

constexpr std::string_view names[] = {"sequence",
                                      "at",
                                      "link",
                                      "identity",
                                      "axis_count",
                                      "axes",
                                      "inputs",
                                      "inputs_known",
                                      "outputs",
                                      "outputs_known",
                                      "io_seen_at",
                                      "inputs_asked_at",
                                      "analog",
                                      "analog_known",
                                      "analog_seen_at",
                                      "program",
                                      "threads",
                                      "queue_free",
                                      "queue_known",
                                      "window",
                                      "feed",
                                      "pieces",
                                      "transfer",
                                      "jog_guard",
                                      "readouts",
                                      "readouts_known",
                                      "readouts_seen_at",
                                      "variables",
                                      "variables_known",
                                      "slot_bytes_used",
                                      "slots_torn",
                                      "params",
                                      "unsaved_setup",
                                      "unsaved_programs",
                                      "working",
                                      "restarts",
                                      "store_count",
                                      "program_changes",
                                      "program_changed_by",
                                      "poll_period",
                                      "outcomes",
                                      "notice"};
const std::set<std::string_view> not_seen{
    "sequence",         "at",          "io_seen_at",        "inputs_asked_at", "analog_seen_at",
    "readouts_seen_at", "poll_period", "program_changed_by"};

Snapshot shown() {
  Snapshot s;
  s.axis_count = 2;
  return s;
}

template <std::size_t Field>
void change_one(Snapshot& s) {
  auto& [sequence, at, link, identity, axis_count, axes, inputs, inputs_known, outputs, outputs_known,
         io_seen_at, inputs_asked_at, analog, analog_known, analog_seen_at, program, threads, queue_free,
         queue_known, window, feed, pieces, transfer, jog_guard, readouts, readouts_known, readouts_seen_at,
         variables, variables_known, slot_bytes_used, slots_torn, params, unsaved_setup, unsaved_programs,
         working, restarts, store_count, program_changes, program_changed_by, poll_period, outcomes, notice] =
      s;
  auto all = std::tie(sequence, at, link, identity, axis_count, axes, inputs, inputs_known, outputs,
                      outputs_known, io_seen_at, inputs_asked_at, analog, analog_known, analog_seen_at,
                      program, threads, queue_free, queue_known, window, feed, pieces, transfer, jog_guard,
                      readouts, readouts_known, readouts_seen_at, variables, variables_known, slot_bytes_used,
                      slots_torn, params, unsaved_setup, unsaved_programs, working, restarts, store_count,
                      program_changes, program_changed_by, poll_period, outcomes, notice);
  static_assert(std::tuple_size_v<decltype(all)> == std::size(names));
  change_field(std::get<Field>(all));
}

TEST(SnapshotLook, ChangesWithEachFieldThatIsSeen) {
  EXPECT_TRUE(looks_same(shown(), shown()));
  [&]<std::size_t... Field>(std::index_sequence<Field...>) {
    (
        [&] {
          Snapshot changed = shown();
          change_one<Field>(changed);
          EXPECT_EQ(looks_same(shown(), changed), not_seen.contains(names[Field])) << names[Field];
        }(),
        ...);
  }
  (std::make_index_sequence<std::size(names)>());
}

TEST(SnapshotLook, ALinkLooksOtherByItsStateItsWordsItsRateAndWhoEndsAJog) {
  const auto seen = [](auto change_it) {
    Snapshot changed = shown();
    change_it(changed.link);
    return !looks_same(shown(), changed);
  };
  EXPECT_TRUE(seen([](LinkHealth& l) { l.sentence = "No answer."; }));
  EXPECT_TRUE(seen([](LinkHealth& l) { l.next_attempt += Millis(1); }));
  EXPECT_TRUE(seen([](LinkHealth& l) { change(l.jog_ends); }));
  EXPECT_TRUE(seen([](LinkHealth& l) { l.polls_per_second = 5; }));
  EXPECT_FALSE(seen([](LinkHealth& l) { l.timeouts = 3, l.unparsed_bytes = 2, l.misses_in_a_row = 1; }));
}

TEST(SnapshotLook, AWindowIsSeenWhileItsRingsAre) {
  Snapshot before = shown(), after = shown();
  before.window.known = after.window.known = true;
  after.window.memory[7] = 1;
  EXPECT_TRUE(looks_same(before, after)) << "nobody looks at it";
  before.window.rings_known = after.window.rings_known = true;
  EXPECT_FALSE(looks_same(before, after));
}

TEST(SnapshotLook, TheTimeOfAReadingAloneIsNoNews) {
  Snapshot later = shown();
  later.axes[1].seen_at += Millis(200);
  EXPECT_TRUE(looks_same(shown(), later));
  later.axes[1].trust.kind = static_cast<decltype(later.axes[1].trust.kind)>(1);
  EXPECT_FALSE(looks_same(shown(), later));
  Snapshot far = shown();
  far.axes[max_axes - 1].position = Steps(9);
  EXPECT_TRUE(looks_same(shown(), far)) << "an axis that it has not";
}

}  // namespace
}  // namespace hw
