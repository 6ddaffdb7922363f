// What the driver makes of replies that are broken, come from somebody else or from another program's code:
// nothing wrong is shown, no motion is repeated, and a sentence says what came.
#include <functional>
#include <map>

#include "tests/core/device/emulator_around.h"
#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A controller that answers some questions in words of the test.
class Liar final : public test::EmulatorAround {
 public:
  using EmulatorAround::EmulatorAround;

  std::map<std::string, std::string, std::less<>> instead;  ///< by command without address, whole replies
  std::map<std::string, int, std::less<>> received;
  bool line_feeds = false;  ///< a serial server on the way writes CR LF

  void receive(std::string_view bytes) override {
    for (const char c : bytes) {
      inner_->receive(std::string_view(&c, 1));
      if (c != '\r') {
        line_ += c;
        continue;
      }
      const std::string line = std::exchange(line_, {});
      if (!line.starts_with('@')) continue;  // it ends what may have been cut off
      const std::string command = line.substr(3);
      ++received[command];
      std::string reply;
      inner_->take_output(reply);
      const auto lie = instead.find(command);
      sent_ += lie == instead.end() ? reply : lie->second;
      if (line_feeds && !sent_.empty()) sent_.back() = '\r', sent_ += '\n';
    }
  }
  void take_output(std::string& sink) override {
    sink += std::exchange(sent_, {});
    inner_->take_output(sink);
  }

 private:
  std::string line_, sent_;
};

struct BrokenReply {
  const char* name;
  std::string answer;
  const char* sentence;
};
std::ostream& operator<<(std::ostream& out, const BrokenReply& b) { return out << b.name; }

class BrokenReplies : public DriverTest, public testing::WithParamInterface<BrokenReply> {
 protected:
  void start(std::string_view model = "dmx-k-sa") {
    type = find_device_type(model);
    auto owned = std::make_unique<Liar>(type->make_emulator({}).value());
    liar = owned.get();
    loop = std::make_unique<test::Loopback>(time, std::move(owned), false);
    catalog = type->make_catalog({}).value();
    open();
    ASSERT_EQ(latest.link.state, LinkState::good);
  }
  std::string sentence() { return std::string(latest.link.sentence.view()); }
  Liar* liar = nullptr;
};

TEST_P(BrokenReplies, AreReportedAndNeverShownAndHeal) {
  start();
  ASSERT_EQ(perform(intent::SetPosition(0, Steps(1234))), "");
  liar->instead["EX"] = GetParam().answer;
  liar->instead["PX"] = GetParam().answer;
  for (int i = 0; i < 40 && latest.link.state == LinkState::good; ++i) run(0.05);
  EXPECT_EQ(latest.link.state, LinkState::late);
  EXPECT_THAT(sentence(), HasSubstr(GetParam().sentence));
  EXPECT_EQ(latest.axes[0].position, Steps(1234));
  liar->instead.clear();
  run(8);
  EXPECT_EQ(latest.link.state, LinkState::good) << sentence();
  EXPECT_EQ(sentence(), "");
  EXPECT_EQ(latest.axes[0].position, Steps(1234));
}

std::string ended(std::string text) { return text + '\0'; }

INSTANTIATE_TEST_SUITE_P(
    Of, BrokenReplies,
    testing::Values(
        BrokenReply{"TooManyNumbers", ended("1:2:3"),
                    "answered 1:2:3 to PX, which is not a valid reply. It was asked twice."},
        BrokenReply{"NoNumber", ended("12x"), "answered 12x to PX, which is not a valid reply"},
        BrokenReply{"Nothing", ended(""), "answered with an empty text to PX, which is not a valid reply"},
        BrokenReply{"Unprintable", ended("\x01\xFE"), "answered <01><FE> to PX, which is not a valid reply"},
        BrokenReply{"TooManyDigits", ended("99999999999999999999"),
                    "99999999999999999999 to PX, which is not a valid reply"},
        BrokenReply{"AnOkToAQuestion", ended("OK"), "answered OK to PX, which is not a valid reply"},
        BrokenReply{"ARefusal", ended("?PX"), "refused PX with ?PX"},
        BrokenReply{"OfAnotherDevice", ended("#050"), "Device 01 was asked PX, and device 05 answered."},
        BrokenReply{"WithoutItsEnd", "123", "stopped in the middle"},
        BrokenReply{"WithoutEnd", std::string(5000, 'Z'), "stopped in the middle"}),
    [](const auto& info) { return std::string(info.param.name); });

