// The driver against the transcripts of the data sheet: each text is said through the console, and what the
// console makes of the replies must be what the transcript has between its frames. And against a board whose
// reads are wrong: that is said, nothing wrong is shown, and it heals.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include "core/devices/vme58/facts.h"
#include "tests/core/devices/vme58/driver_rig.h"
#include "tests/talk/talk.h"

namespace hw {
namespace {

using test::Seconds;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// ---- transcripts

talk::Transcript transcript_called(const std::string& name) {
  return talk::read(HW_TEST_DIR "/talk/vme58/" + name + ".talk").value();
}
DeviceOptions options_of(const std::string& name) {
  const auto transcript = transcript_called(name);
  return DeviceOptions(transcript.options.begin(), transcript.options.end());
}
std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

class Vme58DriverTalk : public test::Vme58Rig, public testing::WithParamInterface<std::string> {
 protected:
  Vme58DriverTalk() : Vme58Rig(options_of(GetParam())) {}

  /// Word by word: the console ends a text at the command that the board rejects, a transcript goes on.
  void send_words(const std::string& text) {
    for (const std::string& word : words_of(text)) {
      const auto reply = query(word);
      if (!reply) {
        failed.push_back(word);
        again = word;
      } else if (!reply->empty()) {
        std::istringstream lines(*reply);
        for (std::string line; std::getline(lines, line);) received.push_back(line);
      }
    }
  }
  void expect(const talk::Step& step) {
    std::string wanted = step.bytes;
    std::erase_if(wanted, [](char c) { return c == '\n' || c == '\r'; });
    if (wanted.empty()) {
      EXPECT_THAT(received, IsEmpty()) << "line " << step.line;
      return;
    }
    if (received.empty() && !again.empty())
      send_words(std::exchange(again, {}));  // it was held back and not answered
    ASSERT_FALSE(received.empty()) << "line " << step.line << ": no " << wanted;
    EXPECT_PRED2([this](const std::string& a, const std::string& b) { return same(a, b); }, received.front(),
                 wanted)
        << "line " << step.line;
    received.erase(received.begin());
  }
  /// While axes move the console asks a moment later.
  bool same(const std::string& got, const std::string& wanted) const {
    if (got.size() != wanted.size() && !now().any_axis_moving()) return false;
    if (got == wanted) return true;
    if (!now().any_axis_moving()) return false;
    std::istringstream a(got), b(wanted);
    constexpr long moment = 50;  // counts, at 5,000 counts/s
    for (std::string x, y; std::getline(b, y, ',');)
      if (!std::getline(a, x, ',') || std::labs(std::stol(x) - std::stol(y)) > moment) return false;
    return true;
  }

  std::vector<std::string> received, failed;
  std::string again;
};

TEST_P(Vme58DriverTalk, InterpretsTheReplies) {
  const auto transcript = transcript_called(GetParam());
  bool echoes = false;
  for (const talk::Step& step : transcript.steps) {
    if (step.kind == talk::Step::Kind::send) {
      if (echoes) received.clear();  // the console keeps the echo off: of it the transcript alone tells
      echoes = step.bytes.starts_with("EN") || (echoes && !step.bytes.starts_with("UU"));
      if (!echoes) send_words(step.bytes);
    } else if (step.kind == talk::Step::Kind::expect && !echoes) {
      ASSERT_NO_FATAL_FAILURE(expect(step));
    } else if (step.kind == talk::Step::Kind::pass) {
      run(step.time);
    } else if (step.kind == talk::Step::Kind::bench) {
      for (const BenchCommand& hand : step.hands) operate(hand);
      run(Millis(50));
    }
  }
  EXPECT_THAT(received, IsEmpty());
  if (GetParam() == "start_up")
    EXPECT_THAT(failed, ElementsAre("EA", "KK2")) << "no encoder there; of other firmware";
  else if (GetParam() == "queue")
    EXPECT_THAT(failed, ElementsAre("WQ", "RP")) << "WQ holds back what follows";
  else
    EXPECT_THAT(failed, IsEmpty());
}

std::vector<std::string> all_transcripts() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(HW_TEST_DIR "/talk/vme58"))
    if (entry.path().extension() == ".talk") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}
INSTANTIATE_TEST_SUITE_P(Transcripts, Vme58DriverTalk, testing::ValuesIn(all_transcripts()),
                         [](const auto& info) { return info.param; });

// ---- reads that are wrong

class Vme58Liar : public test::Vme58Rig {
 protected:
  class LyingWindow final : public Window {
   public:
    LyingWindow(Vme58Liar& test, std::unique_ptr<Window> window) : test_(test), window_(std::move(window)) {}
    void listen(Listener* listener) override { window_->listen(listener); }
    [[nodiscard]] bool reports_interrupts() const override { return window_->reports_interrupts(); }
    [[nodiscard]] std::string describe() const override { return window_->describe(); }
    Task<Result<>> run(std::span<BusCycle> cycles) override {
      auto done = co_await window_->run(cycles);
      for (BusCycle& cycle : cycles)
        if (!cycle.write && test_.lie) test_.lie(cycle);
      co_return done;
    }

