// A sequence of two controllers with one axis each: what each of them does, act by act.
#include "core/device/pieces_together.h"

#include <gmock/gmock.h>

#include "core/device/registry.h"

namespace hw {
namespace {

namespace seq = sequence;  // its names are those of commands too
using testing::ElementsAre;
using testing::HasSubstr;

struct PiecesTogetherTest : ::testing::Test {
  Catalog one = find_device_type("dmx-k-sa")->make_catalog({{"id", "01"}}).value();
  Catalog two = find_device_type("dmx-k-sa")->make_catalog({{"id", "02"}}).value();
  Catalog bus = catalog_together(std::vector<const Catalog*>{&one, &two}).value();
  seq::Sequence s;

  PiecesTogetherTest() {
    s.unit = "mm";
    s.axes = {{"01", 100}, {"02", 100}};
    s.pen_down = {{seq::Output{1, true}}};
    s.pen_up = {{seq::Output{1, false}}};
    s.steps = {{seq::Pen{false}}, {seq::Speed{{10, 0, 0}}}};
    go(0, 0);
  }
  void go(double x, double y) {
    seq::Move m;
    m.to[0] = x, m.to[1] = y;
    s.steps.push_back({m});
  }
  void draw_a_line() {
    s.steps.push_back({seq::Pen{true}});
    go(30, 40);
    s.steps.push_back({seq::Pen{false}});
  }
  std::vector<Pieces> parts(int from = 0) {
    auto made = pieces_together(s, bus, from);
    EXPECT_TRUE(made) << made.error().sentence();
    return made ? std::move(*made) : std::vector<Pieces>(2);
  }
};

std::vector<std::string> acts_of(const Pieces& pieces) {
  std::vector<std::string> all;
  for (const Piece& piece : pieces.all)
    for (const PieceAct& act : piece.does) {
      std::string sentence = "-";
      if (const auto* move = act.what ? std::get_if<intent::MoveTo>(&*act.what) : nullptr)
        sentence = "to " + std::to_string(move->targets.at(0).value.value) + " at " +
                   std::to_string(std::llround(move->speed.value));
      if (const auto* output = act.what ? std::get_if<intent::SetOutput>(&*act.what) : nullptr)
        sentence = output->on ? "on" : "off";
      all.push_back(sentence);
    }
  return all;
}

TEST_F(PiecesTogetherTest, EachGoesAsFastAsItTakesToBeThereTogether) {
  draw_a_line();
  const auto both = parts();
  EXPECT_THAT(acts_of(both[0]), ElementsAre("off", "to 0 at 1000", "on", "to 3000 at 600", "off"));
  EXPECT_THAT(acts_of(both[1]), ElementsAre("-", "to 0 at 1000", "-", "to 4000 at 800", "-"));
  EXPECT_FALSE(both[0].tool.empty()) << "the first one switches it";
  EXPECT_TRUE(both[1].tool.empty());
}

TEST_F(PiecesTogetherTest, ItTakesAsLongAsTheLongestOfEachAct) {
  s.steps[1] = {seq::Speed{{10, 1, 100}}};
  s.steps.push_back({seq::Pen{true}});
  go(0, 20);  // 2 s at 10 mm/s, and its ramps
  s.steps.push_back({seq::Delay{500}});
  go(5, 20);
  s.steps.push_back({seq::Pen{false}});
  const auto seconds = least_seconds(parts(), bus);
  ASSERT_EQ(seconds.size(), 1u);
  EXPECT_NEAR(seconds[0], 2 + 0.5 + 0.5 + 4 * 0.045, 0.02) << "a ramp from 1 to 10 costs 45 ms";
  s.steps[1] = {seq::Pen{false}};
  EXPECT_TRUE(least_seconds(parts(), bus).empty()) << "at speeds that nobody has said";
}

TEST_F(PiecesTogetherTest, OneThatStaysHasNothingToDo) {
  s.steps.push_back({seq::Pen{true}});
  go(0, 5);
  s.steps.push_back({seq::Pen{false}});
  const auto both = parts();
  EXPECT_EQ(acts_of(both[0])[3], "-");
  EXPECT_EQ(acts_of(both[1])[3], "to 500 at 1000");
}

TEST_F(PiecesTogetherTest, TheRestBeginsWithTheToolUpAtTheStartOfItsLine) {
  draw_a_line();
  s.steps.push_back({seq::Pen{true}});
  go(0, 0);
  s.steps.push_back({seq::Pen{false}});
  const auto both = parts(static_cast<int>(s.steps.size()) - 2);
  EXPECT_THAT(acts_of(both[0]), ElementsAre("off", "to 3000 at 1000", "on", "to 0 at 600", "off"));
  EXPECT_THAT(acts_of(both[1]), ElementsAre("-", "to 4000 at 1000", "-", "to 0 at 800", "-"));
}

TEST_F(PiecesTogetherTest, ADelayBeginsWhenAllHaveEnded) {
  s.steps.push_back({seq::Pen{true}});
  go(0, 5);
  s.steps.push_back({seq::Delay{200}});
  s.steps.push_back({seq::Pen{false}});
  const auto both = parts();
  EXPECT_THAT(acts_of(both[0]), ElementsAre("off", "to 0 at 1000", "on", "-", "-", "off"));
  EXPECT_EQ(both[0].all[0].does[3].then, Duration{});
  EXPECT_EQ(both[0].all[0].does[4].then, Millis(200));
}

TEST_F(PiecesTogetherTest, AnArcBecomesChords) {
  go(10, 0);
  s.steps.push_back({seq::Pen{true}});
  s.steps.push_back({seq::Arc{0, 0, 360, {}}});
  s.steps.push_back({seq::Pen{false}});
  s.tolerance = 1;
  EXPECT_EQ(acts_of(parts()[0]).size(), 1 + 2 + 1 + 7 + 1u);
}

TEST_F(PiecesTogetherTest, AStepThatCannotBeSharedIsRefusedWithItsNumber) {
  s.steps.push_back({seq::Home{}});
  const auto made = pieces_together(s, bus, 0);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().what, HasSubstr("Step 4 (home)"));
}

TEST_F(PiecesTogetherTest, ControllersOfSeveralAxesAreNone) {
  const Catalog pmx = find_device_type("pmx-4ex-sa")->make_catalog({{"id", "00"}}).value();
  EXPECT_FALSE(catalog_together(std::vector<const Catalog*>{&pmx, &one}));
  EXPECT_FALSE(catalog_together(std::vector<const Catalog*>{&one}));
}

}  // namespace
}  // namespace hw
