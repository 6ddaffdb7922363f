// Which place of a typed program its rest can be run from, and in which state.
#include "panels/program/rest_of_text.h"

#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "panels/path/source_places.h"

namespace hw::panels {
namespace {

using testing::HasSubstr;

/// Rehearsed from 0, and begun at a line (from 1).
Result<RestOfText> rest_at(const char* model, const std::string& text, int line, std::optional<int> pass = {},
                           int nth_in_line = 0) {
  const DeviceType& type = *find_device_type(model);
  const Catalog catalog = *type.make_catalog({});
  RehearseOptions options;
  options.track_every_s = 0.02;
  const auto rehearsal = type.language().rehearse(text, options);
  EXPECT_TRUE(rehearsal) << rehearsal.error().sentence();
  const SourcePlaces places = source_places(type.language().analyse(text, 0), 0);
  const int source = places.of_line(line - 1).first + nth_in_line;
  const SourcePlace& at = places.all[static_cast<std::size_t>(source)];
  return rest_of_text(type.language(),
                      {text, at.line, at.byte, pass, rehearsal->axes,
                       begun_between(*rehearsal, places.of_command, source, pass)},
                      {}, catalog);
}
/// What of it leads there, and what is run then.
std::string written(const char* model, const RestOfText& rest) {
  const DeviceType& type = *find_device_type(model);
  const auto text = type.language().write(rest.rest.sequence, *type.make_catalog({}));
  EXPECT_TRUE(text) << text.error().sentence();
  return text ? text->text : "";
}

TEST(RestOfText, SpeedsAndOutputsAreAsTheLinesAboveLeaveThem) {
  const auto rest =
      rest_at("pmx-4ex-sa", "HSPD=2000\nABS\nX1000\nWAITX\nDO3=1\nY500\nWAITY\nX0\nWAITX\nEND\n", 6);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(words_of_leading(rest->rest).find("Tool"), std::string::npos);
  const std::string text = written("pmx-4ex-sa", *rest);
  const auto speed = text.find("HSPD=2000"), there = text.find("X1000Y0"), on = text.find("DO3=1"),
             rest_of_it = text.find("Y500");
  EXPECT_TRUE(speed < there && there < on && on < rest_of_it && rest_of_it != std::string::npos) << text;
  EXPECT_EQ(rest->begins, "line 6, Y500");
}

TEST(RestOfText, PowerIsAsTheLinesAboveLeaveIt) {
  const auto rest = rest_at("pmx-4ex-sa", "EO=3\nABS\nX1000\nWAITX\nX0\nWAITX\nEND\n", 5);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(rest->begins, "line 5, X0");
  const std::string text = written("pmx-4ex-sa", *rest);
  const auto on = text.find("EO1=1\nEO2=1\n"), there = text.find("X1000\n"),
             off = text.find("EO3=0\nEO4=0\n");
  EXPECT_TRUE(on < there && there < off && off < text.find("X0\n")) << text;
}

TEST(RestOfText, OfALoopThePassThatIsMeantIsWrittenOut) {
  const char* text = "LM0,\nI1M100,\nI2M100,\nLA4,\n";
  const auto rest = rest_at("vxm", text, 3, 1);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(rest->begins, "line 3, I2M100, pass 2");
  EXPECT_THAT(written("vxm", *rest), HasSubstr("IA1M200"));
  EXPECT_THAT(written("vxm", *rest), HasSubstr("IA2M100"));
  const auto nobody_knows = rest_at("vxm", text, 3);
  ASSERT_FALSE(nobody_knows);
  EXPECT_THAT(nobody_knows.error().what, HasSubstr("Line 3 lies within a loop"));
}

TEST(RestOfText, TwoCommandsThatAreOneStepAreBegunTogether) {
  const auto rest = rest_at("vme58", "AA\nMR500; GO MR250; GO\n", 2, {}, 3);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(*rest->rest.start[0], 500);
  EXPECT_THAT(written("vme58", *rest), HasSubstr("MA500; GO\nWA\n# Here the rest begins.\nMR250; GO\n"));
}

TEST(RestOfText, SpeedsOfSingleMotorsAreSetAgainInTheirOrder) {
  const char* text = "S1M2000,A1M2\nIA1M0\nS2M1000\nIA2M400\nS1M500\nIA1M4000\nIA2M0\n";
  const auto rest = rest_at("vxm", text, 7);
  ASSERT_TRUE(rest) << rest.error().sentence();
  const std::string all = written("vxm", *rest);
  const auto first = all.find("S1M2000"), second = all.find("S2M1000"), last = all.find("S1M500"),
             there = all.find("IA1M4000"), rest_of_it = all.find("IA2M0");
  EXPECT_TRUE(first < second && second < last && last < there && there < rest_of_it) << all;
  EXPECT_THAT(all, HasSubstr("A1M2"));
  EXPECT_THAT(words_of_leading(rest->rest), HasSubstr("S1M500"));
  const auto in_a_loop = rest_at("vxm", "S1M2000\nLM0\nI1M100\nI2M50\nLA3\n", 4, 1);
  ASSERT_TRUE(in_a_loop) << in_a_loop.error().sentence();
  EXPECT_THAT(written("vxm", *in_a_loop), HasSubstr("S1M2000"));
  const auto unknown = rest_at("vxm", "S1M2000\nIA1M-0\nIA1M400\nIA1M0\n", 4);
  ASSERT_FALSE(unknown) << "what else is done there is not known";
}

/// On its last pass L leaves the command before it out, which no loop of blocks does.
TEST(RestOfText, TextThatNoBlockCanHoldIsRefused) {
  const auto loop = rest_at("vxm", "I1M100,\nI2M100,\nL4,\n", 2, 1);
  ASSERT_FALSE(loop);
  EXPECT_THAT(loop.error().what, HasSubstr("a loop without a mark of its own"));
  const auto side_by_side = rest_at("vme58", "AX\nMR500 GO\nAY MR250 GO\n", 3);
  ASSERT_FALSE(side_by_side);
  EXPECT_THAT(side_by_side.error().what, HasSubstr("a single axis (AX, AY ...) has a queue of its own"));
}

TEST(RestOfText, OneAxisAloneIsFollowedInItsOwnMode) {
  const auto rest = rest_at("vme58", "AY\nVL8000 # fast\nMR500 GO\nLS2 MR250 GO LE\nMA0 GO\n", 5);
  ASSERT_TRUE(rest) << rest.error().sentence();
  EXPECT_EQ(*rest->rest.start[1], 1000);
  EXPECT_EQ(rest->begins, "line 5, MA0 GO");
  const std::string text = written("vme58", *rest);
  EXPECT_THAT(text, HasSubstr("VL,8000; # fast\n"));
  EXPECT_THAT(text, HasSubstr("MA,1000; GO\nWA\n# Here the rest begins.\nMA,0; GO\n"));
}

TEST(RestOfText, AnUnknownStateIsNamedWithItsLine) {
  const auto own = rest_at("pmx-4ex-sa", "ABS\nV1=5\nX1000\nWAITX\nX0\nWAITX\nEND\n", 5);
  ASSERT_FALSE(own);
  EXPECT_THAT(own.error().what, HasSubstr("The state after \"V1=5\" above line 5 is unknown."));
  const auto homed = rest_at("pmx-4ex-sa", "ABS\nHOMEX-\nWAITX\nX1000\nWAITX\nEND\n", 4);
  ASSERT_FALSE(homed);
  EXPECT_THAT(homed.error().what, HasSubstr("The position before line 4 is unknown"));
}

TEST(RestOfText, WhereAnAxisIsStillMovingNothingIsBegun) {
  // Behind the DELAY its turn takes no time.
  const char* text = "ABS\nX100000\nDO1=1\nDELAY=100\nDO1=0\nWAITX\nDO2=1\nEND\n";
  for (const int line : {3, 4, 5}) {
    const auto moving = rest_at("pmx-4ex-sa", text, line);
    ASSERT_FALSE(moving) << "line " << line;
    EXPECT_THAT(moving.error().sentence(),
                HasSubstr("Begin at a line that starts when all axes are at rest."));
  }
  const auto stands = rest_at("pmx-4ex-sa", text, 7);
  EXPECT_TRUE(stands) << stands.error().sentence();
}

TEST(RestOfText, WithoutARehearsalThatCoversItNothingIsBegun) {
  const DeviceType& type = *find_device_type("pmx-4ex-sa");
  const auto rest = rest_of_text(type.language(), {"ABS\nX1000\nWAITX\nX0\nWAITX\nEND\n", 3, 0}, {},
                                 *type.make_catalog({}));
  ASSERT_FALSE(rest);
  EXPECT_THAT(rest.error().what, HasSubstr("does not show the positions at the start of line 4"));
}

}  // namespace
}  // namespace hw::panels