   private:
    Vme58Liar& test_;
    std::unique_ptr<Window> window_;
  };
  std::unique_ptr<Window> dressed(std::unique_ptr<Window> window) override {
    return std::make_unique<LyingWindow>(*this, std::move(window));
  }
  std::string sentence() const { return std::string(now().link.sentence.view()); }
  bool is_late() {
    return run_until([this] { return now().link.state == LinkState::late; }, Seconds(5));
  }
  void heals() {
    lie = nullptr;
    EXPECT_TRUE(run_until([this] { return now().link.state == LinkState::good; }, Seconds(20))) << sentence();
    EXPECT_EQ(axis(0).position, Steps(1234));
    EXPECT_EQ(perform(intent::MoveTo({{AxisId{0}, Steps(2000)}})).state, IntentState::done);
    ASSERT_TRUE(becomes_idle());
    EXPECT_EQ(axis(0).position, Steps(2000));
  }
  void SetUp() override {
    Vme58Rig::SetUp();
    ASSERT_TRUE(query("AX LP1234"));
    run(Seconds(1));
  }

  std::function<void(BusCycle&)> lie;
};

TEST_F(Vme58Liar, ABoardThatReadsAsOnesIsMissed) {
  lie = [](BusCycle& c) { c.value = 0xFFFFFFFFu >> (32 - 8 * c.width); };
  ASSERT_TRUE(is_late());
  EXPECT_THAT(sentence(), HasSubstr("every byte of the window reads FF"));
  EXPECT_EQ(axis(0).position, Steps(1234)) << "not minus one";
  ASSERT_TRUE(run_until([this] { return now().link.state == LinkState::lost; }, Seconds(20)));
  heals();
}

TEST_F(Vme58Liar, IndexesThatMakeNoSenseAreNotFollowed) {
  lie = [](BusCycle& c) {
    if (c.offset == vme58::at::output_get_index || c.offset == vme58::at::input_put_index) c.value = 0x1234;
  };
  ASSERT_TRUE(is_late());
  EXPECT_THAT(sentence(), HasSubstr("indexes of the rings are not valid"));
  const IntentOutcome outcome = perform(intent::MoveTo({{AxisId{0}, Steps(5)}}));
  EXPECT_NE(outcome.state, IntentState::done);
  EXPECT_THAT(std::string(outcome.sentence.view()), HasSubstr("1234"));
  heals();
}

TEST_F(Vme58Liar, ARecordingOfABoardThatMakesNoSenseEndsWithItsTime) {
  int rounds = 0;
  lie = [&rounds](BusCycle& c) {
    if (c.offset == vme58::at::output_get_index) c.value = 0x1234;
    rounds += c.offset == vme58::reg::status;
  };
  session->send(intent::Sample(AxisId{0}, Millis(300)));
  run(Seconds(10));
  EXPECT_GT(rounds, 10);
  EXPECT_LT(rounds, 8000) << "each round takes its time, and after the recording they are rare again";
  heals();
}

TEST_F(Vme58Liar, ACopyThatNeverComesLeavesPositionsAsTheyWere) {
  lie = [](BusCycle& c) {
    if (c.offset == vme58::reg::control) c.value |= vme58::control::update_data;
    if (c.offset == vme58::offset_of(0, vme58::AxisValue::command_position)) c.value = 99;
  };
  ASSERT_TRUE(is_late());
  EXPECT_THAT(sentence(), HasSubstr("did not copy its axis data in time"));
  EXPECT_EQ(axis(0).position, Steps(1234));
  heals();
}

TEST_F(Vme58Liar, AReplyThatIsNoStatusReportsNoEndOfTheTravel) {
  lie = [](BusCycle& c) {
    const bool reply =
        c.offset >= vme58::at::input_buffer && c.offset < vme58::at::input_buffer + 2 * vme58::ring_cells;
    if (reply && (c.value == 'P' || c.value == 'M')) c.value = '#';
  };
  operate(bench::Limit(AxisId{0}, Sign::plus, true));
  run(Seconds(2));
  EXPECT_FALSE(axis(0).limits_known);
  EXPECT_FALSE(axis(0).limit_minus);
  operate(bench::Limit(AxisId{0}, Sign::plus, false));
  run(Seconds(1));
  heals();
}

TEST_F(Vme58Liar, AnUnexplainedCommandErrorIsReported) {
  bool once = true;
  lie = [&once](BusCycle& c) {
    if (c.offset == vme58::reg::status && std::exchange(once, false)) c.value |= vme58::status::command_error;
  };
  (void)reported();
  run(Seconds(1));
  EXPECT_THAT(reported(), HasSubstr("reports a command error"));
  heals();
}

// The board may stand in the middle of a word then.
TEST_F(Vme58Liar, ACommandErrorOfWhatAStopHasTakenBackIsNotReported) {
  ASSERT_TRUE(query("AX VL20000 AC40000 MR1000000 GO"));
  run(Seconds(1));
  (void)reported();
  bool once = true;
  lie = [&once](BusCycle& c) {
    if (c.offset == vme58::reg::status && std::exchange(once, false)) c.value |= vme58::status::command_error;
  };
  EXPECT_EQ(perform(intent::Stop()).state, IntentState::done);
  EXPECT_FALSE(once);
  run(Seconds(1));
  EXPECT_EQ(reported(), "");
}

TEST_F(Vme58Liar, ADeviceThatIsNoVme58IsNotTakenForOne) {
  lie = [](BusCycle& c) {
    const bool reply =
        c.offset >= vme58::at::input_buffer && c.offset < vme58::at::input_buffer + 2 * vme58::ring_cells;
    if (reply && c.value == 'v') c.value = 'x';  // "VME58 xer 2.24"
  };
  operate(bench::Unplug(true));
  run(Seconds(1));
  operate(bench::Unplug(false));
  ASSERT_TRUE(
      run_until([this] { return sentence().find("is not a VME58") != std::string::npos; }, Seconds(20)))
      << sentence();
  EXPECT_EQ(now().link.state, LinkState::lost);
  heals();
}

}  // namespace
}  // namespace hw