class OneReply : public BrokenReplies {
 protected:
  /// Something is wrong from the first question on.
  void meet(std::string_view model, const std::function<void(Liar&)>& wrong) {
    type = find_device_type(model);
    auto owned = std::make_unique<Liar>(type->make_emulator({}).value());
    wrong(*owned);
    loop = std::make_unique<test::Loopback>(time, std::move(owned), byte_times);
    catalog = type->make_catalog({}).value();
    open();
  }
  bool byte_times = false;
};

TEST_F(OneReply, LineFeedsBehindTheAnswersAreReported) {
  for (const bool slow : {false, true}) {
    byte_times = slow;
    for (const std::string_view model : {"dmx-k-sa", "pmx-4ex-sa"}) {
      meet(model, [](Liar& device) { device.line_feeds = true; });
      EXPECT_NE(latest.link.state, LinkState::good);
      EXPECT_THAT(sentence(), HasSubstr("end in CR LF")) << model << slow;
      TearDown();
    }
  }
}

TEST_F(OneReply, ANameThatIsNotItsAddressIsReported) {
  meet("dmx-k-sa", [](Liar& device) { device.instead["DN"] = ended("DMK07"); });
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_TRUE(reported("The device answers at 01, but its name is set to DMK07: it will answer at 07"));
  TearDown();
  meet("dmx-k-sa", [](Liar& device) { device.instead["DN"] = ended("STAGE"); });
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_TRUE(reported("it answers at 01 and calls itself "));
  EXPECT_TRUE(reported("where a DMX-K-SA calls itself DMK01"));
}

TEST_F(OneReply, OnceIsForgiven) {
  start();
  const int before = liar->received["PX"];
  liar->instead["PX"] = ended("12x");
  ASSERT_TRUE(run_until([&] { return liar->received["PX"] == before + 1; }, 5));
  liar->instead.clear();  // the question is asked once more
  for (int i = 0; i < 40; ++i) {
    run(0.05);
    EXPECT_EQ(latest.link.state, LinkState::good) << sentence();
  }
  EXPECT_GT(liar->received["PX"], before + 1);
}

TEST_F(OneReply, ACommandThatIsAnsweredWithNonsenseIsSentOnce) {
  start();
  run(3);
  liar->instead["HSPD=5000"] = ended("NO");
  EXPECT_THAT(perform(intent::SetParam("HSPD", 5000)),
              HasSubstr("answered NO to HSPD=5000 instead of OK. It was sent once and is not repeated."));
  EXPECT_EQ(liar->received["HSPD=5000"], 1);
  liar->instead["X1000"] = ended("NO");
  EXPECT_THAT(perform(intent::MoveTo(targets({1000}))), HasSubstr("X1000"));
  EXPECT_EQ(liar->received["X1000"], 1);
}

TEST_F(OneReply, AStoredLineThatReadsBackWrongIsNamed) {
  start();
  liar->instead["SA1"] = ended("WAIT,Y");
  EXPECT_THAT(perform(intent::LoadProgram(0, "X400\nWAITX\nEND\n")),
              AllOf(HasSubstr("Line 1 reads back as \"WAIT,Y\" instead of \"WAIT,X\""),
                    HasSubstr("neither the old program nor the new one")));
  EXPECT_FALSE(latest.transfer.running);
}

