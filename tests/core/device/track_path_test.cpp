// What a rehearsal passes through becomes a path that knows its lines, in each language that has programs.
#include "core/device/track_path.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/base/index.h"
#include "core/device/registry.h"

namespace hw {
namespace {

drawing::ToolPath path_of(const char* model, std::string_view text, TrackAxes axes) {
  const Language& language = find_device_type(model)->language();
  RehearseOptions options;
  options.track_every_s = 0.01;
  const auto rehearsal = language.rehearse(text, options);
  EXPECT_TRUE(rehearsal) << rehearsal.error().sentence();
  if (!rehearsal) return {};
  EXPECT_TRUE(rehearsal->finished) << rehearsal->error;
  return track_path(*rehearsal, axes, 0, lines_of_commands(language.analyse(text, 0), 0));
}
TrackAxes first_two() {
  TrackAxes axes;
  axes.up.place = 1;
  return axes;
}

TEST(TrackPath, AVxmGoesOneMotorAfterTheOther) {
  const auto path = path_of("vxm", "; a square\nI1M400,\nI2M400,\nI1M-400,\nI2M-400,\n", first_two());
  ASSERT_EQ(path.runs.size(), 4u);
  const std::vector<drawing::Point> corners{{0, 0}, {400, 0}, {400, 400}, {0, 400}, {0, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(path.points[path.runs[i].first], corners[i]) << i;
    EXPECT_EQ(path.runs[i].size, 2u) << "ramps do not show in the way";
    EXPECT_EQ(path.runs[i].source, static_cast<int>(i) + 1);
  }
  EXPECT_DOUBLE_EQ(path.way_on, 1600);
}

TEST(TrackPath, APmxGoesStraightWithTheToolThatItsOutputSwitches) {
  TrackAxes axes = first_two();
  axes.right.units_per_step = axes.up.units_per_step = 0.001;
  axes.tool_output = 4;
  const auto path = path_of("pmx-4ex-sa",
                            "ABS\nHSPD=5000\nLSPD=100\nACC=100\nX2000Y1000\nWAITX\nDO5=1\nX4000Y0\nWAITX\n"
                            "DO5=0\nX0Y0\nWAITX\nEND\n",
                            axes);
  EXPECT_NEAR(path.way_on, std::hypot(2, 1), 0.01);
  EXPECT_NEAR(path.way_off, std::hypot(2, 1) + 4, 0.01);
  EXPECT_NEAR(path.bounds.high.x, 4, 1e-9);
  EXPECT_NEAR(path.bounds.high.y, 1, 1e-9);
  for (const auto& run : path.runs) {
    const drawing::Point3 a = path.points[run.first], b = path.points[run.first + run.size - 1];
    const int line = b.x < a.x ? 10 : a.x < 2 - 1e-3 ? 4 : 7;
    EXPECT_EQ(run.source, line) << a.x << " to " << b.x;
    EXPECT_EQ(run.tool_on, line == 7);
  }
}

TEST(TrackPath, AThirdAxisGoesIntoTheDepth) {
  TrackAxes axes = first_two();
  axes.third = TrackAxes::Axis{2, 0.01};
  const auto path =
      path_of("pmx-4ex-sa",
              "ABS\nHSPD=5000\nLSPD=100\nACC=100\nX2000Y1000\nWAITX\nZ-300\nWAITZ\nX0Y0\nWAITX\nEND\n", axes);
  EXPECT_EQ(path.bounds.low, (drawing::Point3{0, 0, -3}));
  EXPECT_EQ(path.points.back(), (drawing::Point3{0, 0, -3}));
  EXPECT_NEAR(path.way_on, 2 * std::hypot(2000, 1000) + 3, 5);
}

TEST(TrackPath, AContourOfABoardIsRoundFromItsBeginOn) {
  const auto path = path_of(
      "vme58", "AA\nVL1000,1000;\nMT1000,0; GO\nWA\nCV500;\nCD1000,0;\nCR0,0,6.283185307;\nCK\nCX\nWA\n",
      first_two());
  for (const drawing::Point3& p : path.points)
    EXPECT_TRUE(p.y == 0 || std::fabs(std::hypot(p.x, p.y) - 1000) < 3) << p.x << "," << p.y;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const drawing::Point3 a = path.points[i - 1], b = path.points[i];
    if (a.y != 0 || b.y != 0) {
      EXPECT_LT(std::hypot(b.x - a.x, b.y - a.y), 120) << a.x << "," << a.y;
    }
  }
}

TEST(TrackPath, CountsThatGoAgainstTheStepsAreMirrored) {
  TrackAxes axes = first_two();
  axes.right.units_per_step = -0.5;
  const auto path = path_of("vxm", "I1M400,\n", axes);
  EXPECT_DOUBLE_EQ(path.bounds.low.x, -200);
  EXPECT_DOUBLE_EQ(path.bounds.high.x, 0);
}

}  // namespace
}  // namespace hw
