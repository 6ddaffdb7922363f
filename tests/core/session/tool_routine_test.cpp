// What a tool does when it is lowered, as a line of text.
#include "core/session/tool_routine.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include "core/device/registry.h"

namespace hw {
namespace {

using testing::HasSubstr;

struct ToolRoutine : testing::Test {
  explicit ToolRoutine(const char* model = "pmx-4ex-sa")
      : catalog(*find_device_type(model)->make_catalog({})) {
    for (const std::size_t a : {0, 1}) axes.push_back({catalog.axes[a].name, 200});
  }
  Result<sequence::StepList> read(std::string_view text) {
    return read_routine(
        text, catalog, [](const std::string&) { return 50.0; }, axes);
  }
  std::string refused(std::string_view text) {
    const auto steps = read(text);
    return steps ? "" : steps.error().sentence();
  }
  const Catalog catalog;
  std::vector<sequence::Axis> axes;
};
struct VxmToolRoutine : ToolRoutine {
  VxmToolRoutine() : ToolRoutine("vxm") {}
};

TEST_F(ToolRoutine, AxesOutputsAndWaitsInTheirOrder) {
  const auto steps = read("Z to -2.5, DO2 on,wait 250 ms, do3 OFF, wait 40");
  ASSERT_TRUE(steps) << steps.error().sentence();
  sequence::Move move;
  move.to[2] = -2.5;
  const sequence::StepList expected{{move},
                                    {sequence::WaitMotion{2}},
                                    {sequence::Output{2, true}},
                                    {sequence::Delay{250}},
                                    {sequence::Output{3, false}},
                                    {sequence::Delay{40}}};
  EXPECT_EQ(*steps, expected);
  ASSERT_EQ(axes.size(), 3u);
  EXPECT_EQ(axes[2], (sequence::Axis{"Z", 50})) << "it has joined those that draw";
}

TEST_F(ToolRoutine, AWrittenRoutineReadsBackTheSame) {
  const char* text = "Z to -2.5, U to 7, DO2 on, wait 250.5 ms, Z to 0";
  const auto steps = read(text);
  ASSERT_TRUE(steps) << steps.error().sentence();
  EXPECT_EQ(write_routine(*steps, catalog, axes), text);
}

TEST_F(ToolRoutine, NothingIsARoutineToo) {
  for (const char* text : {"", " ", " , "}) {
    const auto steps = read(text);
    ASSERT_TRUE(steps) << text;
    EXPECT_TRUE(steps->empty());
  }
}

TEST_F(ToolRoutine, ARoutineThatIsNotUnderstoodIsRefusedWithAnExample) {
  EXPECT_THAT(refused("DO2 on, wait a bit"), HasSubstr("\"wait a bit\" is not understood."));
  EXPECT_THAT(refused("wait -3"), HasSubstr("not understood"));
  EXPECT_THAT(refused("Z to there"), HasSubstr("not understood"));
  EXPECT_THAT(refused("DO9 on"), HasSubstr("no output \"DO9\""));
  EXPECT_THAT(refused("W to 3"), HasSubstr("no axis \"W\""));
  EXPECT_THAT(refused("Y to 3"), HasSubstr("Y draws"));
  EXPECT_THAT(refused("hop"), HasSubstr("Write: U to -2, DO1 on, wait 250 ms."));
}

TEST_F(ToolRoutine, AToolThatNothingSwitchesOffIsRefused) {
  const auto agree = [this](const char* down, const char* up) {
    const auto back = switches_back(*read(down), *read(up), catalog);
    return back ? "" : back.error().sentence();
  };
  EXPECT_EQ(agree("DO2 on, wait 50", "DO2 off"), "");
  EXPECT_EQ(agree("Z to -2", "Z to 2"), "");
  EXPECT_EQ(agree("DO3 on, wait 5, DO3 off", ""), "") << "it is off again by itself";
  EXPECT_EQ(agree("DO2 on", "DO1 off"),
            "DO2 is switched on with the tool, and nothing switches it back. Add this to the steps that "
            "switch the tool off: DO2 off.");
  EXPECT_THAT(agree("DO2 on", "DO2 off, DO2 on"), HasSubstr("nothing switches it back"));
}

TEST_F(VxmToolRoutine, NamesOfSeveralWordsAndNumbersDo) {
  const std::string name = catalog.outputs.front().name;
  const int number = catalog.output_number(0);
  for (const std::string& text :
       {name + " on", std::to_string(number) + " on", fmt::format("output {} on", number)}) {
    const auto steps = read(text);
    ASSERT_TRUE(steps) << text << ": " << steps.error().sentence();
    EXPECT_EQ(*steps, (sequence::StepList{{sequence::Output{number, true}}})) << text;
    EXPECT_EQ(write_routine(*steps, catalog, axes), name + " on");
  }
}

}  // namespace
}  // namespace hw
