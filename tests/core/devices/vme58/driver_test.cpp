// The VME58's driver against the emulated board, through the real session, link and window.
#include "core/devices/vme58/facts.h"
#include "tests/core/devices/vme58/driver_rig.h"

namespace hw {
namespace {

using test::Seconds;
using test::Vme58Rig;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

class Vme58Driver : public Vme58Rig {};

// A board that comes to its ring a little after its mailbox, as one that is busy does.
class Vme58SlowBoard : public Vme58Rig {
 protected:
  class SlowRing final : public Window {
   public:
    SlowRing(Vme58SlowBoard& board, std::unique_ptr<Window> window)
        : board_(board), window_(std::move(window)), later_(board.time, [this] { board_.let_text_come(); }) {}
    void listen(Listener* listener) override { window_->listen(listener); }
    Task<Result<>> run(std::span<BusCycle> cycles) override {
      std::vector<BusCycle> now;
      for (const BusCycle& c : cycles) {
        if (board_.hold_text && c.write && c.offset == vme58::at::output_put_index)
          board_.held = c.value;
        else
          now.push_back(c);
        if (board_.held && c.write && c.offset == vme58::reg::control &&
            (c.value & vme58::control::interrupt_board) != 0 && !later_.armed())
          later_.arm(board_.time.now() + std::chrono::microseconds(300));
      }
      auto done = co_await window_->run(now);
      auto next = now.begin();
      for (BusCycle& c : cycles)
        if (next != now.end() && next->write == c.write && next->offset == c.offset) c = *next++;
      co_return done;
    }
    [[nodiscard]] std::string describe() const override { return window_->describe(); }

   private:
    Vme58SlowBoard& board_;
    std::unique_ptr<Window> window_;
    Timer later_;
  };
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    return std::make_unique<SlowRing>(*this, std::move(window));
  }
  void let_text_come() {
    hold_text = false;
    poke(2, vme58::at::output_put_index, *std::exchange(held, std::nullopt));
    text_came = true;
  }

  bool hold_text = false, text_came = false;
  std::optional<std::uint32_t> held;
};

TEST_F(Vme58Driver, FindsOutWhatItIs) {
  EXPECT_EQ(now().identity.model.view(), "VME58-8S");
  EXPECT_FALSE(now().identity.firmware.empty());
  EXPECT_EQ(now().axis_count, 8);
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(axis(i).position_known) << i;
    EXPECT_EQ(axis(i).activity, Activity::idle) << i;
    EXPECT_TRUE(axis(i).has_encoder);
  }
}

TEST_F(Vme58Driver, JogsOneAxisAndStopsItWhenLetGo) {
  session->send(intent::JogStart(AxisId{3}, Sign::minus, Pps{1500}));
  for (int i = 0; i < 20; ++i) {
    run(Millis(100));
    session->send(intent::JogKeepAlive());
  }
  EXPECT_EQ(axis(3).activity, Activity::jogging);
  EXPECT_EQ(axis(3).direction, -1);
  EXPECT_NEAR(axis(3).speed.value, 1500, 1);
  session->send(intent::JogStop());
  ASSERT_TRUE(becomes_idle());
  EXPECT_LT(axis(3).position, Steps(-2500));
  EXPECT_EQ(axis(3).ended_by, EndedBy::stop);
  EXPECT_EQ(axis(0).position, Steps(0));
}

TEST_F(Vme58Driver, AJogWithoutASpeedGoesAtTheOneThatIsShown) {
  ASSERT_TRUE(query("AY VL3000"));
  run(Seconds(1));
  EXPECT_EQ(axis(1).own_speed, Pps{3000});
  session->send(intent::MoveBy({{AxisId{1}, Steps(5000)}}, Pps{500}));
  run(Seconds(1));
  EXPECT_EQ(axis(1).own_speed, Pps{3000}) << "the speed of one move is no setting";
  session->send(intent::Stop());
  ASSERT_TRUE(becomes_idle());
  session->send(intent::JogStart(AxisId{1}, Sign::plus, Pps{}, false));
  run(Seconds(1));
  EXPECT_NEAR(axis(1).speed.value, 3000, 1);
}

