// Each question of the driver, with its answer late, shifted by one, doubled, merged with the next, echoed:
// what is shown is the truth or not known, and never another question's answer.
#include <set>

#include "tests/core/device/late_line.h"
#include "tests/core/devices/arcus/driver_fixture.h"

namespace hw::arcus {
namespace {

enum class Mischief { late, very_late, shifted, doubled, merged, echoed };

/// A line on which the answer to one question goes wrong, once.
class BadLine final : public test::LateLine {
 public:
  using LateLine::LateLine;

  std::set<std::string> asked;
  std::string victim;  ///< without its address; empty: nothing goes wrong any more
  Mischief mischief{};

  void receive(std::string_view bytes) override {
    for (const char c : bytes) {
      inner_->receive(std::string_view(&c, 1));
      line_ += c;
      if (c == '\r') answer();
    }
  }

 private:
  void answer() {
    const std::string question = std::exchange(line_, {});
    if (!question.starts_with('@')) return;  // it ends what may have been cut off
    const std::string command = question.substr(3, question.size() - 4);
    asked.insert(command);
    std::string reply;
    inner_->take_output(reply);
    if (kept_ > 0 && --kept_ == 0) return send(std::exchange(held_, {}) + reply);
    if (kept_ > 0) return send(std::exchange(held_, std::move(reply)));
    if (command != victim) return send(std::move(reply));
    victim.clear();
    switch (mischief) {
      case Mischief::late: return send(std::move(reply), Millis(350));
      case Mischief::very_late: return send(std::move(reply), Millis(2500));
      case Mischief::shifted: kept_ = 6; break;
      case Mischief::merged: kept_ = 1; break;
      case Mischief::doubled: return send(reply + reply);
      case Mischief::echoed: return send(question + reply);
    }
    held_ = std::move(reply);
  }

  std::string line_, held_;
  int kept_ = 0;
};

struct Case {
  const char* model;
  Mischief mischief;
  const char* name;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.model << c.name; }

class LateAnswers : public DriverTest, public testing::WithParamInterface<Case> {
 protected:
  void start() {
    const bool dmx = std::string_view(GetParam().model) == "dmx-k-sa";
    type = find_device_type(GetParam().model);
    auto owned = std::make_unique<BadLine>(type->make_emulator({}).value());
    line = owned.get();
    line->mischief = GetParam().mischief;
    loop = std::make_unique<test::Loopback>(time, std::move(owned), false);
    catalog = type->make_catalog({}).value();
    open();
    ASSERT_EQ(latest.link.state, LinkState::good);
    std::vector<std::string> texts{"ACC=456", "V1=31", "V2=32", "V3=33", "DO=2"};
    const std::vector<std::string> of_dmx{"SL=0", "HSPD=4321", "LSPD=123", "PX=1111", "EX=2222"};
    const std::vector<std::string> of_pmx{"HS=4321", "LS=123",  "PX=1111", "PY=1112", "PZ=1113",
                                          "PU=1114", "EX=2221", "EY=2222", "EZ=2223", "EU=2224"};
    const auto& more = dmx ? of_dmx : of_pmx;
    texts.insert(texts.end(), more.begin(), more.end());
    for (const std::string& text : texts) ASSERT_EQ(query(text), "OK") << text;
    ASSERT_EQ(perform(intent::Watch(~0u)), "");
    ASSERT_EQ(perform(intent::ReadParams()), "");
    run(5);
    truth = latest;
    ASSERT_TRUE(truth.axes[0].position_known && truth.axes[0].limits_known && truth.inputs_known != 0);
    ASSERT_EQ(truth.axes[0].position, Steps(1111));
  }
  void expect_truth(const std::string& question) const {
    const Snapshot& now = latest;
    for (int a = 0; a < truth.axis_count; ++a) {
      const AxisState &shown = now.axes[a], &is = truth.axes[a];
      if (!shown.position_known) continue;
      ASSERT_EQ(shown.position, is.position) << question;
      ASSERT_EQ(shown.encoder, is.encoder) << question;
      ASSERT_EQ(shown.activity, is.activity) << question;
      ASSERT_EQ(shown.enabled, is.enabled) << question;
      ASSERT_EQ(shown.in_counts, is.in_counts) << question;
      ASSERT_FALSE(shown.limits_known && (shown.limit_minus || shown.limit_plus)) << question;
      ASSERT_EQ(shown.trust.kind, is.trust.kind) << question;
    }
    ASSERT_EQ((now.inputs ^ truth.inputs) & now.inputs_known, 0u) << question;
    ASSERT_EQ((now.outputs ^ truth.outputs) & now.outputs_known, 0u) << question;
    ASSERT_EQ(now.restarts, truth.restarts) << question;
    ASSERT_EQ(now.identity.serial, truth.identity.serial) << question;
    for (std::size_t i = 0; i < catalog.params.size(); ++i)
      ASSERT_TRUE(!now.params[i].known || now.params[i].value == truth.params[i].value)
          << question << " " << catalog.params[i].mnemonic;
    for (std::size_t i = 0; i < catalog.readouts.size(); ++i)
      ASSERT_TRUE(!now.readouts_known.test(i) || now.readouts[i] == truth.readouts[i])
          << question << " " << catalog.readouts[i].id;
    for (std::size_t i = 0; i < static_cast<std::size_t>(catalog.variables.count); ++i)
      ASSERT_TRUE(!now.variables_known.test(i) || now.variables[i] == truth.variables[i])
          << question << " V" << i;
    for (std::size_t i = 0; i < now.threads.size(); ++i)
      ASSERT_TRUE(!now.threads[i].known || now.threads[i].run == RunState::idle) << question;
  }
  bool is_param(const std::string& question) const { return catalog.find_param(question) >= 0; }

  BadLine* line = nullptr;
  Snapshot truth;
};

TEST_P(LateAnswers, AreNeverShownAsAnothers) {
  start();
  const std::set<std::string> questions = line->asked;
  int met = 0;
  for (const std::string& question : questions) {
    if (question.find('=') != question.npos) continue;
    if (question.size() > 2 && question[0] == 'V' && question[1] != 'E')
      continue;  // of a hundred ten are enough
    line->victim = question;
    if (is_param(question)) post(intent::ReadParams(question));
    for (int ms = 0; ms < 4500; ms += 30) {
      run(0.03);
      expect_truth(question);
      if (HasFatalFailure()) return;
    }
    ASSERT_TRUE(latest.link.state != LinkState::lost || GetParam().mischief == Mischief::shifted) << question;
    if (line->victim.empty()) ++met;
  }
  EXPECT_GE(met, 30);  // a shift may cost the connection, and what was asked in it
  ASSERT_TRUE(run_until([&] { return latest.link.state == LinkState::good; }, 10));
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const char* model : {"dmx-k-sa", "pmx-4ex-sa"})
    for (const auto& [mischief, name] :
         std::initializer_list<std::pair<Mischief, const char*>>{{Mischief::late, "Late"},
                                                                 {Mischief::very_late, "VeryLate"},
                                                                 {Mischief::shifted, "Shifted"},
                                                                 {Mischief::doubled, "Doubled"},
                                                                 {Mischief::merged, "Merged"},
                                                                 {Mischief::echoed, "Echoed"}})
      cases.push_back({model, mischief, name});
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Of, LateAnswers, testing::ValuesIn(all_cases()), [](const auto& info) {
  return std::string(info.param.model).substr(0, 3) + info.param.name;
});

}  // namespace
}  // namespace hw::arcus
