// What goes to a place by the count of an axis, and the words of its refusal.
#include "core/device/refusals.h"

#include <gtest/gtest.h>

#include "core/device/registry.h"

namespace hw {
namespace {

Catalog catalog_of(std::string_view model, const std::map<std::string, std::string>& options = {}) {
  return find_device_type(model)->make_catalog(options).value();
}
Snapshot doubtful(std::initializer_list<int> axes) {
  Snapshot now;
  for (const int axis : axes) now.axes[axis].trust.doubt(Doubt::power_cut, Instant(from_seconds(10)));
  return now;
}
AxisTarget to(int axis, std::int64_t place) {
  return {AxisId{static_cast<std::uint8_t>(axis)}, Steps(place)};
}
intent::Act act(const Catalog& c, std::string_view id, std::vector<std::int64_t> values) {
  return intent::Act(c.find_action(id), std::move(values));
}
std::string refusal(const Catalog& c, const Snapshot& now, const IntentBody& body) {
  return describe_doubtful(c, now, body, doubtful_axes(c, now, body), words_in_steps(c, now));
}

TEST(Refusals, AnAxisOfAMoveIsDoubtedByItself) {
  const Catalog c = catalog_of("vxm");
  const Snapshot now = doubtful({1});
  EXPECT_EQ(doubtful_axes(c, now, intent::MoveTo({to(0, 5), to(1, 5)})), 2u);
  EXPECT_EQ(doubtful_axes(c, now, intent::MoveTo({to(0, 5)})), 0u);
  EXPECT_EQ(doubtful_axes(c, now, intent::MoveBy({to(1, 5)})), 0u);
  EXPECT_EQ(doubtful_axes(c, now, intent::Home(AxisId{1}, Sign::minus)), 0u);
  EXPECT_EQ(doubtful_axes(c, now, intent::JogStart(AxisId{1}, Sign::minus)), 0u);
  EXPECT_EQ(doubtful_axes(c, now, intent::SendText("IA1M5")), 0u) << "the user's own word";
  EXPECT_EQ(doubtful_axes(c, now, intent::MoveTo({to(200, 5)})), 0u) << "there is none";
}

TEST(Refusals, SoAreTheActionsThatGoToPlaces) {
  const Catalog pmx = catalog_of("pmx-4ex-sa");
  const Snapshot now = doubtful({1});
  EXPECT_EQ(doubtful_axes(pmx, now, act(pmx, "change_target", {1, 400})), 2u);
  EXPECT_EQ(doubtful_axes(pmx, now, act(pmx, "change_target", {0, 400})), 0u);
  EXPECT_EQ(doubtful_axes(pmx, now, act(pmx, "arc", {0, 0, 90000})), 2u);
  EXPECT_EQ(doubtful_axes(pmx, now, act(pmx, "change_speed", {1, 400, 0})), 0u);
  EXPECT_EQ(doubtful_axes(pmx, now, intent::FeedMoves({{1, 2, 3, 1000}})), 2u);
  EXPECT_EQ(doubtful_axes(pmx, doubtful({3}), intent::FeedMoves({{1, 2, 3, 1000}})), 0u) << "X, Y, Z only";
  const Catalog dmx = catalog_of("dmx-k-sa");
  EXPECT_EQ(doubtful_axes(dmx, doubtful({0}), act(dmx, "change_target", {400})), 1u) << "its only axis";
  const Catalog board = catalog_of("vme58");
  EXPECT_EQ(doubtful_axes(board, now, act(board, "force_position", {1, 400})), 2u);
  EXPECT_EQ(doubtful_axes(board, now, act(board, "remainder", {1, 400})), 0u);
  EXPECT_EQ(doubtful_axes(board, now, intent::RunProgram(0)), 0u) << "the user's own word";
  EXPECT_EQ(doubtful_axes(board, now, intent::RunProgram(0, {to(0, 0), to(1, 0)})), 2u) << "the console's";
}

TEST(Refusals, OnceGoesWithEveryOneOfThem) {
  const Catalog pmx = catalog_of("pmx-4ex-sa");
  const Snapshot now = doubtful({0, 1});
  for (IntentBody body :
       {IntentBody(intent::MoveTo({to(0, 5)})), IntentBody(act(pmx, "arc", {0, 0, 360000})),
        IntentBody(intent::FeedMoves({{1, 2, 3, 1000}})), IntentBody(intent::RunProgram(0, {to(0, 0)}))}) {
    EXPECT_NE(doubtful_axes(pmx, now, body), 0u);
    go_despite_doubt(body);
    EXPECT_EQ(doubtful_axes(pmx, now, body), 0u);
  }
}

TEST(Refusals, TheSentenceNamesAxisCauseAndPlace) {
  const Catalog vxm = catalog_of("vxm");
  Snapshot now = doubtful({0});
  const IntentBody one = intent::MoveTo({to(0, -240)});
  EXPECT_EQ(refusal(vxm, now, one),
            "The position of motor 1 cannot be trusted: its power was cut. -240 steps may differ from "
            "before. Nothing was sent. Home it, set its position, or go on just this once.");
  now.axes[1].trust.doubt(Doubt::killed, {});
  EXPECT_EQ(
      refusal(vxm, now, intent::MoveTo({to(0, 0), to(1, 400)})),
      "The positions of motor 1 (power was cut) and motor 2 (stopped without a ramp) cannot be trusted. "
      "Their targets may differ from before. Nothing was sent. Home them, set their positions, or go "
      "on just this once.");
  EXPECT_EQ(refusal(vxm, doubtful({0, 1}), intent::MoveTo({to(0, 0), to(1, 400)})),
            "The positions of motor 1 and motor 2 cannot be trusted: their power was cut. Their targets may "
            "differ from before. Nothing was sent. Home them, set their positions, or go on just this once.");
  const DoubtWords clock{[](AxisId, Steps) { return "240.000 mm"; }, [](Instant) { return "12:31:07"; }};
  EXPECT_EQ(describe_doubtful(vxm, now, one, 1, clock),
            "The position of motor 1 cannot be trusted: its power was cut (12:31:07). 240.000 mm may differ "
            "from before. Nothing was sent. Home it, set its position, or go on just this once.");
  const Catalog dmx = catalog_of("dmx-k-sa", {{"id", "03"}});
  EXPECT_TRUE(refusal(dmx, doubtful({0}), one).starts_with("The position of axis X of device 03 cannot"));
}

TEST(Refusals, AllOfABoardsAxesFitIntoWhatAnOutcomeCanHold) {
  const Catalog board = catalog_of("vme58");
  std::vector<AxisTarget> everywhere;
  for (int i = 0; i < 8; ++i) everywhere.push_back(to(i, -2'147'483'647));
  const std::string all = refusal(board, doubtful({0, 1, 2, 3, 4, 5, 6, 7}), intent::MoveTo(everywhere));
  EXPECT_LE(all.size(), 320u) << all;
}

TEST(Refusals, WhereItStandsByItsCountIsOnlyTrusted) {
  Snapshot now;
  now.axes[0].position_known = true;
  now.axes[0].position = Steps(240);
  now.axes[0].activity = Activity::idle;
  const IntentBody same = stands_at(now, AxisId{0}, Steps(240)), other = stands_at(now, AxisId{0}, Steps(0));
  EXPECT_TRUE(std::holds_alternative<intent::TrustPosition>(same));
  ASSERT_TRUE(std::holds_alternative<intent::SetPosition>(other));
  now.axes[0].activity = Activity::jogging;
  EXPECT_TRUE(std::holds_alternative<intent::SetPosition>(stands_at(now, AxisId{0}, Steps(240))));
}

TEST(Refusals, ATornProgramIsNamedAtClosing) {
  Snapshot now;
  Catalog slots, threads;
  slots.program.slot_word = "Program";
  threads.program.threads = 2;
  EXPECT_EQ(describe_torn_is_left(slots, now), "");
  EXPECT_EQ(describe_torn_is_left(threads, now), "");
  now.slots_torn = 0b1010;
  EXPECT_EQ(
      describe_torn_is_left(slots, now),
      "Programs 1, 3 in the controller are not the text sent last. Load them again before they are run.");
  now.slots_torn = 1;
  EXPECT_EQ(describe_torn_is_left(threads, now),
            "Load the program again before you run it: the controller does not hold the text sent last.");
}

}  // namespace
}  // namespace hw
