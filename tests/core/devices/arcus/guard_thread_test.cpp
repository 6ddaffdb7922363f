// What goes over the wire for the guard of held jogs: what it borrows it gives back, and what the user sets
// or another host runs is left alone.
#include <algorithm>

#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class GuardOnTheWire : public DriverTest {
 protected:
  void start_guarded(std::string_view model = "pmx-4ex-sa") {
    start(model);
    run(5);
    ASSERT_EQ(perform(intent::GuardJogs(true)), "");
    ASSERT_EQ(latest.jog_guard.state, JogGuard::State::installed);
    ASSERT_EQ(perform(intent::SetPower(0, true)), "");
    run(2);
    sent();
  }
  std::string jog() { return perform(intent::JogStart(AxisId{0}, Sign::plus)); }
  void let_go() {
    EXPECT_EQ(perform(intent::JogStop()), "");
    EXPECT_TRUE(wait_idle());
    run(2);
  }
  /// So often in rounds of status since the last call.
  int times_polled(std::string_view question) {
    int times = 0;
    traffic.drain([&](const TrafficEntry& e) {
      const bool asks = e.way == Way::sent && e.kind == TrafficKind::poll;
      times += asks && e.bytes.find(question) != e.bytes.npos ? 1 : 0;
    });
    return times;
  }
  /// The answer to each command on the line passes here.
  void on_the_way(std::function<std::string(const std::string& command, std::string answer)> change) {
    loop->on_its_way = [change = std::move(change), line = std::string()](char sentence,
                                                                          std::string answer) mutable {
      line += sentence;
      if (sentence != '\r') return test::Loopback::OnItsWay{std::move(answer)};
      const auto address = line.rfind('@');
      const std::string command = address == line.npos ? line : line.substr(address + 3);
      line.clear();
      return test::Loopback::OnItsWay{change(command.substr(0, command.size() - 1), std::move(answer))};
    };
  }
};

// Whoever finds V49 knows that TOC is to be put back.
TEST_F(GuardOnTheWire, AJogNamesItsAxisBeforeItTakesTheTimeOut) {
  start_guarded();
  ASSERT_EQ(jog(), "");
  const std::string begun = sent();
  EXPECT_LT(begun.find("V49=1"), begun.find("TOC=")) << begun;
  EXPECT_LT(begun.find("TOC="), begun.find("SR3=1")) << begun;
  EXPECT_LT(begun.find("SR3=1"), begun.find("J")) << begun;
  let_go();
  EXPECT_THAT(sent(), AllOf(HasSubstr("V49=0"), HasSubstr("TOC=0")));
}

TEST_F(GuardOnTheWire, NothingIsStoredOrTakenFromItWhileAJogIsHeld) {
  start_guarded();
  ASSERT_EQ(jog(), "");
  hold(3);
  sent();
  EXPECT_THAT(perform(intent::Store()), HasSubstr("is watching a jog"));
  hold(1);
  for (const char* text : {"STORE", "TOC=0", "SA0=END", "@00SA0=END"}) {
    EXPECT_THAT(query(text), HasSubstr("is watching a jog")) << text;
    hold(1);
  }
  EXPECT_THAT(sent(), AllOf(Not(HasSubstr("STORE")), Not(HasSubstr("TOC=")), Not(HasSubstr("SA0="))));
  EXPECT_EQ(latest.axes[0].activity, Activity::jogging);
  let_go();
  EXPECT_EQ(query("TOC"), "0");
  EXPECT_EQ(query("V49"), "0");
  EXPECT_EQ(perform(intent::Store()), "");
}

TEST_F(GuardOnTheWire, ATimeOutThatTheUserSetsStaysAndNoJogOverwritesIt) {
  start_guarded();
  ASSERT_EQ(query("TOC=5000"), "OK");
  sent();
  EXPECT_EQ(
      jog(),
      "TOC is 5000, and the guard in the controller would set it to 0 after each jog. The jog was not sent. "
      "Set TOC to 0, or remove the guard and install it again.");
  run(2);
  EXPECT_THAT(sent(), AllOf(Not(HasSubstr("SR3=1")), Not(HasSubstr("TOC="))));
  EXPECT_EQ(query("TOC"), "5000");
  ASSERT_EQ(perform(intent::GuardJogs(false)), "");
  ASSERT_EQ(perform(intent::GuardJogs(true)), "");
  ASSERT_EQ(jog(), "");
  let_go();
  EXPECT_EQ(query("TOC"), "5000");
}

TEST_F(GuardOnTheWire, ATrialOfTheTimeOutThatIsBrokenOffIsPutBack) {
  start("pmx-4ex-sa");
  run(5);
  sent();
  int lost = 0;
  on_the_way([&lost](const std::string& command, std::string answer) {
    const bool first = command.starts_with("TOC=") && lost == 0;
    lost += first ? 1 : 0;
    return first ? std::string() : answer;
  });
  EXPECT_NE(perform(intent::GuardJogs(true)), "");
  EXPECT_EQ(lost, 1);
  run(3);
  EXPECT_NE(latest.jog_guard.state, JogGuard::State::installed);
  EXPECT_THAT(sent(), AllOf(HasSubstr("TOC=0"), Not(HasSubstr("SA0="))));
  EXPECT_EQ(query("TOC"), "0");
}

TEST_F(GuardOnTheWire, ItsThreadIsAskedForWhileItIsNotAtWork) {
  start_guarded();
  run(5);
  EXPECT_GT(times_polled("SASTAT3"), 0) << "another host may run a program there";
  ASSERT_EQ(jog(), "");
  times_polled("");
  hold(10);
  EXPECT_EQ(latest.program.run, RunState::idle);
  EXPECT_EQ(times_polled("SASTAT3"), 0) << "it runs for the console alone";
  let_go();
  run(5);
  EXPECT_GT(times_polled("SASTAT3"), 0);
  EXPECT_EQ(latest.program.run, RunState::idle);
}

TEST_F(GuardOnTheWire, ASpoiltQuestionDoesNotHideIt) {
  start_guarded();
  int refused = 0;
  on_the_way([&refused](const std::string& command, std::string answer) {
    const bool first = command == "SA2" && refused == 0;
    refused += first ? 1 : 0;
    return first ? std::string("?SA2\r") : answer;
  });
  loop->pull();
  ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::lost; }, 10));
  ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 30));
  EXPECT_TRUE(run_until([&] { return latest.jog_guard.state == JogGuard::State::installed; }, 30));
  EXPECT_EQ(refused, 1);
}

TEST_F(GuardOnTheWire, AProgramOfAnyNumberTakesItsPlace) {
  start_guarded();
  EXPECT_EQ(perform(intent::LoadProgram(1, "PRG 1\nV1=7\nEND\n")), "");
  EXPECT_THAT(sent(), HasSubstr("SA0="));
  EXPECT_EQ(perform(intent::RunProgram(1)), "");
  run(1);
  EXPECT_EQ(query("V1"), "7");
}

}  // namespace
}  // namespace hw::arcus