TEST_F(Vme58Driver, MovesOneAxisToItsTarget) {
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{1}, Steps(4000)}}, Pps{2000})).state, IntentState::done);
  EXPECT_EQ(axis(1).activity, Activity::moving);
  EXPECT_TRUE(axis(1).has_target);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(1).position, Steps(4000));
  EXPECT_EQ(axis(1).encoder, Steps(4000));
  EXPECT_EQ(axis(1).ended_by, EndedBy::target);
  run(Seconds(1));
  EXPECT_EQ(now().params[static_cast<std::size_t>(session->catalog().find_param("VLY"))].value,
            vme58::default_velocity)
      << "the speed of one move is no setting";
}

TEST_F(Vme58Driver, MovesSeveralAxesTogetherAndKeepsTheUsersAxis) {
  ASSERT_TRUE(query("AZ"));
  EXPECT_EQ(
      perform(intent::MoveTo({{AxisId{0}, Steps(40000)}, {AxisId{7}, Steps(-20000)}}, Pps{20000})).state,
      IntentState::done);
  run(Seconds(1));
  EXPECT_NEAR(static_cast<double>(axis(0).position.value), -2.0 * static_cast<double>(axis(7).position.value),
              4);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(40000));
  EXPECT_EQ(axis(7).position, Steps(-20000));
  ASSERT_TRUE(query("MR100 GO"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(2).position, Steps(100));
}

TEST_F(Vme58Driver, AStopGoesThroughTheMailboxPastAFullQueueAndWhatWaitsIsTakenBack) {
  ASSERT_TRUE(query("AX VL1000 AC100000 MR1000000 GO"));
  std::string many;
  for (int i = 0; i < 150; ++i) many += "WT1 ";
  (void)query(many);  // more than the queue holds: the rest waits in the ring
  std::string behind = "MR777 GO ";
  (void)query(behind);
  ASSERT_EQ(axis(0).activity, Activity::moving);
  EXPECT_NE(peek(2, vme58::at::output_get_index), peek(2, vme58::at::output_put_index))
      << "the ring is blocked";
  const Instant asked = time.now();
  session->send(intent::Stop());
  ASSERT_TRUE(run_until([this] { return axis(0).speed.value == 0; }, Seconds(5)));
  EXPECT_LT(time.now() - asked, Millis(100));
  const Steps there = axis(0).position;
  run(Seconds(5));
  EXPECT_EQ(axis(0).position, there) << "nothing that waited may act after a stop";
  EXPECT_THAT(lines(), Contains("> mailbox SA"));
}

TEST_F(Vme58SlowBoard, TextThatTheBoardTakesBehindTheMailDoesNotMoveBehindTheStop) {
  hold_text = true;
  session->send(intent::MoveTo({{AxisId{0}, Steps(1000000)}}, Pps{2000}));
  run(Millis(1));
  EXPECT_EQ(axis(0).speed.value, 0);
  session->send(intent::Stop());
  run(Seconds(3));
  ASSERT_TRUE(text_came) << "the board has taken the move after it took the stop";
  EXPECT_EQ(axis(0).speed.value, 0);
  const Steps there = axis(0).position;
  EXPECT_LT(there, Steps(100));
  run(Seconds(5));
  EXPECT_EQ(axis(0).position, there);
}

TEST_F(Vme58Driver, AbortKillsAllWithoutARamp) {
  ASSERT_EQ(perform(intent::SetParam("ACX", 1000)).state, IntentState::done);
  perform(intent::MoveTo({{AxisId{0}, Steps(100000)}}, Pps{5000}));
  run(Seconds(6));
  session->send(intent::Abort());
  run(Millis(100));
  const Steps there = axis(0).position;
  run(Seconds(5));
  EXPECT_EQ(axis(0).position, there);
  EXPECT_EQ(axis(0).ended_by, EndedBy::abort);
}

TEST_F(Vme58Driver, TheStopOfOneAxisLeavesTheOthers) {
  perform(intent::MoveTo({{AxisId{0}, Steps(100000)}}, Pps{2000}));
  perform(intent::MoveTo({{AxisId{1}, Steps(100000)}}, Pps{2000}));
  run(Seconds(1));
  session->send(intent::Stop(0));
  run(Seconds(1));
  EXPECT_EQ(axis(0).activity, Activity::idle);
  EXPECT_EQ(axis(0).ended_by, EndedBy::stop);
  EXPECT_EQ(axis(1).activity, Activity::moving);
}

