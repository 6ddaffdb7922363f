// Each way in which a jog went on after the hand had left it, in the trackers of other consoles, is a case
// here.
#include "gui/model/jog_hold.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

class JogHoldTest : public testing::Test {
 protected:
  JogHold jog{[this](IntentBody body) { return note(body); }};
  std::vector<std::string> sent;  // keep-alives are counted only
  int keep_alives = 0;
  StoppedBy stopped_by = StoppedBy::unknown;
  IntentId last = 0;

  using Source = JogHold::Source;
  const JogHold::Control plus{Source::mouse, AxisId{0}, Sign::plus};
  const JogHold::Control minus{Source::mouse, AxisId{0}, Sign::minus};
  const JogHold::Control key{Source::keyboard, AxisId{0}, Sign::plus};
  const JogHold::Control other_key{Source::keyboard, AxisId{1}, Sign::plus};
  const JogHold::Want ten{Steps(10), Pps(500)};

  IntentId note(const IntentBody& body) {
    if (std::holds_alternative<intent::JogKeepAlive>(body))
      ++keep_alives;
    else if (const auto* by = std::get_if<intent::MoveBy>(&body))
      sent.push_back("step " + std::to_string(by->distances[0].axis.index) + " " +
                     std::to_string(by->distances[0].value.value));
    else if (const auto* start = std::get_if<intent::JogStart>(&body))
      sent.push_back("jog " + std::to_string(start->axis.index) + letter(start->sign));
    else if (const auto* stop = std::get_if<intent::JogStop>(&body))
      sent.push_back("stop"), stopped_by = stop->by;
    return ++last;
  }
  /// Frames at 60 Hz in which the control is drawn and pressed.
  double hold(const JogHold::Control& control, double from_s, double to_s) {
    double t = from_s;
    for (; t <= to_s; t += 1.0 / 60) {
      jog.confirm(control);
      jog.tick(t);
    }
    return t;
  }
  using Sent = std::vector<std::string>;
};

TEST_F(JogHoldTest, TapIsExactlyOneChosenStep) {
  jog.press(plus, ten, 1.0);
  hold(plus, 1.0, 1.2);
  EXPECT_TRUE(sent.empty()) << "nothing before it is known whether it is a tap";
  jog.release(plus, 1.249);
  EXPECT_EQ(sent, Sent{"step 0 10"});
  EXPECT_FALSE(jog.holding());
}

TEST_F(JogHoldTest, TapOfMinusGoesTheOtherWay) {
  jog.press(minus, ten, 1.0);
  jog.release(minus, 1.05);
  EXPECT_EQ(sent, Sent{"step 0 -10"});
}

TEST_F(JogHoldTest, HeldLongerJogsUntilLetGo) {
  jog.press(plus, ten, 1.0);
  const double t = hold(plus, 1.0, 2.0);
  EXPECT_EQ(sent, Sent{"jog 0+"});
  jog.release(plus, t);
  EXPECT_EQ(sent, (Sent{"jog 0+", "stop"}));
  hold(plus, t, t + 1);
  EXPECT_EQ(sent.size(), 2u) << "nothing more after the stop";
}

TEST_F(JogHoldTest, StartsAtAQuarterOfASecondOfTheHandNotOfTheFrame) {
  jog.press(plus, ten, 1.0);
  hold(plus, 1.01, 1.2499);
  EXPECT_TRUE(sent.empty());
  jog.confirm(plus);
  jog.tick(1.25);
  EXPECT_EQ(sent, Sent{"jog 0+"});
}

TEST_F(JogHoldTest, KeepsAliveAtLeastEvery100Ms) {
  jog.press(plus, ten, 0);
  double t = 0, last_alive = 0.25;
  int seen = 0;
  while (t < 3) {
    t += std::max(0.001, jog.due_in_s(t));
    jog.confirm(plus);
    jog.tick(t);
    if (keep_alives != seen) {
      EXPECT_LE(t - last_alive, 0.1 + 1e-9);
      last_alive = t;
      seen = keep_alives;
    }
  }
  EXPECT_GE(seen, 27);
}

TEST_F(JogHoldTest, FocusLossEndsAJogAndForgetsATap) {
  jog.press(plus, ten, 1.0);
  jog.let_go();
  EXPECT_TRUE(sent.empty()) << "a tap that was torn away moves nothing";
  jog.press(plus, ten, 2.0);
  hold(plus, 2.0, 2.5);
  jog.let_go();
  EXPECT_EQ(sent, (Sent{"jog 0+", "stop"}));
  jog.release(plus, 2.6);  // the release that comes after all
  EXPECT_EQ(sent.size(), 2u);
}

TEST_F(JogHoldTest, AnInterruptedHoldIsNoRelease) {
  jog.press(plus, ten, 1.0);
  double t = hold(plus, 1.0, 1.5);
  jog.release(plus, t);
  EXPECT_EQ(stopped_by, StoppedBy::let_go);
  jog.press(plus, ten, 2.0);
  hold(plus, 2.0, 2.5);
  jog.let_go();
  EXPECT_EQ(stopped_by, StoppedBy::console);
  stopped_by = StoppedBy::unknown;
  jog.press(plus, ten, 3.0);
  t = hold(plus, 3.0, 3.5);
  jog.confirm(plus);
  EXPECT_TRUE(jog.tick(t + 0.3)) << "this frame came late";
  EXPECT_EQ(stopped_by, StoppedBy::console);
  EXPECT_FALSE(jog.tick(t + 0.4));
}

