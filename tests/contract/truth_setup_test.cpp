// Set-up: what was set is in the controller, not only on the screen.
#include <map>

#include "tests/contract/truth.h"

namespace hw {
namespace {

using std::chrono::seconds;

/// A value that it does not have from the factory and that is harmless to try. Whole, since a controller may
/// tell no fractions.
std::optional<std::int64_t> another_value(const ParamInfo& p) {
  if (!p.readable || !p.warning.empty() || !p.bits.empty() || !p.prefix.empty()) return std::nullopt;
  for (const ParamChoice& c : p.choices)
    if (c.value != p.fallback) return c.value;
  if (!p.choices.empty()) return std::nullopt;
  std::int64_t whole = 1;
  for (int i = 0; i < p.decimals; ++i) whole *= 10;
  for (const std::int64_t by : {7 * whole, -7 * whole, whole, -whole, std::int64_t{1}, std::int64_t{-1}})
    if (p.fallback + by >= p.minimum && p.fallback + by <= p.maximum) return p.fallback + by;
  return std::nullopt;
}

TEST_P(TruthTest, AChangedParameterIsReadBackFromTheController) {
  const Catalog& c = session->catalog();
  int tried = 0;
  for (std::size_t i = 0; i < c.params.size(); ++i) {
    const auto value = another_value(c.params[i]);
    if (!value) continue;
    const std::string& name = c.params[i].mnemonic;
    const IntentOutcome set = perform(intent::SetParam(name, *value, true), seconds(60));
    if (set.state == IntentState::refused) continue;  // by another one: in words
    ASSERT_EQ(set.state, IntentState::done) << name << ": " << set.sentence.view();
    ++tried;
    ASSERT_EQ(perform(intent::ReadParams(name), seconds(60)).state, IntentState::done) << name;
    EXPECT_EQ(now().params[i].value, *value) << name;
    ASSERT_EQ(perform(intent::SetParam(name, c.params[i].fallback, true), seconds(60)).state,
              IntentState::done)
        << name;
  }
  EXPECT_GE(tried, static_cast<int>(c.params.size()) / 3);
}

// Another session knows nothing of what this one has set.
TEST_P(TruthTest, AnotherSessionReadsAChangedParameter) {
  const std::vector<ParamInfo> params = session->catalog().params;
  for (const ParamInfo& p : params)
    if (const auto value = another_value(p)) perform(intent::SetParam(p.mnemonic, *value, true), seconds(60));
  read_params();
  const auto here = now().params;
  open_afresh();
  read_params();
  int changed = 0;
  for (std::size_t i = 0; i < params.size(); ++i) {
    if (!now().params[i].known) continue;
    EXPECT_EQ(now().params[i].value, here[i].value) << params[i].mnemonic;
    changed += now().params[i].value != params[i].fallback;
  }
  EXPECT_GE(changed, std::min(5, static_cast<int>(params.size())));
}

TEST_P(TruthTest, StoredParametersSurvivePowerOff) {
  const Catalog& c = session->catalog();
  if (!c.can.store) GTEST_SKIP() << "it keeps nothing without power";
  std::vector<std::string> names;
  const auto set_another = [&](const ParamInfo& p) {
    const auto value = p.stored ? another_value(p) : std::nullopt;
    return value &&
           perform(intent::SetParam(p.mnemonic, *value, true), seconds(60)).state == IntentState::done;
  };
  for (const ParamInfo& p : c.params) {
    if (names.size() == 4) break;
    if (!set_another(p)) continue;
    names.push_back(p.mnemonic);
    if (names.size() == 2) must(intent::Store());
  }
  ASSERT_EQ(names.size(), 4u);
  std::map<std::string, std::int64_t> set;
  for (const std::string& name : names) set[name] = param(name);
  operate(bench::PowerCycle());
  run(seconds(10));
  ASSERT_EQ(now().link.state, LinkState::good);
  read_params();
  for (std::size_t i = 0; i < names.size(); ++i)
    EXPECT_EQ(param(names[i]) == set[names[i]], i < 2)
        << names[i] << (i < 2 ? " was stored" : " was not stored");
}

TEST_P(TruthTest, AVariableIsSetInTheController) {
  const VariableFacts facts = session->catalog().variables;
  if (facts.count == 0) GTEST_SKIP() << "it has no variables";
  for (const int number : {1, facts.count - 1}) must(intent::SetVariable(number, 1200 + number));
  open_afresh();
  must(intent::Watch(1u << facts.readout_group));
  run(seconds(2));
  for (const int number : {1, facts.count - 1})
    EXPECT_EQ(now().variables[static_cast<std::size_t>(number)], 1200 + number) << number;
}

TEST_P(TruthTest, AResetIsOne) {
  if (!session->catalog().can.reset) GTEST_SKIP() << "it has none";
  must(intent::MoveTo({{id(0), Steps(500)}}));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  const Steps there = load();
  must(intent::Reset());
  run(seconds(10));
  ASSERT_EQ(now().link.state, LinkState::good);
  EXPECT_EQ(axis().position, Steps(0)) << "it counts from here";
  EXPECT_EQ(load(), there);
}

TEST_P(TruthTest, AfterAResetAPositionIsDoubted) {
  if (!session->catalog().can.reset) GTEST_SKIP() << "it has none";
  must(intent::MoveTo({{id(0), Steps(500)}}));
  ASSERT_TRUE(becomes_idle(seconds(20)));
  must(intent::Reset());
  run(seconds(10));
  EXPECT_TRUE(axis().trust.doubtful());
  EXPECT_EQ(perform(intent::MoveTo({{id(0), Steps(240)}})).state, IntentState::refused);
}

TEST_P(TruthTest, AnotherSessionReadsTheMotorPower) {
  if (!session->catalog().axes[0].switchable) GTEST_SKIP() << "its motors are always powered";
  for (int i = 0; i < axes(); ++i) {
    for (const bool on : {false, true}) {
      must(intent::SetPower(i, on));
      run(seconds(1));
      EXPECT_EQ(axis_at(i).enabled, on) << i;
      open_afresh();
      for (int k = 0; k < axes(); ++k) EXPECT_EQ(axis_at(k).enabled, on || k != i) << k << " of " << i;
    }
  }
}

}  // namespace
}  // namespace hw
