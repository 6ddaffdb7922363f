// Of a sequence that a controller cannot do as a whole all refused steps are told, and the rest is written.
#include "core/device/refused_steps.h"

#include <gmock/gmock.h>

#include "core/device/registry.h"

namespace hw {
namespace {

using testing::HasSubstr;
namespace seq = sequence;

struct Partial {
  std::string text;
  std::vector<int> step_of_line;
  std::vector<RefusedStep> refused;
};
Partial write_partly(const char* model, seq::StepList steps) {
  const DeviceType& type = *find_device_type(model);
  const Catalog catalog = *type.make_catalog({});
  seq::Sequence s;
  for (const AxisInfo& axis : catalog.axes)
    if (s.axes.size() < 2) s.axes.push_back({axis.name});
  s.steps = std::move(steps);
  const auto* writer = dynamic_cast<const PartialWriter*>(&type.language());
  EXPECT_TRUE(writer) << model;
  Partial all;
  auto written = writer->write_with_gaps(s, catalog, all.refused);
  EXPECT_TRUE(written) << written.error().sentence();
  all.text = written->text, all.step_of_line = written->step_of_line;
  const auto whole = type.language().write(s, catalog);
  EXPECT_EQ(whole.has_value(), all.refused.empty());
  if (!whole) {
    EXPECT_EQ(whole.error().what, all.refused.front().what) << "the first is that of write()";
  }
  return all;
}
seq::Move move_to(double x, double y) {
  seq::Move m;
  m.to[0] = x, m.to[1] = y;
  return m;
}

TEST(RefusedSteps, SpeedStairsAreOfControllersThatChangeTheirSpeedAtAPlace) {
  for (const char* model : {"vxm", "pmx-4ex-sa", "dmx-k-sa", "vme58"}) {
    const Partial p = write_partly(model, {{seq::SpeedStairs{0, {{1000, 500}}, 2000}}, {seq::Delay{30}}});
    const std::string_view name = model;
    if (name == "vme58") {
      EXPECT_TRUE(p.refused.empty());
      continue;
    }
    ASSERT_EQ(p.refused.size(), 1u) << model;
    EXPECT_THAT(p.refused[0].what, HasSubstr("Step 1 (speed_stairs): ")) << model;
  }
}

TEST(RefusedSteps, AllAreReportedAndTheRestIsWritten) {
  seq::Repeat loop;
  loop.times = 3;
  loop.steps = {{seq::Delay{10}}, {seq::WaitInput{77, true}}, {seq::Delay{20}}};
  const Partial p =
      write_partly("pmx-4ex-sa", {{move_to(5e9, 1)}, {loop}, {seq::Output{99, true}}, {seq::Delay{30}}});
  EXPECT_EQ(
      p.text,
      "; block 1 is not written\nV49=0\nWHILE V49<3\n  DELAY=10\n  ; block 2.2 is not written\n  DELAY=20\n"
      "  V49=V49+1\nENDWHILE\n; block 3 is not written\nDELAY=30\nEND\n");
  ASSERT_EQ(p.refused.size(), 3u);
  EXPECT_EQ(p.refused[0].step, 0);
  EXPECT_EQ(p.refused[0].field, "to/X");
  EXPECT_EQ(p.refused[0].nearest, 134217727.0);
  EXPECT_EQ(p.refused[1].step, 3) << "loops are entered";
  EXPECT_EQ(p.refused[1].field, "input");
  EXPECT_EQ(p.refused[1].what, "Step 2.2 (wait_input): a PMX has no input 77.");
  EXPECT_EQ(p.refused[1].why, "a PMX has no input 77.");
  EXPECT_EQ(p.refused[2].step, 5);
  EXPECT_EQ(p.step_of_line, (std::vector<int>{0, 1, 1, 2, 3, 4, 1, 1, 5, 6, -1}));
}

TEST(RefusedSteps, AStepBehindARefusedOneIsNotRefusedForIt) {
  const Partial p = write_partly(
      "pmx-4ex-sa",
      {{move_to(5e9, 0)}, {seq::Arc{4.9e9, 0, 90, {}}}, {move_to(0, 0)}, {seq::Arc{100, 0, 360, {}}}});
  ASSERT_EQ(p.refused.size(), 2u);
  EXPECT_EQ(p.refused[0].step, 0);
  EXPECT_EQ(p.refused[1].field, "x") << "its centre, and not where it begins";
  EXPECT_THAT(p.text, HasSubstr("CIRN100:0"));
}

TEST(RefusedSteps, EachControllerGoesOnBehindThem) {
  const Partial vxm = write_partly("vxm", {{seq::Arc{1, 1, 90, {}}}, {seq::Delay{500}}, {seq::Jog{}}});
  EXPECT_EQ(vxm.text, "; block 1 is not written\nP5\n; block 3 is not written\n");
  const Partial board =
      write_partly("vme58", {{seq::Stop{}}, {seq::Delay{500}}, {seq::Enable{}}, {move_to(1, 2)}});
  EXPECT_EQ(board.text, "AA\n# block 1 is not written\nWT500\n# block 3 is not written\nMT1,2; GO\n");
  const Partial dmx = write_partly("dmx-k-sa", {{seq::Arc{1, 1, 90, {}}}, {seq::Delay{500}}});
  EXPECT_THAT(dmx.text, HasSubstr("DELAY=500"));
  EXPECT_EQ(dmx.refused.size(), 1u);
}

// An arc of a VME58 is written as a contour of one piece; a refusal of that is one of the arc.
TEST(RefusedSteps, ARefusalWithinWhatAStepBecomesIsThatOfTheStep) {
  const Partial p = write_partly(
      "vme58", {{seq::Speed{{1000, 0, 0}}}, {move_to(0, 0)}, {seq::Arc{0, 0, 90, {}}}, {seq::Delay{1}}});
  ASSERT_EQ(p.refused.size(), 1u);
  EXPECT_EQ(p.refused[0].step, 2);
  EXPECT_THAT(p.text, HasSubstr("# block 3 is not written\nWT1\n"));
}

}  // namespace
}  // namespace hw
