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

TEST(TrackPath, OverTimeOneAxisRestsWhileItWaits) {
  TrackAxes axes;
  axes.over_time = true;
  const auto path = path_of("vxm", "I1M400,\nP20,\nI1M-400,\n", axes);
  EXPECT_DOUBLE_EQ(path.bounds.high.y, 400);
  double rests = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    EXPECT_GE(path.points[i].x, path.points[i - 1].x) << "time goes on";
    if (path.points[i].y == 400 && path.points[i - 1].y == 400)
      rests += path.points[i].x - path.points[i - 1].x;
  }
  EXPECT_NEAR(rests, 2, 0.05);
}

TEST(TrackPath, EachPassOfALoopIsReported) {
  const auto path = path_of("vxm", "LM0\nI1M100\nI2M100\nLA3\n", first_two());
  std::vector<int> passes;
  for (const auto& run : path.runs)
    if (run.source == 2) passes.push_back(run.pass);
  EXPECT_EQ(passes, (std::vector<int>{0, 1, 2}));
  const auto looped =
      path_of("pmx-4ex-sa",
              "INC\nHSPD=5000\nLSPD=100\nACC=100\nV1=3\nWHILE V1>0\nX100\nWAITX\nY100\nWAITY\n"
              "V1=V1-1\nENDWHILE\nEND\n",
              first_two());
  passes.clear();
  for (const auto& run : looped.runs)
    if (run.source == 8) passes.push_back(run.pass);
  EXPECT_EQ(passes, (std::vector<int>{0, 1, 2}));
}

sequence::Move lowered(double z) {
  sequence::Move move;
  move.to[2] = z;
  return move;
}

TEST(TrackPath, TheToolIsThatOfTheRoutines) {
  const Catalog pmx = *find_device_type("pmx-4ex-sa")->make_catalog({});
  sequence::Sequence s;
  s.axes = {{"X", 1}, {"Y", 1}, {"Z", 100}};
  TrackAxes axes = first_two();
  EXPECT_FALSE(take_tool_of(s, pmx, axes));
  EXPECT_EQ(axes, first_two());
  s.pen_up = {{lowered(2)}}, s.pen_down = {{lowered(-1)}};
  ASSERT_TRUE(take_tool_of(s, pmx, axes));
  const auto path =
      path_of("pmx-4ex-sa",
              "ABS\nHSPD=5000\nLSPD=100\nACC=100\nZ200\nWAITZ\nX1000\nWAITX\nZ-100\nWAITZ\nX3000\n"
              "WAITX\nZ200\nWAITZ\nX0\nWAITX\nEND\n",
              axes);
  EXPECT_NEAR(path.way_on, 2000, 1);
  EXPECT_NEAR(path.way_off, 4000, 1);
  s.pen_up.push_back({sequence::Output{5, true}}), s.pen_down.push_back({sequence::Output{5, false}});
  axes = first_two();
  ASSERT_TRUE(take_tool_of(s, pmx, axes));
  EXPECT_EQ(axes.tool_output, 4);
  EXPECT_FALSE(axes.tool_is_on_when) << "it is on while the output is off";
}

TEST(TrackPath, ControllersOfABusGoTogether) {
  const auto track = [](std::initializer_list<std::pair<double, int>> places) {
    Rehearsal r;
    for (const auto& [t, position] : places) {
      RehearsedPlace place;
      place.t = t, place.position[0] = position;
      r.track.push_back(place);
    }
    return r;
  };
  const std::vector<Rehearsal> all{track({{0, 0}, {1, 100}}), track({{0, 50}, {2, 250}})};
  TrackAxes axes;
  axes.right = {0, 1, 0}, axes.up = {0, 0.1, 1};
  const auto path = track_path_together(all, axes);
  EXPECT_EQ(path.points, (std::vector<drawing::Point3>{{0, 5}, {100, 15}, {100, 25}}));
  EXPECT_EQ(path.runs.front().source, -1);
}

}  // namespace
}  // namespace hw