TEST_F(JogHoldTest, ControlThatIsNoLongerDrawnEndsIt) {  // tab switch, layout change, dialog over it
  jog.press(plus, ten, 1.0);
  const double t = hold(plus, 1.0, 1.5);
  jog.tick(t);  // nobody confirmed
  EXPECT_EQ(sent, (Sent{"jog 0+", "stop"}));
}

TEST_F(JogHoldTest, LostKeyUpIsNoticedInTheNextFrame) {
  jog.press(key, ten, 1.0);
  const double t = hold(key, 1.0, 1.5);
  jog.tick(t);  // the keyboard does not say any more that it is held
  EXPECT_EQ(sent.back(), "stop");
}

TEST_F(JogHoldTest, FrozenFrameEndsItAndItMustBePressedAnew) {
  jog.press(plus, ten, 1.0);
  const double t = hold(plus, 1.0, 1.5);
  jog.confirm(plus);
  jog.tick(t + 0.3);
  EXPECT_EQ(sent, (Sent{"jog 0+", "stop"}));
  hold(plus, t + 0.31, t + 2);  // the mouse is still down
  EXPECT_EQ(sent.size(), 2u);
}

TEST_F(JogHoldTest, FreezeRightAfterThePressStartsNothing) {
  jog.press(plus, ten, 1.0);
  jog.confirm(plus);
  jog.tick(3.0);  // the release may wait behind this frame
  EXPECT_TRUE(sent.empty());
  EXPECT_FALSE(jog.holding());
}

TEST_F(JogHoldTest, AutoRepeatIsOnePress) {
  jog.press(key, ten, 1.0);
  for (double t = 1.03; t < 1.2; t += 0.03) jog.press(key, ten, t);
  jog.release(key, 1.21);
  EXPECT_EQ(sent, Sent{"step 0 10"});
}

TEST_F(JogHoldTest, AutoRepeatDoesNotRestartTheQuarterSecond) {
  jog.press(key, ten, 1.0);
  for (double t = 1.0; t < 1.4; t += 0.016) {
    jog.press(key, ten, t);
    jog.confirm(key);
    jog.tick(t);
  }
  EXPECT_EQ(sent, Sent{"jog 0+"});
}

TEST_F(JogHoldTest, QuickReleasePressReleaseIsTwoStepsAndNoJog) {
  jog.press(plus, ten, 1.00);
  jog.release(plus, 1.05);
  jog.press(plus, ten, 1.06);
  jog.release(plus, 1.10);
  hold(plus, 1.11, 2);
  EXPECT_EQ(sent, (Sent{"step 0 10", "step 0 10"}));
}

TEST_F(JogHoldTest, ReleaseAndPressAgainWhileJoggingStopsFirst) {
  jog.press(plus, ten, 1.0);
  const double t = hold(plus, 1.0, 1.5);
  jog.release(plus, t);
  jog.press(plus, ten, t + 0.01);
  const double u = hold(plus, t + 0.01, t + 0.5);
  jog.release(plus, u);
  EXPECT_EQ(sent, (Sent{"jog 0+", "stop", "jog 0+", "stop"}));
}

TEST_F(JogHoldTest, SecondControlEndsTheFirst) {
  jog.press(plus, ten, 1.0);
  const double t = hold(plus, 1.0, 1.5);
  jog.press(minus, ten, t);
  EXPECT_EQ(sent, (Sent{"jog 0+", "stop"}));
  jog.release(minus, t + 0.05);
  EXPECT_EQ(sent.back(), "step 0 -10");
  hold(plus, t + 0.06, t + 1);  // the first one is still down
  EXPECT_EQ(sent.size(), 3u) << "what was ended does not come back";
}

TEST_F(JogHoldTest, OrderOfReleasesDoesNotMatter) {
  for (const bool first_goes_first : {true, false}) {
    sent.clear();
    jog.press(key, ten, 1.0);
    double t = hold(key, 1.0, 1.5);
    jog.press(other_key, ten, t);
    t = hold(other_key, t, t + 0.5);
    EXPECT_EQ(sent, (Sent{"jog 0+", "stop", "jog 1+"}));
    jog.release(first_goes_first ? key : other_key, t);
    jog.release(first_goes_first ? other_key : key, t + 0.01);
    EXPECT_EQ(sent, (Sent{"jog 0+", "stop", "jog 1+", "stop"}));
    EXPECT_FALSE(jog.holding());
  }
}

TEST_F(JogHoldTest, MouseDoesNotLetGoOfWhatTheKeyHolds) {
  jog.press(key, ten, 1.0);
  const double t = hold(key, 1.0, 1.5);
  jog.release(plus, t);
  EXPECT_TRUE(jog.jogging());
  jog.release(key, t);
  EXPECT_EQ(sent.back(), "stop");
}

TEST_F(JogHoldTest, AfterAStopNoSecondStopIsSent) {  // a second one would mean: at once, without ramp
  jog.press(plus, ten, 1.0);
  const double t = hold(plus, 1.0, 1.5);
  jog.forget();
  jog.release(plus, t);
  hold(plus, t, t + 1);
  EXPECT_EQ(sent, Sent{"jog 0+"});
}

TEST_F(JogHoldTest, ReleaseAfterAQuarterSecondWithoutAFrameBetweenIsOneStep) {
  jog.press(plus, ten, 1.0);
  jog.release(plus, 1.26);
  EXPECT_EQ(sent, Sent{"step 0 10"});
}

TEST_F(JogHoldTest, ReleaseOfNothingSendsNothing) {
  jog.release(plus, 1.0);
  jog.let_go();
  jog.tick(2);
  EXPECT_TRUE(sent.empty());
}

}  // namespace
}  // namespace hw::gui