TEST_F(Vme58Driver, TheCommandThatTheBoardRejectsIsNamed) {
  const auto reply = query("AX MR100 XQ GO");
  ASSERT_FALSE(reply);
  EXPECT_THAT(reply.error().sentence(), HasSubstr("\"XQ\""));
  const auto range = query("AX VL9999999");
  ASSERT_FALSE(range);
  EXPECT_THAT(range.error().sentence(), HasSubstr("VL9999999"));
  EXPECT_TRUE(query("WY")) << "it goes on";
}

TEST_F(Vme58Driver, QueriesAreAnsweredWithoutTheirFrames) {
  EXPECT_EQ(*query("AX RP"), "0");
  EXPECT_EQ(*query("AA RP"), "0,0,0,0,0,0,0,0");
  EXPECT_EQ(*query("AX RQ WY"), "200\nVME58 ver 2.24-8S");
  EXPECT_EQ(*query("AX LP1200 RP"), "1200");
}

TEST_F(Vme58Driver, TheTerminalShowsCommandsAndRepliesAsLines) {
  (void)lines();
  ASSERT_TRUE(query("AX RP"));
  EXPECT_THAT(lines(), ElementsAre("> AX;", "> RP;", "< 0"));
}

TEST_F(Vme58Driver, HomesToTheEdgeAndComesBackToIt) {
  AxisPlace place;
  place.home_from = Steps(5000);
  place.home_to = Steps(5400);
  operate(bench::Place(AxisId{0}, place));
  ASSERT_EQ(perform(intent::SetParam("VLX", 2000)).state, IntentState::done);
  ASSERT_EQ(perform(intent::Home(AxisId{0}, Sign::plus, 1)).state, IntentState::done);
  EXPECT_EQ(axis(0).activity, Activity::homing);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(0));
  EXPECT_EQ(axis(0).ended_by, EndedBy::target);
  EXPECT_TRUE(axis(0).home);
}

TEST_F(Vme58Driver, ALimitSwitchEndsTheMoveAndIsShownOnItsSide) {
  AxisPlace place;
  place.plus = Steps(3000);
  place.minus = Steps(-3000);
  operate(bench::Place(AxisId{0}, place));
  ASSERT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(-9000)}}, Pps{2000})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).ended_by, EndedBy::limit);
  run(Seconds(1));
  EXPECT_TRUE(axis(0).limit_minus);
  EXPECT_FALSE(axis(0).limit_plus);
}

TEST_F(Vme58Driver, ParametersAreReadFromTheDataArea) {
  const auto value = [&](const char* name) {
    const auto i = static_cast<std::size_t>(session->catalog().find_param(name));
    EXPECT_TRUE(now().params[i].known) << name;
    return now().params[i].value;
  };
  EXPECT_EQ(value("VLX"), vme58::default_velocity);
  EXPECT_EQ(value("ACS"), vme58::default_acceleration);
  ASSERT_EQ(perform(intent::SetParam("KPX", 1250)).state, IntentState::done);
  EXPECT_EQ(value("KPX"), 1250) << "12.5; the board shows 12";
  EXPECT_EQ(peek(4, vme58::offset_of(0, vme58::AxisValue::proportional_gain)), 12u);
  ASSERT_TRUE(query("AX KP7"));
  run(Seconds(3));
  EXPECT_EQ(value("KPX"), 700);
  ASSERT_TRUE(query("AX KP3.5"));
  run(Seconds(3));
  EXPECT_EQ(value("KPX"), 350) << "the board keeps the fraction, and shows 3";
}

