// What only the eye sees: colours, captions, and what stands where room is short.
#include <algorithm>

#include <gtest/gtest.h>

#include "panels/program/program.h"
#include "tests/panels/console_stage.h"
#include "tests/panels/full_catalog.h"
#include "tests/panels/panel_stage.h"

namespace hw::panels {
namespace {

using namespace gui;
using test::PanelStage;

// ---- threads

struct Threads : testing::Test {
  Program panel;
  static Catalog catalog() {
    Catalog c = test::full_catalog();
    c.program.compiled = false;
    return c;
  }
  void load(PanelStage& s) {
    auto& texts = s.tab.desk().programs.texts;
    texts.set_text(0, "; remark\nI1\nL9,I2\n");
    texts.loaded(0, texts.text(0), Instant());
    for (int n = 0; n < 2; ++n) s.now.threads[static_cast<std::size_t>(n)].known = true;
    s.now.threads[0].run = RunState::running;
    s.now.threads[0].line = 1;
    s.now.axis_count = 4;
    s.stage.frames(3);
  }
};

TEST_F(Threads, TheLineOfTheTextStandsBesideTheCompiledOne) {
  PanelStage s(panel, 864, 700, 1, Tier::wide, true, catalog());
  load(s);
  EXPECT_EQ(s.value("thread/0/line"), "1");
  EXPECT_EQ(s.value("thread/0/source"), "3 L9,I2") << "command 1 comes from the third line of the text";
  EXPECT_EQ(s.stage.find("thread/1/source"), nullptr) << "an idle one works on nothing";
}

TEST_F(Threads, WithoutRoomForBothTheSourceLineStays) {
  PanelStage s(panel, 650, 520, 1, Tier::medium, true, catalog());
  load(s);
  const Widget *source = s.stage.find("thread/0/source"), *compiled = s.stage.find("thread/0/line"),
               *stop = s.stage.find("thread/0/stop");
  ASSERT_TRUE(source && compiled && stop);
  EXPECT_LT(compiled->rect.width(), 20);
  EXPECT_GT(source->rect.width(), 60);
  EXPECT_LE(source->rect.max.x, stop->rect.min.x);
}

TEST_F(Threads, ATornProgramIsRunOnlyOnTheUsersWord) {
  PanelStage s(panel, 864, 700, 1, Tier::wide, true, catalog());
  load(s);
  s.now.slots_torn = 1;
  s.stage.frames(30);
  s.click("thread/1/run");
  ASSERT_TRUE(s.last<intent::RunProgram>());
  EXPECT_FALSE(s.last<intent::RunProgram>()->as_it_is);
  s.settle(IntentState::refused, "It is not what was sent.");
  s.stage.frames(30);
  EXPECT_EQ(s.value("thread/1/refused"), "It is not what was sent.");
  s.click("thread/1/as_it_is");
  EXPECT_TRUE(s.last<intent::RunProgram>()->as_it_is);
  EXPECT_EQ(s.last<intent::RunProgram>()->slot, 1);
  s.settle(IntentState::done);
  EXPECT_EQ(s.stage.find("thread/1/refused"), nullptr);
}

TEST_F(Threads, AChangedTextIsNotTakenForTheOneThatRuns) {
  PanelStage s(panel, 864, 700, 1, Tier::wide, true, catalog());
  load(s);
  s.tab.desk().programs.texts.set_text(0, "I7\n");
  s.stage.frames(3);
  EXPECT_EQ(s.stage.find("thread/0/source"), nullptr);
}

// ---- bench

ImU32 pixel(ConsoleStage& s, ImVec2 at) {
  return s.stage.surface.pixel(static_cast<int>(at.x), static_cast<int>(at.y)) | IM_COL32_A_MASK;
}

TEST(BenchDrawing, ATrippedBreakerHasAWhiteButtonInBothThemes) {
  for (const bool dark : {true, false}) {
    ConsoleStage s(1440, 900, 1, dark);
    Example& a = s.add();
    s.run(0.1);
    const auto centre = [&] {
      const Widget* breaker = s.stage.find("bench/breaker");
      return breaker ? ImVec2(breaker->rect.min.x + 10, breaker->rect.centre().y) : ImVec2();
    };
    ASSERT_GT(centre().x, 0);
    s.stage.surface.render();
    EXPECT_NE(pixel(s, centre()), IM_COL32_WHITE) << "it is in";
    a.bench.breakers_out = 1;
    s.run(0.1);
    s.stage.surface.render();
    EXPECT_EQ(pixel(s, centre()), IM_COL32_WHITE) << (dark ? "dark" : "light");
  }
}

/// How many pixels of the rectangle are not its ground.
int ink_in(ConsoleStage& s, const Rect& r) {
  const ImU32 ground = pixel(s, r.min);
  int ink = 0;
  for (float y = r.min.y; y < r.max.y; ++y)
    for (float x = r.min.x; x < r.max.x; ++x) ink += pixel(s, ImVec2(x, y)) != ground;
  return ink;
}

TEST(BenchDrawing, ACaptionStandsOverTheButtonsOfOneMotor) {
  Catalog with = example_catalog();
  with.bench.buttons[0].caption = with.bench.buttons[1].caption = "Motor 1";
  int ink[2];
  float top[2];
  for (const bool captioned : {false, true}) {
    ConsoleStage s;
    s.add(captioned ? with : example_catalog());
    s.run(0.1);
    const Widget *first = s.stage.find("bench/button/1-"), *power = s.stage.find("bench/power");
    ASSERT_TRUE(first && power);
    s.stage.surface.render();
    const Rect above{ImVec2(first->rect.min.x, first->rect.min.y - 18),
                     ImVec2(first->rect.min.x + 52, first->rect.min.y - 3)};
    ink[captioned] = ink_in(s, above);
    top[captioned] = first->rect.min.y - power->rect.min.y;
  }
  EXPECT_EQ(ink[0], 0);
  EXPECT_GT(ink[1], 60) << "seven letters";
  EXPECT_EQ(top[1] - top[0], 20) << "the buttons make room";
}

// ---- where room is short

TEST(ShortOfRoom, EachPanelTabCanBeReachedAtThreeHundredPerCent) {
  ConsoleStage s(480, 300, 3);
  s.add(test::full_catalog());
  s.run(0.1);
  std::vector<std::string> ids;
  for (const Widget& w : s.stage.surface.screen().registry().widgets())
    if (w.id.starts_with("tab/")) ids.emplace_back(w.id);
  ASSERT_GE(ids.size(), 5u);
  float all = 0;
  for (const std::string& id : ids) all += s.stage.find(id)->rect.width();
  ASSERT_GT(all, 480 * 3) << "the row is wider than the window";
  // From one to the next, as a hand does it: the chosen one stands so that its neighbours are seen.
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Widget* next = s.stage.find(ids[i]);
    ASSERT_TRUE(next);
    EXPECT_TRUE(next->in_view()) << ids[i];
    ASSERT_TRUE(s.hand.click(ids[i]).has_value()) << ids[i];
    s.run(0.1);
    const Widget* chosen = s.stage.find(ids[i]);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->value, "on");
    EXPECT_GE(chosen->rect.min.x, 0) << ids[i];
    EXPECT_LE(chosen->rect.max.x, 480 * 3) << ids[i];
  }
}

