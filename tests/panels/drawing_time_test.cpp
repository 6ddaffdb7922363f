// How long what is being drawn will still take.
#include "panels/drawing/drawing_tab.h"
#include "tests/panels/drawing_stage.h"

namespace hw::panels {
namespace {

using ::testing::HasSubstr;

TEST_F(DrawingTabTest, ADrawingThatGoesThroughTheBufferShowsWhatIsLeft) {
  std::string many("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");
  for (int n = 0; n < 700; ++n)
    many += "0\nLINE\n8\ncut\n10\n" + std::to_string(2 * n) + "\n20\n0\n11\n" + std::to_string(2 * n + 1) +
            "\n21\n1\n";
  ASSERT_TRUE(write_file(file, many + "0\nENDSEC\n0\nEOF\n"));
  drop();
  EXPECT_THAT(s.value("drawing/problem"), HasSubstr("Cut draws it all the same, in "))
      << "it is too long for the controller's memory";
  s.click("drawing/cut");
  s.click("drawing/ask_cut/yes");
  const auto* asked = s.last<intent::RunInPieces>();
  ASSERT_TRUE(asked);
  ASSERT_GE(asked->pieces->all.front().draws, 0) << "through the buffer";
  s.settle(IntentState::done);
  s.now.pieces.running = s.now.pieces.draws = true;
  s.now.pieces.drawing = s.last<intent::RunInPieces>()->pieces->drawing;
  s.now.pieces.total = 700, s.now.pieces.step = 0;
  s.stage.frames(3);
  EXPECT_THAT(s.value("drawing/cut_progress"), HasSubstr(" left"));
}

TEST(TimeLeft, GoesDownWhileAStepIsAtWork) {
  DrawingJob::Made made;
  made.conversion.begins = {0, 4};
  made.conversion.sequence.steps.resize(8);
  made.chain_seconds = {10, 20};
  EXPECT_DOUBLE_EQ(*DrawingJob::seconds_left(made, 6, 50), 20);
  EXPECT_DOUBLE_EQ(*DrawingJob::seconds_left(made, 6, 50, 4), 16);
  EXPECT_DOUBLE_EQ(*DrawingJob::seconds_left(made, 6, 50, 40), 0);
}

TEST(TimeLeft, OfAStepIsCountedFromWhereItWasReportedFirst) {
  StepClock clock;
  PiecesState pieces;
  pieces.running = true;
  pieces.step = 3;
  const auto at = [&](double s) {
    clock.follow(pieces, Instant(from_seconds(s)));
    return clock.time_at_step_s();
  };
  EXPECT_DOUBLE_EQ(at(10), 0);
  EXPECT_DOUBLE_EQ(at(12), 2);
  pieces.held = true;
  EXPECT_DOUBLE_EQ(at(20), 2);
  pieces.held = false;
  EXPECT_DOUBLE_EQ(at(21), 3);
  pieces.step = 4;
  EXPECT_DOUBLE_EQ(at(22), 0);
  EXPECT_DOUBLE_EQ(at(23), 1);
}

TEST(TimeLeft, IsNotCountedFromBeforeItWasSeenNorWhileItIsOnlySent) {
  StepClock clock;
  PiecesState pieces;
  pieces.running = true;  // at no step yet, as when nothing runs
  const auto at = [&](double s, bool at_work) {
    clock.follow(pieces, Instant(from_seconds(s)), at_work);
    return clock.time_at_step_s();
  };
  EXPECT_DOUBLE_EQ(at(100, false), 0);
  EXPECT_DOUBLE_EQ(at(130, false), 0) << "it is being sent";
  EXPECT_DOUBLE_EQ(at(131, true), 1);
  pieces.running = false;
  EXPECT_DOUBLE_EQ(at(140, true), 1);
  pieces.running = true;
  EXPECT_DOUBLE_EQ(at(150, true), 0) << "it begins anew";
}

TEST_F(DrawingTabTest, TheBarGoesOnWhereTheControllerReportsNoSteps) {
  drop();
  two_hundred_pulses_in_a_mm();
  s.stage.frames(6);
  s.click("drawing/cut");
  EXPECT_THAT(s.value("drawing/ask_cut/says"), HasSubstr("once the controller has it"));
  s.click("drawing/ask_cut/yes");
  s.settle(IntentState::done);
  s.now.pieces.running = true;
  s.now.pieces.drawing = s.last<intent::RunInPieces>()->pieces->drawing;
  s.now.pieces.total = 1, s.now.pieces.step = 0;
  s.stage.frames(3);
  EXPECT_THAT(s.value("drawing/cut_progress"), HasSubstr("is being sent the drawing"));
  s.now.program.run = RunState::running;
  s.stage.frames(3);
  EXPECT_THAT(s.value("drawing/cut_progress"), HasSubstr("The drawing is being cut, "));
  s.now.program.run = RunState::waiting;
  s.stage.frames(3);
  EXPECT_THAT(s.value("drawing/cut_progress"), HasSubstr("The drawing is being cut, ")) << "it waits there";
  s.now.pieces.running = false, s.now.pieces.done = 1;
  s.now.program.run = RunState::idle;
  s.stage.frames(3);
  EXPECT_EQ(s.value("drawing/cut_progress"), "Everything is drawn");
}

}  // namespace
}  // namespace hw::panels