TEST_F(Vme58Driver, AFreshSessionDoesNotShowPartOfAGainForAllOfIt) {
  const auto gain = [&](const char* name) {
    const auto i = static_cast<std::size_t>(session->catalog().find_param(name));
    return now().params[i].known ? std::optional(now().params[i].value) : std::nullopt;
  };
  const auto come_back = [&] {
    operate(bench::Unplug(true));
    ASSERT_TRUE(run_until([&] { return now().link.state == LinkState::lost; }, Seconds(20)));
    operate(bench::Unplug(false));
    ASSERT_TRUE(run_until([&] { return now().link.state == LinkState::good; }, Seconds(20)));
    run(Seconds(3));
  };
  ASSERT_EQ(perform(intent::SetParam("KPX", 1200)).state, IntentState::done);
  come_back();
  EXPECT_EQ(gain("KPX"), 1200);
  ASSERT_TRUE(query("AX KP12.5"));
  run(Seconds(1));
  EXPECT_EQ(gain("KPX"), 1250);
  come_back();
  EXPECT_EQ(gain("KPX"), std::nullopt) << "12 and nobody knows what more";
  EXPECT_NE(gain("VLX"), std::nullopt);
  ASSERT_EQ(perform(intent::SetParam("KPX", 300)).state, IntentState::done);
  run(Seconds(3));
  EXPECT_EQ(gain("KPX"), 300) << "said by this one";
  ASSERT_EQ(perform(intent::Reset()).state, IntentState::done);
  run(Seconds(3));
  EXPECT_EQ(gain("KDX"), 0) << "have their factory values";
}

TEST_F(Vme58Driver, OutputsGoByTheMakersNumbers) {
  ASSERT_EQ(perform(intent::SetOutput(8, true)).state, IntentState::done);
  EXPECT_EQ(peek(1, vme58::reg::io_high) & 1, 0u) << "on is low";
  ASSERT_EQ(perform(intent::SetOutput(8, false)).state, IntentState::done);
  EXPECT_EQ(peek(1, vme58::reg::io_high) & 1, 1u);
  EXPECT_EQ(perform(intent::SetOutput(0, true)).state, IntentState::refused) << "an input";
  ASSERT_EQ(perform(intent::SetOutput(14, false)).state, IntentState::done) << "auxiliary of X";
  operate(bench::Input(3, true));
  run(Seconds(1));
  EXPECT_EQ(now().inputs & 0x7u, 0x3u) << "line 2 is low";
}

TEST_F(Vme58Driver, AResetOfTheBoardIsNoticed) {
  perform(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  ASSERT_TRUE(becomes_idle());
  (void)reported();
  perform(intent::Stop());  // which keeps nothing back afterwards
  run(Millis(500));
  operate(bench::PowerCycle());
  ASSERT_TRUE(
      run_until([this] { return now().restarts == 1 && now().link.state == LinkState::good; }, Seconds(10)));
  run(Seconds(1));
  EXPECT_EQ(now().restarts, 1u) << "noticed once";
  EXPECT_EQ(axis(0).position, Steps(0));
  EXPECT_THAT(reported(), HasSubstr("switched off and on"));
  EXPECT_TRUE(axis(0).trust.doubtful()) << "0 wherever the motor stands";
  intent::MoveTo once({{AxisId{0}, Steps(200)}});
  EXPECT_EQ(perform(once).state, IntentState::refused);
  EXPECT_EQ(axis(0).position, Steps(0));
  once.despite_doubt = true;
  EXPECT_EQ(perform(once).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(200));
  EXPECT_TRUE(axis(0).trust.doubtful()) << "a move tells nothing";
  operate(bench::PowerCycle());
  EXPECT_TRUE(run_until([this] { return now().restarts == 2; }, Seconds(10))) << "doubtful or not";
}

TEST_F(Vme58Driver, PositionsAreDoubtfulAfterAResetUntilTheyAreSetOrHomed) {
  ASSERT_EQ(perform(intent::Reset()).state, IntentState::done);
  EXPECT_EQ(axis(0).trust.cause, Doubt::reset) << "the console's own";
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(10)));
  ASSERT_EQ(perform(intent::SetPosition(0, Steps(100))).state, IntentState::done);
  EXPECT_FALSE(axis(0).trust.doubtful());
  EXPECT_TRUE(axis(1).trust.doubtful());
  ASSERT_TRUE(query("AY LP0"));
  run(Millis(500));
  EXPECT_FALSE(axis(1).trust.doubtful());
  EXPECT_TRUE(axis(2).trust.doubtful());
}

TEST_F(Vme58Driver, AJogThatIsRejectedStopsNothingElse) {
  perform(intent::SendText("AY HF"));
  perform(intent::MoveBy({{AxisId{0}, Steps(20000)}}, Pps(5000)));
  run(Millis(300));
  EXPECT_EQ(perform(intent::JogStart(AxisId{1}, Sign::plus)).state, IntentState::failed)
      << "its loop is open";
  perform(intent::JogStop());
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).ended_by, EndedBy::target);
  EXPECT_EQ(axis(0).position, Steps(20000));
}

