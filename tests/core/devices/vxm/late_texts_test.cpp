// Questions of more than one letter (set-up, programs, which of them is selected), with the answer to one of
// them late, lost, doubled or merged with the next: what is shown, and what is read for the user, is what the
// controller holds, or not known, or told to have failed.
#include "tests/core/device/late_line.h"
#include "tests/core/devices/vxm/driver_fixture.h"

namespace hw::vxm {
namespace {

enum class Trouble { late, very_late, lost, doubled, merged };

/// A line on which the answer to one question goes wrong, once.
class OneBadAnswer final : public test::LateLine {
 public:
  using LateLine::LateLine;
  std::string question;  ///< its end; empty: nothing goes wrong any more
  Trouble how{};

  void receive(std::string_view bytes) override {
    for (const char c : bytes) {
      inner_->receive(std::string_view(&c, 1));
      received_ += c;
      if (!question.empty() && received_.ends_with(question)) awaited_ = true;
    }
  }
  void take_output(std::string& sink) override {
    std::string answer;
    inner_->take_output(answer);
    if (!answer.empty()) pass(std::move(answer));
    LateLine::take_output(sink);
  }

 private:
  void pass(std::string answer) {
    answer = std::exchange(held_, {}) + answer;
    if (!std::exchange(awaited_, false)) return send(std::move(answer));
    question.clear();
    switch (how) {
      case Trouble::late: return send(std::move(answer), Millis(350));
      case Trouble::very_late: return send(std::move(answer), Millis(2000));
      case Trouble::lost: return;
      case Trouble::doubled: return send(answer + answer);
      case Trouble::merged: held_ = std::move(answer);
    }
  }

  std::string received_, held_;
  bool awaited_ = false;
};

struct LateText {
  const char* name;
  const char* question;
  Trouble how;
};
std::ostream& operator<<(std::ostream& out, const LateText& row) { return out << row.name; }

class VxmLateTexts : public DriverTest, public testing::WithParamInterface<LateText> {
 protected:
  static constexpr const char* first = "S1M1500\nI1M700\nP5\nI1M-300\n";
  static constexpr const char* second = "I2M1200\nI2M-1200\nL4\n";

  void start() {
    auto owned = std::make_unique<OneBadAnswer>(make_emulator({}).value());
    line = owned.get();
    line->how = GetParam().how;
    loop = std::make_unique<test::Loopback>(time, std::move(owned), false);
    open();
    ASSERT_EQ(perform(intent::LoadProgram(1, first)), "");
    ASSERT_EQ(perform(intent::LoadProgram(3, second)), "");
    ASSERT_EQ(perform(intent::SelectProgram(3)), "");
    for (const auto& [mnemonic, value] : {std::pair{"M1M", 4}, {"M2M", 6}})
      ASSERT_EQ(perform(intent::SetParam(mnemonic, value, true)), "");
    ASSERT_EQ(perform(intent::ReadParams()), "");
    ASSERT_EQ(perform(intent::ReadAgain()), "");
    run(2);
    notices.clear();
    truth = latest;
  }
  void expect_truth() {
    for (std::size_t i = 0; i < catalog.params.size(); ++i)
      ASSERT_TRUE(!latest.params[i].known || latest.params[i].value == truth.params[i].value)
          << catalog.params[i].mnemonic << " is shown as " << latest.params[i].value;
    for (std::size_t i = 0; i < latest.slot_bytes_used.size(); ++i)
      ASSERT_TRUE(latest.slot_bytes_used[i] < 0 || latest.slot_bytes_used[i] == truth.slot_bytes_used[i])
          << "program " << i;
    ASSERT_TRUE(latest.program.slot < 0 || latest.program.slot == 3) << int{latest.program.slot};
    ASSERT_EQ(latest.slots_torn, 0);
    ASSERT_EQ(latest.restarts, 0u);
    for (const Notice& notice : notices)
      if (notice.kind == Notice::Kind::program) {
        ASSERT_EQ(notice.text, notice.slot == 1 ? first : second) << "program " << notice.slot;
      }
  }

  OneBadAnswer* line = nullptr;
  Snapshot truth;
};

TEST_P(VxmLateTexts, AreNeverShownAsAnothers) {
  start();
  const std::vector<IntentBody> readings{intent::ReadParams(), intent::UploadProgram(1), intent::ReadAgain(),
                                         intent::UploadProgram(3)};
  for (const IntentBody& reading : readings) {
    line->question = GetParam().question;
    post(reading);
    for (int ms = 0; ms < 6000; ms += 10) {
      run(0.01);
      expect_truth();
      if (HasFatalFailure()) return;
    }
  }
  line->question.clear();
  EXPECT_EQ(latest.link.state, LinkState::good);
  EXPECT_EQ(perform(intent::UploadProgram(1), 10), "");
  expect_truth();
  EXPECT_EQ(query("PM"), "3") << "the user's choice";
}

std::vector<LateText> late_texts() {
  std::vector<LateText> all;
  for (const auto how : {Trouble::late, Trouble::very_late, Trouble::lost, Trouble::doubled, Trouble::merged})
    for (const auto& [name, question] : {std::pair{"which_program", "PM\r"},
                                         {"listing", "lst"},
                                         {"room", "M"},
                                         {"motor_type", "getM1M\r"},
                                         {"set_up", "getD0\r"}})
      all.push_back({name, question, how});
  return all;
}

std::string name_of_text(const testing::TestParamInfo<LateText>& info) {
  constexpr const char* hows[] = {"late", "very_late", "lost", "doubled", "merged"};
  return std::string(hows[static_cast<int>(info.param.how)]) + "_" + info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Every, VxmLateTexts, testing::ValuesIn(late_texts()), name_of_text);

}  // namespace
}  // namespace hw::vxm
