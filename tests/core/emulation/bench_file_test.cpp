#include "core/emulation/bench_file.h"

#include <gtest/gtest.h>

namespace hw {
namespace {

Catalog two_axes() {
  Catalog c;
  c.axes = {{"1", "motor 1"}, {"X", "another"}};
  c.inputs.resize(4);
  c.analog = {{"Analog", "counts", 0, 1024}};
  c.bench.buttons = {{"Run", true, 0}};
  return c;
}

std::string complaint(std::string_view text) {
  const auto file = parse_bench_file(text, two_axes(), "b.toml");
  return file ? "none" : file.error().sentence();
}

TEST(BenchFile, DescribesWhatHangsOnAnAxis) {
  const auto file = parse_bench_file(
      "[axis.1]\nminus = -1000\nplus = 90000\nhome = [2000, 2400]\nindex_every = 4000\n"
      "counts_per_step = 1.25\nbacklash = 3\n[axis.X]\nplus = 5\n",
      two_axes());
  ASSERT_TRUE(file) << file.error().sentence();
  ASSERT_EQ(file->at_start.size(), 2u);
  const auto& one = std::get<bench::Place>(file->at_start[0]);
  EXPECT_EQ(one.axis, AxisId{0});
  EXPECT_EQ(one.place.minus, Steps(-1000));
  EXPECT_EQ(one.place.plus, Steps(90000));
  EXPECT_EQ(one.place.home_from, Steps(2000));
  EXPECT_EQ(one.place.home_to, Steps(2400));
  EXPECT_EQ(one.place.index_every, Steps(4000));
  EXPECT_EQ(one.place.counts_per_step, 1.25);
  EXPECT_EQ(one.place.backlash, Steps(3));
  const auto& x = std::get<bench::Place>(file->at_start[1]);
  EXPECT_EQ(x.axis, AxisId{1});
  EXPECT_FALSE(x.place.minus);
}

TEST(BenchFile, SetsHowWellTheSwitchesRepeat) {
  const auto file = parse_bench_file("[axis.1]\nplus = 500\nscatter = 3\nseed = 7\n", two_axes());
  ASSERT_TRUE(file) << file.error().sentence();
  const AxisPlace& place = std::get<bench::Place>(file->at_start[0]).place;
  EXPECT_EQ(place.scatter, Steps(3));
  EXPECT_EQ(place.seed, 7);
  EXPECT_EQ(place.switches().scatter, Steps(3));
  EXPECT_NE(complaint("[axis.1]\nscatter = -1\n").find("scatter must not be negative"), std::string::npos);
  EXPECT_NE(complaint("[axis.1]\nscatter = 0.5\n").find("scatter must be a whole number"), std::string::npos);
}

TEST(BenchFile, GivesAServoAxisAMotor) {
  const auto file = parse_bench_file(
      "[axis.1]\nmotor = true\n[axis.X]\nmotor = {friction = 0.01, inertia = 1}\n", two_axes());
  ASSERT_TRUE(file) << file.error().sentence();
  EXPECT_EQ(std::get<bench::Place>(file->at_start[0]).place.motor, Motor());
  const auto& other = std::get<bench::Place>(file->at_start[1]).place.motor;
  ASSERT_TRUE(other);
  EXPECT_EQ(other->friction, 0.01);
  EXPECT_EQ(other->inertia, 1);
  EXPECT_EQ(other->torque_limit, Motor().torque_limit);
  const auto none = parse_bench_file("[axis.1]\nmotor = false\n", two_axes());
  EXPECT_FALSE(std::get<bench::Place>(none->at_start[0]).place.motor->present);
  EXPECT_EQ(complaint("[axis.1]\nmotor = {mass = 1}\n").substr(0, 38),
            "b.toml:2:17: a motor has no \"mass\". Th");
  EXPECT_EQ(complaint("[axis.1]\nmotor = {inertia = 0}\n").substr(0, 45),
            "b.toml:2:20: inertia must be a number from 1e");
  EXPECT_EQ(complaint("[axis.1]\nmotor = 3\n").substr(0, 54),
            "b.toml:2:9: motor, unless it is a table, must be true ");
}

TEST(BenchFile, SetsInputsAnalogAndQuirks) {
  const auto file = parse_bench_file(
      "quirks = [\"overrun\", \"e-bar\"]\n[input]\n2 = true\n[analog]\n1 = 300\n", two_axes());
  ASSERT_TRUE(file) << file.error().sentence();
  EXPECT_EQ(file->quirks, (std::vector<std::string>{"overrun", "e-bar"}));
  ASSERT_EQ(file->at_start.size(), 2u);
  const auto& analog = std::get<bench::Analog>(file->at_start[0]);
  EXPECT_EQ(analog.value, 300);
  const auto& input = std::get<bench::Input>(file->at_start[1]);
  EXPECT_EQ(input.number, 2);
  EXPECT_TRUE(input.active);
}

TEST(BenchFile, OrdersWhatHappensLater) {
  const auto file = parse_bench_file(
      "[[at]]\nt = 2\nlimit = [\"1\", \"+\", true]\n[[at]]\nt = 0.5\ninput = [1, true]\nbutton = [\"Run\", "
      "true]\n[[at]]\nt = 3.0\nslip = [1, -40]\n",
      two_axes());
  ASSERT_TRUE(file) << file.error().sentence();
  ASSERT_EQ(file->later.size(), 4u);
  EXPECT_EQ(file->later[0].at, Millis(500));
  EXPECT_EQ(file->later[1].at, Millis(500));
  EXPECT_TRUE(std::get<bench::Limit>(file->later[2].command).operated);
  EXPECT_EQ(std::get<bench::Slip>(file->later[3].command).by, Steps(-40));
}

TEST(BenchFile, AlarmsComeToo) {
  const auto file = parse_bench_file("[[at]]\nt = 1\nalarm = [\"X\", true]\n", two_axes());
  ASSERT_TRUE(file) << file.error().sentence();
  ASSERT_EQ(file->later.size(), 1u);
  EXPECT_EQ(std::get<bench::Alarm>(file->later[0].command).axis, AxisId{1});
  EXPECT_TRUE(std::get<bench::Alarm>(file->later[0].command).on);
}

TEST(BenchFile, ReportsThePlaceAndTheError) {
  EXPECT_EQ(complaint("[axis.3]\nplus = 1\n"),
            "b.toml:1:1: there is no axis \"3\". The file was not used. This controller has: 1, X.");
  EXPECT_EQ(complaint("[axis.1]\n\nplus = 1.5\n").substr(0, 62),
            "b.toml:3:8: plus must be a whole number from -1000000000000 to");
  EXPECT_EQ(complaint("[axis.1]\nplsu = 1\n"),
            "b.toml:2:8: an axis has no \"plsu\". The file was not used. Known here: minus, plus, home, "
            "index_every, counts_per_step, backlash, scatter, seed, motor.");
  EXPECT_EQ(complaint("[axis.1]\nminus = 5\nplus = 5\n"),
            "b.toml:1:1: minus must be below plus. The file was not used.");
  EXPECT_EQ(complaint("[input]\n5 = true\n"),
            "b.toml:2:5: there is no input \"5\". The file was not used. This controller has input 1 to "
            "4.");
  EXPECT_EQ(complaint("[input]\n1 = 1\n"),
            "b.toml:2:5: an input must be true or false. The file was not used.");
  EXPECT_EQ(complaint("[[at]]\nlimit = [1, \"+\", true]\n"),
            "b.toml:1:1: an [[at]] needs t, its time in seconds. The file was not used.");
  EXPECT_EQ(complaint("[[at]]\nt = 1\nlimit = [1, \"up\", true]\n"),
            "b.toml:3:13: the side of a limit switch is \"+\" or \"-\". The file was not used.");
  EXPECT_EQ(complaint("[[at]]\nt = 1\nbutton = [\"Rum\", true]\n"),
            "b.toml:3:11: there is no button \"Rum\". The file was not used.");
  EXPECT_EQ(complaint("axes = 4\n").substr(0, 38), "b.toml:1:8: a bench has no \"axes\". The");
}

TEST(BenchFile, NoTomlIsReportedWithItsPlace) {
  const std::string text = complaint("[axis.1]\nplus = \n");
  EXPECT_EQ(text.substr(0, 9), "b.toml:2:") << text;
  EXPECT_NE(text.find("A bench file is TOML"), std::string::npos) << text;
}

TEST(BenchFile, EmptyIsAnEmptyBench) {
  const auto file = parse_bench_file("", two_axes());
  ASSERT_TRUE(file);
  EXPECT_TRUE(file->at_start.empty());
}

TEST(Place, RefusesWhatCannotBe) {
  AxisPlace place;
  EXPECT_EQ(problem_of(place), "");
  place.counts_per_step = 0;
  EXPECT_EQ(problem_of(place), "counts_per_step must be a number other than 0");
  place.counts_per_step = 1;
  place.backlash = Steps(-1);
  EXPECT_EQ(problem_of(place), "backlash must not be negative");
  place.backlash = Steps(1);
  place.motor.emplace().inertia = 0;
  EXPECT_EQ(problem_of(place), "a value of the motor is out of its range");
}

}  // namespace
}  // namespace hw