TEST_F(Vme58Driver, ALostLinkEndsARecordingAndAProgramThatIsFed) {
  const auto reconnect = [this] {
    operate(bench::Unplug(true));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, Seconds(20)));
    operate(bench::Unplug(false));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(20)));
    ASSERT_TRUE(becomes_idle());
  };
  perform(intent::SendText("AA CD0,0; CV1000;"));
  run(Seconds(1));
  reconnect();
  EXPECT_THAT(reported(), HasSubstr("its first part was lost with the connection"));
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(400)}})).state, IntentState::done);
  ASSERT_TRUE(becomes_idle());
  std::string text = "AX VL20000 AC1000000\n";
  for (int i = 0; i < 600; ++i) text += "MR10 GO\n";
  ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  run(Millis(300));
  ASSERT_TRUE(now().feed.running);
  reconnect();
  EXPECT_FALSE(now().feed.running);
  EXPECT_EQ(perform(intent::SendText("AA CD100,100; CE")).state, IntentState::done);
}

TEST_F(Vme58Driver, AHomingThatNeverBeganTakesNoDoubtAway) {
  ASSERT_EQ(perform(intent::Reset()).state, IntentState::done);
  ASSERT_TRUE(run_until([this] { return axis(0).trust.doubtful(); }, Seconds(10)));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(10)));
  perform(intent::SendText("AX WT3000 HM0"));
  run(Millis(500));
  perform(intent::Stop());
  run(Seconds(5));
  EXPECT_TRUE(axis(0).trust.doubtful()) << "stopped while it waited in the queue";
  perform(intent::SendText("AZ HF"));
  EXPECT_EQ(perform(intent::Home(AxisId{2}, Sign::plus, 0)).state, IntentState::failed) << "its loop is open";
  perform(intent::SendText("AY MR100 GO"));
  ASSERT_TRUE(becomes_idle());
  run(Seconds(2));
  EXPECT_TRUE(axis(2).trust.doubtful());
}

TEST_F(Vme58Driver, IndexesThatAnotherHostHasWrittenDoNotHarmForLong) {
  poke(2, vme58::at::output_put_index, 0xFFFF);
  run(Seconds(1));
  poke(2, vme58::at::output_put_index, peek(2, vme58::at::output_get_index));
  run(Seconds(3));
  EXPECT_EQ(now().link.state, LinkState::good);
}

TEST_F(Vme58Driver, AProgramIsFedCommandByCommandAndEndsWhenAllRests) {
  ASSERT_EQ(
      perform(intent::LoadProgram(
                  0, "AX VL10000 AC100000\n# there and back\nLS3 MR1000 GO MR-1000 GO LE\nAY MA500 GO ID\n"))
          .state,
      IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  EXPECT_EQ(now().program.run, RunState::running);
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(now().program.ended_by, EndedBy::target);
  EXPECT_EQ(axis(0).position, Steps(0));
  EXPECT_EQ(axis(1).position, Steps(500));
}

TEST_F(Vme58Driver, AProgramThatIsLongerThanTheQueueIsFedAsThereIsRoom) {
  std::string text = "AX VL20000 AC1000000\n";
  for (int i = 0; i < 300; ++i) text += "MR10 GO\n";
  ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  ASSERT_TRUE(becomes_idle(Seconds(120)));
  EXPECT_EQ(axis(0).position, Steps(3000));
}

TEST_F(Vme58Driver, AProgramWithARejectedCommandStopsAndNamesTheLine) {
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX VL1000 MR100000 GO\nAY\nLE\nAZ MR500 GO\n")).state,
            IntentState::done);
  perform(intent::RunProgram(0));
  ASSERT_TRUE(becomes_idle());
  EXPECT_THAT(reported(), HasSubstr("Line 3: the board rejected \"LE\""));
  EXPECT_EQ(axis(2).position, Steps(0));
  EXPECT_LT(axis(0).position, Steps(5000));
}

TEST_F(Vme58Driver, ATextWhileAProgramIsFedLeavesTheProgramItsAxis) {
  std::string text = "AY LP0 VL1000 AC100000\n";
  for (int i = 0; i < 4; ++i) text += "MR300 GO ID WQ\n";
  ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  run(Millis(400));
  ASSERT_TRUE(now().feed.running);
  (void)query("AX RP");
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(1).position, Steps(1200));
  EXPECT_EQ(axis(0).position, Steps(0));
  ASSERT_TRUE(query("MR50 GO"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(50)) << "the user has selected X, and that stays";
}

