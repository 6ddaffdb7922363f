// What a rehearsal tells of outputs and inputs, alike for each controller: for the line of time of each.
#include <algorithm>

#include <gtest/gtest.h>

#include "core/device/registry.h"

namespace hw {
namespace {

using EventLine = RehearsedEvent::Line;

struct Reported {
  const char* model;
  const char* text;
  const char* output;
  const char* input;
  EventLine of_input;
};
std::ostream& operator<<(std::ostream& out, const Reported& t) { return out << t.model; }

class RehearsedLines : public testing::TestWithParam<Reported> {
 protected:
  const RehearsedEvent* first(const Rehearsal& r, EventLine line, const char* name) {
    const auto found = std::find_if(r.events.begin(), r.events.end(), [&](const RehearsedEvent& e) {
      return e.line == line && e.name == name && (line != EventLine::switched || e.level == 1);
    });
    return found == r.events.end() ? nullptr : &*found;
  }
};

TEST_P(RehearsedLines, OutputsAndInputsAreReported) {
  const Reported& t = GetParam();
  RehearseOptions options;
  options.for_seconds = 2;
  const auto r = find_device_type(t.model)->language().rehearse(t.text, options);
  ASSERT_TRUE(r) << r.error().sentence();
  const RehearsedEvent* on = first(*r, EventLine::switched, t.output);
  ASSERT_TRUE(on);
  EXPECT_EQ(on->level, 1);
  EXPECT_TRUE(first(*r, t.of_input, t.input));
}

INSTANTIATE_TEST_SUITE_P(
    Each, RehearsedLines,
    testing::Values(Reported{"vxm", "U4\nU5\nU0\n", "output 1", "input 1", EventLine::waits},
                    Reported{"pmx-4ex-sa", "PRG 0\nDO1=1\nWHILE DI1=1\nENDWHILE\nEND\n", "output 1", "DI1",
                             EventLine::looked_at},
                    Reported{"dmx-k-sa", "SL=0\nDO2=0\nDO2=1\nWHILE DI1=1\nENDWHILE\nEND\n", "output 2",
                             "DI1", EventLine::looked_at},
                    Reported{"vme58", "AX BL8 SW0 MR10 GO ID\n", "Out 8", "line 0", EventLine::looked_at}),
    [](const testing::TestParamInfo<Reported>& tested) {
      std::string name = tested.param.model;
      std::replace(name.begin(), name.end(), '-', '_');
      return name;
    });

// Times of steps and passes go by them.
TEST(RehearsedTurns, AreOfTheProgramThatIsStartedWhicheverItIs) {
  RehearseOptions options;
  options.slot = 2;
  const auto r = find_device_type("vxm")->language().rehearse("I1M400\nI1M-400\n", options);
  ASSERT_TRUE(r) << r.error().sentence();
  ASSERT_EQ(r->turns.size(), 2u);
  EXPECT_EQ(r->turns[1].command, 1);
}

}  // namespace
}  // namespace hw
