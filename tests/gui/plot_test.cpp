#include "gui/widgets/plot.h"

#include <gmock/gmock.h>

#include "tests/gui/stage.h"

namespace hw::gui {
namespace {

TEST(Plot, GridLinesStandAtRoundNumbers) {
  EXPECT_DOUBLE_EQ(grid_step({0, 600}, 6), 100);
  EXPECT_DOUBLE_EQ(grid_step({-20, 230}, 5), 50);
  EXPECT_DOUBLE_EQ(grid_step({0, 0.07f}, 4), 0.02);
  EXPECT_GT(grid_step({5, 5}, 4), 0) << "an empty range has lines too";
}

TEST(Plot, ValuesBetweenPoints) {
  const float x[] = {0, 10, 10, 20}, y[] = {0, 100, 200, 200};
  const PlotTrace trace{x, y};
  float v = 0;
  EXPECT_TRUE(value_at(trace, 5, v));
  EXPECT_FLOAT_EQ(v, 50);
  EXPECT_TRUE(value_at(trace, 15, v));
  EXPECT_FLOAT_EQ(v, 200);
  EXPECT_FALSE(value_at(trace, 21, v));
  EXPECT_FALSE(value_at(PlotTrace{}, 0, v));
}

struct PlotStage {
  std::vector<float> x, y;
  bool dashed = false;
  std::vector<std::size_t> gaps;
  PlotCursor cursor;
  Stage stage{in_window([this](Ui& ui) {
                PlotOptions o;
                o.title = "position, counts", o.x_unit = "ms";
                o.x = {0, 100}, o.y = {0, 100};
                o.width = 400, o.height = 200;
                o.empty = "Nothing yet.";
                const PlotTrace trace{x, y, Tone::motion, 2, dashed, "encoder 100", false, gaps};
                plot(ui, "plot", "Plot", {&trace, 1}, o, cursor);
              }),
              440, 240};
};

TEST(Plot, TheCursorShowsTheValueUnderTheMouse) {
  PlotStage p;
  for (int i = 0; i <= 100; ++i) p.x.push_back(static_cast<float>(i)), p.y.push_back(static_cast<float>(i));
  p.stage.frames(2);
  EXPECT_FALSE(p.stage.find("plot/cursor"));
  p.stage.push(InputEvent::mouse_move(16 + 52 + (400 - 68) / 2, 100, p.stage.now_s));
  p.stage.frames(2);
  const Widget* w = p.stage.find("plot/cursor");
  ASSERT_TRUE(w);
  EXPECT_THAT(std::string(w->value), ::testing::StartsWith("50."));
  EXPECT_THAT(std::string(w->value), ::testing::HasSubstr("encoder 50"));
}

TEST(Plot, AGapIsDrawnAsAGapAndHasNoValue) {
  PlotStage p;
  for (int i = 0; i <= 100; ++i)
    if (i <= 30 || i >= 70) p.x.push_back(static_cast<float>(i)), p.y.push_back(static_cast<float>(i));
  const auto is_drawn_in_the_gap = [&p] {
    bool drawn = false;
    const Draw draw = p.stage.draw;
    p.stage.draw = [&](Ui& ui) {
      draw(ui);
      ImGui::Begin("test");
      // A stroke is made of corners: one across the gap has its triangle there.
      const ImDrawList* list = ImGui::GetWindowDrawList();
      const float middle = 16 + 52 + (400 - 68) / 2.0f;
      const ImU32 colour = ui[Tone::motion];
      for (int i = 0; i + 2 < list->IdxBuffer.Size; i += 3) {
        float left = 1e9f, right = 0;
        bool of_trace = true;
        for (int k = 0; k < 3; ++k) {
          const ImDrawVert& v = list->VtxBuffer[list->IdxBuffer[i + k]];
          left = std::min(left, v.pos.x), right = std::max(right, v.pos.x);
          of_trace = of_trace && (v.col & ~IM_COL32_A_MASK) == (colour & ~IM_COL32_A_MASK);
        }
        drawn = drawn || (of_trace && left < middle - 20 && right > middle + 20);
      }
      ImGui::End();
    };
    p.stage.frames(2);
    p.stage.draw = draw;
    return drawn;
  };
  EXPECT_TRUE(is_drawn_in_the_gap());
  for (std::size_t i = 1; i < p.x.size(); ++i)
    if (p.x[i] - p.x[i - 1] > 4) p.gaps.push_back(i);
  EXPECT_FALSE(is_drawn_in_the_gap());
  p.stage.push(InputEvent::mouse_move(16 + 52 + (400 - 68) / 2, 100, p.stage.now_s));
  p.stage.frames(2);
  const Widget* w = p.stage.find("plot/cursor");
  ASSERT_TRUE(w);
  EXPECT_THAT(std::string(w->value), ::testing::Not(::testing::HasSubstr("encoder")));
}

std::size_t vertices_of(PlotStage& p) {
  std::size_t vertices = 0;
  const Draw draw = p.stage.draw;
  p.stage.draw = [&](Ui& ui) {
    draw(ui);
    ImGui::Begin("test");
    vertices = static_cast<std::size_t>(ImGui::GetWindowDrawList()->VtxBuffer.Size);
    ImGui::End();
  };
  p.stage.frames(2);
  p.stage.draw = draw;
  return vertices;
}

TEST(Plot, ADashedTraceIsManyStrokesAndNothingElse) {
  PlotStage p;
  p.x = {0, 50, 100}, p.y = {10, 90, 10};
  const std::size_t solid = vertices_of(p);
  p.dashed = true;
  const std::size_t dashed = vertices_of(p), strokes = 40;
  EXPECT_GT(dashed, solid + 2 * strokes);
  EXPECT_LT(dashed, solid + 1000) << "each stroke by itself, not the whole trace again";
}

TEST(Plot, ManyPointsAreNoMoreThanTwoAColumn) {
  PlotStage p;
  for (int i = 0; i < 100'000; ++i)
    p.x.push_back(static_cast<float>(i) / 1000), p.y.push_back(static_cast<float>(i % 97));
  EXPECT_LT(vertices_of(p), 332u * 2 * 5 + 2000);
}

}  // namespace
}  // namespace hw::gui
