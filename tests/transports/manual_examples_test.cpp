// The tables of the makers' examples are whole: each of their programs is run by the agreement test, or it is
// said why it cannot be; and none of a manual's numbers is left out.
#include "tests/transports/manual_examples.h"

#include <set>

#include <gtest/gtest.h>

namespace hw {
namespace {

class ManualExamples : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    auto read = test::read_manual(GetParam());
    ASSERT_TRUE(read) << read.error().what;
    manual = std::move(*read);
  }
  test::Manual manual;
};

TEST_P(ManualExamples, AreRunOrReportWhyNot) {
  std::set<std::string> run, all;
  for (const test::ManualExample& example : manual.examples) {
    SCOPED_TRACE(example.name);
    EXPECT_FALSE(example.name.empty());
    EXPECT_FALSE(example.at.empty()) << "the manual's own place is missing";
    EXPECT_TRUE(all.insert(example.name).second) << "two have this name";
    const int answers = (example.run.text.empty() ? 0 : 1) + (example.same_as.empty() ? 0 : 1) +
                        (example.why_not.empty() ? 0 : 1);
    EXPECT_EQ(answers, 1) << "it needs a program, another that is the same, or a reason";
    EXPECT_TRUE(example.same_as.empty() || run.contains(example.same_as))
        << "it is the same as one that is not run";
    if (example.is_run()) run.insert(example.name);
  }
  EXPECT_FALSE(run.empty());
}

TEST_P(ManualExamples, LeaveOutNoNumber) {
  std::set<int> numbers;
  for (const test::ManualExample& example : manual.examples)
    if (example.number > 0) numbers.insert(example.number);
  for (int n = 1; n <= manual.numbered; ++n) EXPECT_TRUE(numbers.contains(n)) << "number " << n;
  EXPECT_EQ(numbers.size(), static_cast<std::size_t>(manual.numbered));
}

INSTANTIATE_TEST_SUITE_P(Manual, ManualExamples, testing::Values("vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"),
                         [](const testing::TestParamInfo<const char*>& tested) {
                           std::string name = tested.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace hw
