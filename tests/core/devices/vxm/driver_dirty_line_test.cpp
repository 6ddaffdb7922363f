// Answers that come late, shifted, doubled, merged or behind an echo: what is shown is the truth or not
// known, never the answer to another question.
#include <utility>

#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/reply_kinds.h"
#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

// ---- which question may be asked

struct Owed {
  const char* of;
  std::vector<ReplyKind> looks;
  const char* asked;  ///< empty: nothing
};

TEST(VxmLooks, OutstandingRepliesDecideWhichQuestionMayBeAsked) {
  const Instant now{};
  const std::vector<Owed> table = {
      {"X", {reply_kind::position}, "V"},
      {"PM", {reply_kind::number}, "V"},
      {"getD0", {reply_kind::text}, "V"},
      {"?", {reply_kind::raw}, "V"},
      {"K", {reply_kind::prompt}, "V"},
      {"lst", {reply_kind::lines}, "X"},
      {"V", {reply_kind::letter}, "X"},
      {"V X", {reply_kind::letter, reply_kind::position}, "@"},
      {"V X @", {reply_kind::letter, reply_kind::position, reply_kind::number}, "V"},
      {"lst X", {reply_kind::lines, reply_kind::position}, "getD0"},
      {"anything", {ReplyKind::any}, ""},
  };
  for (const Owed& row : table) {
    OutstandingReplies outstanding;
    for (const ReplyKind one : row.looks) outstanding.add(one, now);
    const auto asked = unmistakable(outstanding, now, Listening(), false);
    EXPECT_EQ(asked ? asked->question.bytes : "", row.asked) << row.of;
  }
}

TEST(VxmLooks, OnlyKIsTakenInAnErrorAndOnlyVInLocalMode) {
  const Instant now{};
  OutstandingReplies outstanding;
  outstanding.add(reply_kind::position, now);
  Listening listening;
  listening.halted = true;
  EXPECT_FALSE(unmistakable(outstanding, now, listening, false));
  listening.halted = false;
  listening.local = true;
  EXPECT_EQ(unmistakable(outstanding, now, listening, false)->question.bytes, "V");
  outstanding.add(reply_kind::letter, now);
  EXPECT_FALSE(unmistakable(outstanding, now, listening, false));
}

TEST(VxmLooks, ALateAnswerOfTheSameQuestionIsLetPass) {
  Instant now{};
  OutstandingReplies outstanding;
  const auto given_up = [&](std::initializer_list<ReplyKind> looks) {
    outstanding.clear();
    for (const ReplyKind one : looks) outstanding.add(one, now += Millis(200));
  };
  const auto accepted_behind = [&](std::string_view received) {
    const auto asked = unmistakable(outstanding, now, Listening(), false);
    std::size_t at = 0;
    while (at < received.size()) {
      const std::size_t unsolicited_length = asked->question.unsolicited_length(received.substr(at));
      if (unsolicited_length == 0) return received.substr(at);
      if (unsolicited_length == std::string_view::npos) break;
      at += unsolicited_length;
    }
    return std::string_view();
  };
  given_up({reply_kind::letter, reply_kind::position, reply_kind::number});
  EXPECT_EQ(accepted_behind("R"), "") << "it may be that of the first";
  EXPECT_EQ(accepted_behind("BR"), "R");
  EXPECT_EQ(accepted_behind("+0000400\rR"), "R");
  EXPECT_EQ(accepted_behind("B+0000400\r512\rR"), "R");
  EXPECT_EQ(accepted_behind("J"), "J") << "in Local mode nothing else is answered";
  given_up({reply_kind::position, reply_kind::letter, reply_kind::number});
  EXPECT_EQ(accepted_behind("+0000400\rR"), "") << "that line was asked for before";
  EXPECT_EQ(accepted_behind("+0000400\rR512\rB"), "B");
  outstanding.tear(now);
  EXPECT_EQ(accepted_behind("400\rR"), "") << "the end of a position";
}

TEST(VxmLooks, TheEndOfATornAnswerIsNoNumber) {
  const Instant now{};
  OutstandingReplies outstanding;
  for (const ReplyKind one : {reply_kind::letter, reply_kind::position}) outstanding.add(one, now);
  EXPECT_EQ(unmistakable(outstanding, now, Listening(), false)->question.bytes, "@");
  outstanding.tear(now);
  EXPECT_EQ(unmistakable(outstanding, now, Listening(), false)->question.bytes, "V");
}

// ---- what is shown

/// A controller that answers each question by what only it can be answered by, and a wire between that is bad
/// for one of them.
struct BadAnswer {
  enum class How : std::uint8_t { late, very_late, lost, doubled, merged, echoed } how;
  char question;
};

class VxmDirtyLine : public DriverTest, public testing::WithParamInterface<BadAnswer> {
 protected:
  static constexpr std::int64_t here = 1200, there = -3400;