TEST_F(Vme58Driver, AQueryBetweenTwoPartsOfAProgramIsAnswered) {
  std::string text = "AY LP0 VL20000 AC1000000\n";
  for (int i = 0; i < 300; ++i) text += "MR10 GO\n";
  ASSERT_EQ(perform(intent::LoadProgram(0, text)).state, IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  for (int i = 0; i < 20 && now().feed.running; ++i) (void)query("AX RP");
  ASSERT_TRUE(becomes_idle(Seconds(120)));
  EXPECT_EQ(axis(1).position, Steps(3000));
  EXPECT_EQ(axis(0).position, Steps(0));
  EXPECT_EQ(now().program.ended_by, EndedBy::target);
}

TEST_F(Vme58Driver, AContourOfTheUsersIsNotBegunWhileAProgramIsFed) {
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX VL1000 MR1000 GO ID WQ\nMR-500 GO ID\n")).state,
            IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  run(Millis(300));
  ASSERT_TRUE(now().feed.running);
  const auto refused = query("AA CV1000 CD0,0;");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().sentence(), HasSubstr("A program is being sent"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(500));
}

TEST_F(Vme58Driver, AMoveOfAnOpenServoLoopReportsHowToCloseIt) {
  ASSERT_TRUE(query("AX HF"));
  const IntentOutcome outcome = perform(intent::MoveBy({{AxisId{0}, Steps(100)}}));
  EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("servo loop of axis X is open"));
  EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("HN"));
  ASSERT_EQ(perform(intent::LoadProgram(0, "AX MR100 GO ID\n")).state, IntentState::done);
  perform(intent::RunProgram(0));
  ASSERT_TRUE(becomes_idle());
  EXPECT_THAT(reported(), HasSubstr("servo loop of axis X is open"));
}

TEST_F(Vme58Driver, AContourIsCutByAProgram) {
  ASSERT_EQ(
      perform(intent::LoadProgram(0,
                                  "AA\nCV20000\nCD,,0,0;\nAN0;\nCR0,5000,3.1415926\nCR0,0,6.2831853\nAF0;\n"
                                  "MT-10,10000\nCE\nMT,,-1000,0; GO\nCX\n"))
          .state,
      IntentState::done);
  ASSERT_EQ(perform(intent::RunProgram(0)).state, IntentState::done);
  std::int64_t lowest = 0, highest = 0;
  ASSERT_TRUE(run_until(
      [&] {
        lowest = std::min(lowest, axis(2).position.value);
        highest = std::max(highest, axis(2).position.value);
        return now().program.run == RunState::idle;
      },
      Seconds(60)));
  EXPECT_EQ(now().program.ended_by, EndedBy::target);
  EXPECT_NEAR(static_cast<double>(lowest), -10000, 60);
  EXPECT_NEAR(static_cast<double>(highest), 10000, 60);
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{2}, Steps(0)}})).state, IntentState::done)
      << "the recording has ended";
}

TEST_F(Vme58Driver, WhileAContourIsRecordedTheConsoleSendsNothingOfItsOwn) {
  ASSERT_TRUE(query("AA CV1000 CD0,0;"));
  const IntentOutcome outcome = perform(intent::MoveTo({{AxisId{0}, Steps(400)}}));
  EXPECT_EQ(outcome.state, IntentState::refused);
  EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("contour is being recorded"));
  ASSERT_TRUE(query("MT100,0 CE"));
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(400)}})).state, IntentState::done);
}

TEST_F(Vme58Driver, TheWindowsImageAndQueuesAreReadWhileWatched) {
  session->send(intent::Watch(0x7));
  ASSERT_TRUE(query("AX VL100 MR1000000 GO WT5 WT6"));
  run(Seconds(2));
  EXPECT_TRUE(now().window.rings_known);
  EXPECT_EQ(now().window.value(vme58::reg::status, 1) & vme58::status::initialized,
            vme58::status::initialized);
  EXPECT_EQ(now().queue_known, 0xFFu);
  EXPECT_LT(now().queue_free[0], 200);
  EXPECT_EQ(now().queue_free[1], 200);
  EXPECT_EQ(now().window.value(vme58::offset_of(0, vme58::AxisValue::maximum_velocity), 4), 100u);
}