TEST(ShortOfRoom, AMovingAxisOfEightShowsItsSpeedWholeOrNotAtAll) {
  for (const int width : {1440, 1024}) {
    Catalog c = example_catalog(8);
    c.step_word = "counts";
    c.queue_depth = 200;
    ConsoleStage s(width, width == 1440 ? 900 : 700);
    Example& a = s.add(c);
    a.now.axes[0].activity = Activity::moving;
    a.now.axes[0].direction = 1;
    a.now.axes[0].speed = Pps(200'000);
    a.now.queue_free.fill(200);
    a.now.queue_free[0] = 188;
    a.now.queue_known = 0x3;
    s.run(0.2);
    EXPECT_EQ(s.value("dro/1/queue"), "12 of 200");
    EXPECT_EQ(s.value("dro/2/queue"), "0 of 200");
    EXPECT_EQ(s.value("dro/3/queue"), "?");
    s.stage.surface.render();
    const Widget* queue = s.stage.find("dro/1/queue");
    ASSERT_TRUE(queue);
    EXPECT_GT(ink_in(s, queue->rect), 40) << width << ": the words are there";
    const Widget* empty = s.stage.find("dro/2/queue");
    const Widget* not_known = s.stage.find("dro/3/queue");
    ASSERT_TRUE(empty && not_known);
    EXPECT_EQ(ink_in(s, empty->rect), ink_in(s, not_known->rect)) << width << ": an empty queue is quiet";
  }
}

}  // namespace
}  // namespace hw::panels