  void expect_truth(const char* when) {
    const AxisState &first = latest.axes[0], &second = latest.axes[1];
    EXPECT_TRUE(!first.position_known || first.position.value == here) << when << first.position.value;
    EXPECT_TRUE(!second.position_known || second.position.value == there) << when << second.position.value;
    for (const AxisState* axis : {&first, &second})
      EXPECT_FALSE(axis->limits_known && (axis->limit_minus || axis->limit_plus)) << when;
    EXPECT_TRUE(!latest.inputs_known || latest.inputs == 0xFFu) << when << latest.inputs;
    EXPECT_TRUE(!latest.outputs_known || latest.outputs == 0b0101u) << when << latest.outputs;
    EXPECT_TRUE(!latest.analog_known || latest.analog[0] == 512) << when << latest.analog[0];
    EXPECT_EQ(latest.restarts, 0u) << when;
  }

  void make_it_bad(const BadAnswer& bad) {
    using How = BadAnswer::How;
    struct State {
      std::string held;
      bool done = false;
    };
    loop->on_its_way = [bad, state = State()](char sentence, std::string answer) mutable {
      if (bad.how == How::echoed) return test::Loopback::OnItsWay{sentence + answer};
      answer = std::exchange(state.held, {}) + answer;
      if (state.done || sentence != bad.question || answer.empty()) return test::Loopback::OnItsWay{answer};
      state.done = true;
      switch (bad.how) {
        case How::late: return test::Loopback::OnItsWay{answer, Millis(350)};
        case How::very_late: return test::Loopback::OnItsWay{answer, Millis(2000)};
        case How::lost: return test::Loopback::OnItsWay{};
        case How::doubled: return test::Loopback::OnItsWay{answer + answer};
        case How::merged: state.held = std::move(answer); break;
        case How::echoed: break;
      }
      return test::Loopback::OnItsWay{};
    };
  }
};

TEST_P(VxmDirtyLine, ShowsTheTruthOrNothing) {
  start();
  ASSERT_EQ(move_to(0, here), "");
  ASSERT_TRUE(wait_idle());
  ASSERT_EQ(move_to(1, there), "");
  ASSERT_TRUE(wait_idle());
  for (const int output : {1, 3}) ASSERT_EQ(perform(intent::SetOutput(output, true)), "");
  run(1);
  expect_truth("before");
  make_it_bad(GetParam());
  for (int i = 0; i < 600; ++i) {
    run(0.01);
    expect_truth("while it is bad");
  }
  const bool for_ever = GetParam().how == BadAnswer::How::echoed;
  EXPECT_EQ(latest.link.state == LinkState::good, !for_ever);
  EXPECT_EQ(latest.axes[1].limits_known && latest.inputs_known && latest.outputs_known, !for_ever);
}

std::vector<BadAnswer> all_bad_answers() {
  std::vector<BadAnswer> all;
  for (const auto how : {BadAnswer::How::late, BadAnswer::How::very_late, BadAnswer::How::lost,
                         BadAnswer::How::doubled, BadAnswer::How::merged})
    for (const char question : std::string_view("VXY?~$@")) all.push_back({how, question});
  all.push_back({BadAnswer::How::echoed, 'V'});
  return all;
}

std::string name_of(const testing::TestParamInfo<BadAnswer>& info) {
  constexpr const char* hows[] = {"late", "very_late", "lost", "doubled", "merged", "echoed"};
  constexpr std::string_view questions = "VXY?~$@";
  constexpr const char* names[] = {"V", "X", "Y", "limits", "inputs", "outputs", "analog"};
  return std::string(hows[static_cast<int>(info.param.how)]) + "_" +
         names[questions.find(info.param.question)];
}

INSTANTIATE_TEST_SUITE_P(Every, VxmDirtyLine, testing::ValuesIn(all_bad_answers()), name_of);

// ---- a line on which every answer comes late

class VxmSlowLine : public DriverTest {
 protected:
  void answer_late_by(Duration late) {
    loop->on_its_way = [late](char, std::string answer) {
      return test::Loopback::OnItsWay{answer, answer.empty() ? Duration::zero() : late};
    };
  }
};

TEST_F(VxmSlowLine, WorksSlowlyAndIsNotLost) {
  start();
  ASSERT_EQ(move_to(0, 700), "");
  ASSERT_TRUE(wait_idle());
  answer_late_by(std::chrono::seconds(2));
  for (int i = 0; i < 900; ++i) {
    run(0.1);
    ASSERT_NE(latest.link.state, LinkState::lost) << "after " << i / 10 << " s: " << health();
    ASSERT_EQ(latest.axes[0].position.value, 700);
  }
  const IntentId move = post(intent::MoveTo(target(0, 1500)));
  EXPECT_TRUE(run_until([&] { return latest.axes[0].position.value == 1500; }, 120)) << all_notices();
  EXPECT_EQ(outcome(move), IntentState::done);
  EXPECT_EQ(latest.link.state, LinkState::good);
  answer_late_by(Duration::zero());
  run(20);
  EXPECT_TRUE(latest.inputs_known && latest.axes[0].limits_known);
  EXPECT_GT(latest.link.polls_per_second, 2) << "as fast again as it was";
}

TEST_F(VxmSlowLine, IsOpened) {
  loop = std::make_unique<test::Loopback>(time, make_emulator({}).value(), false);
  answer_late_by(Millis(500));
  open();
  EXPECT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 60)) << health();
}

}  // namespace
}  // namespace hw::vxm