class Vme58DriverOfStepAxes : public Vme58Rig {
 protected:
  Vme58DriverOfStepAxes() : Vme58Rig({{"variant", "8"}}) {}
};
TEST_F(Vme58DriverOfStepAxes, TheUsersAxisIsTheSameAfterALostLink) {
  ASSERT_TRUE(query("AY VL1000 AC1000000"));
  for (int goes_ms = 100; goes_ms < 200; goes_ms += 20) {
    ASSERT_TRUE(query("MR3000 GO"));
    run(Millis(goes_ms));
    operate(bench::Unplug(true));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, Seconds(20)));
    operate(bench::Unplug(false));
    ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(20)));
    ASSERT_TRUE(query("MR777 GO"));
    ASSERT_TRUE(becomes_idle());
  }
  EXPECT_EQ(axis(0).position, Steps(0));
  EXPECT_EQ(axis(1).position, Steps(5 * 3777));
}
TEST_F(Vme58DriverOfStepAxes, AfterALossOfPowerItIsTheBoardsOwn) {
  ASSERT_TRUE(query("AY VL1000 AC1000000"));
  operate(bench::Unplug(true));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, Seconds(20)));
  operate(bench::PowerCycle());
  run(Seconds(1));
  operate(bench::Unplug(false));
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(20)));
  EXPECT_EQ(now().restarts, 1u);
  ASSERT_TRUE(query("MR777 GO"));
  ASSERT_TRUE(becomes_idle());
  EXPECT_EQ(axis(0).position, Steps(777));
  EXPECT_EQ(axis(1).position, Steps(0));
}

class Vme58OfOtherJumpers : public Vme58Rig {
 protected:
  Vme58OfOtherJumpers() { board_is.emplace()["jumpers"] = "OII"; }
};
TEST_F(Vme58OfOtherJumpers, LinesThatGoAnotherWayThanIsShownAreReported) {
  EXPECT_THAT(reported(), HasSubstr("Open the board with jumpers=OII in its address"));
}
TEST_F(Vme58Driver, LinesThatGoAsShownAreNotReported) {
  EXPECT_THAT(reported(), testing::Not(HasSubstr("jumpers")));
}

class Vme58Driver4s4 : public Vme58Rig {
 protected:
  Vme58Driver4s4() : Vme58Rig({{"variant", "4s4"}}) {}
};
TEST_F(Vme58Driver4s4, ItsStepAxesHaveNoEncoderAndNoGains) {
  EXPECT_TRUE(axis(0).has_encoder);
  EXPECT_FALSE(axis(4).has_encoder);
  EXPECT_GE(session->catalog().find_param("KPX"), 0);
  EXPECT_LT(session->catalog().find_param("KPU"), 0);
  EXPECT_EQ(perform(intent::SetPower(4, false)).state, IntentState::refused);
}

// KL ends the pulses; a step motor goes on by its mass, a servo motor's encoder counts that.
TEST_F(Vme58Driver4s4, KilledAtSpeedAStepAxisMayStandElsewhere) {
  const auto kill_at = [this](double speed) {
    for (const std::uint8_t i : {0, 4}) perform(intent::JogStart(AxisId{i}, Sign::plus, Pps{speed}, false));
    run(Millis(500));
    EXPECT_EQ(perform(intent::Abort()).state, IntentState::done);
    ASSERT_TRUE(becomes_idle());
  };
  ASSERT_EQ(perform(intent::SetParam("VBU", 2000, true)).state, IntentState::done);
  kill_at(1000);
  EXPECT_FALSE(axis(4).trust.doubtful()) << "so fast it may start without a ramp, so it may stop";
  kill_at(5000);
  EXPECT_EQ(axis(4).trust.cause, Doubt::killed);
  EXPECT_FALSE(axis(0).trust.doubtful());
  EXPECT_THAT(
      reported(),
      HasSubstr(
          "Axis U may have lost steps: it was stopped without a ramp at 5000 counts/s, above 2000 (VB)"));
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{4}, Steps(0)}})).state, IntentState::refused);
  EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(0)}})).state, IntentState::done);
}

}  // namespace
}  // namespace hw