TEST_F(OneReply, CodeOfAnotherProgramIsShownLineByLineAndReported) {
  start();
  ASSERT_EQ(perform(intent::LoadProgram(0, "X400\nWAITX\nV1=1\nEND\n")), "");
  ASSERT_EQ(query("SA1=17 4 0 FF"), "OK");
  ASSERT_EQ(perform(intent::UploadProgram(0)), "");
  EXPECT_THAT(program_text(), AllOf(HasSubstr("X400"), HasSubstr("17 4 0 FF"), HasSubstr("V1=1")));
  EXPECT_TRUE(reported("1 line of the stored code cannot be read here: line 1 (17 4 0 FF)."))
      << all_notices();
  EXPECT_TRUE(reported("If you send the text back unchanged, the controller loses it.")) << all_notices();
}

TEST_F(OneReply, ALineThatIsNoTextIsRefusedNotSwallowed) {
  start();
  liar->instead["SA0"] = ended("?SA0");
  EXPECT_THAT(perform(intent::UploadProgram(0)), HasSubstr("refused SA0 with ?SA0"));
}

TEST_F(OneReply, ARunOfForeignCodeStopsWithItsLine) {
  start();
  ASSERT_EQ(query("SA0=17 4 0 FF"), "OK");
  perform(intent::RunProgram(0));
  run(1);
  EXPECT_EQ(latest.threads[0].run, RunState::error);
  EXPECT_THAT(std::string(latest.notice.view()), HasSubstr("Program 0 stopped with an error at line 0"));
}

TEST_F(OneReply, AProgramForTheOtherModelIsRefusedWithItsLine) {
  start();
  EXPECT_THAT(perform(intent::LoadProgram(0, "U1000\nEND\n")), HasSubstr("error in line 1"));
}

// ---- a stop that cannot read the joystick

TEST_F(OneReply, WithoutTheStateOfTheJoystickAStopOfOneAxisLeavesItAndReportsIt) {
  start("pmx-4ex-sa");
  ASSERT_EQ(query("JE=3"), "OK");
  liar->instead["JE"] = "x\r";
  EXPECT_THAT(perform(intent::Stop(1)), HasSubstr("joystick"));
  liar->instead.clear();
  EXPECT_EQ(query("JE"), "3");
}

TEST_F(OneReply, WithoutTheStateOfTheJoystickAStopOfAllSwitchesItOffAndReportsIt) {
  start("pmx-4ex-sa");
  ASSERT_EQ(query("JE=3"), "OK");
  liar->instead["JE"] = "x\r";
  EXPECT_THAT(perform(intent::Stop()), HasSubstr("joystick"));
  liar->instead.clear();
  EXPECT_EQ(query("JE"), "0");
}

// ---- another program on the line

/// It asks the same controller again and again, and everybody hears the answers.
class Received final : public test::EmulatorAround {
 public:
  Received(std::unique_ptr<Emulator> inner, Duration period)
      : EmulatorAround(std::move(inner)), period_(period) {}
  [[nodiscard]] std::optional<Instant> next_event() const override {
    const auto next = inner_->next_event();
    return next ? std::min(*next, asks_at_) : asks_at_;
  }
  void advance_to(Instant now) override {
    inner_->advance_to(now);
    for (; asks_at_ <= now; asks_at_ += period_) inner_->receive("@01PX\r");
  }

 private:
  Duration period_;
  Instant asks_at_{};
};

TEST_F(DriverTest, WhereAnotherProgramAsksAllTheTimeConnectingEnds) {
  for (const int period : {5, 10, 20}) {
    type = find_device_type("dmx-k-sa");
    loop = std::make_unique<test::Loopback>(
        time, std::make_unique<Received>(type->make_emulator({}).value(), Millis(period)), false);
    catalog = type->make_catalog({}).value();
    open();
    EXPECT_EQ(latest.link.state, LinkState::lost) << period;
    EXPECT_THAT(std::string(latest.link.sentence.view()), HasSubstr("another program uses this line"));
    TearDown();
    latest = Snapshot();
  }
}

}  // namespace
}  // namespace hw::arcus
