// When frames are drawn: never so that something shown stays old, and none at rest.
#include "gui/surface/frame_pacer.h"

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

struct Loop {
  FramePacer pacer;
  double now_s = 0;
  FramePacer::Needs needs{};
  /// As the window's loop does it; `during` happens while a frame is drawn.
  int frames_in(double seconds, auto during) {
    int frames = 0;
    for (const double end = now_s + seconds; now_s < end; now_s += 0.001)
      if (pacer.is_due(now_s, needs)) {
        pacer.begin_frame(now_s);
        during(frames++);
      }
    return frames;
  }
  int frames_in(double seconds) {
    return frames_in(seconds, [](int) {});
  }
};

TEST(FramePacer, AtRestNothingIsDrawn) {
  Loop loop;
  EXPECT_GT(loop.frames_in(1), 0) << "the first frames";
  EXPECT_EQ(loop.frames_in(60), 0);
}

TEST(FramePacer, NewsAreDrawnAndSettled) {
  Loop loop;
  loop.frames_in(1);
  EXPECT_TRUE(loop.pacer.news()) << "the window sleeps";
  EXPECT_FALSE(loop.pacer.news()) << "and need be woken once";
  EXPECT_EQ(loop.frames_in(1), 2) << "a list that has grown is scrolled to its end in the second";
  EXPECT_TRUE(loop.pacer.news());
}

TEST(FramePacer, NewsThatComeWhileAFrameIsDrawnAreDrawnInTheNext) {
  Loop loop;
  loop.frames_in(1);
  loop.pacer.touched(1);
  int last = -1;
  const int frames = loop.frames_in(1, [&](int frame) {
    EXPECT_TRUE(frame != 0 || loop.pacer.news());
    last = frame;
  });
  EXPECT_EQ(frames, 3);
  EXPECT_EQ(last, 2);
}

TEST(FramePacer, NoMoreThanSixtyASecond) {
  Loop loop;
  const int frames = loop.frames_in(1, [&](int) { static_cast<void>(loop.pacer.news()); });
  EXPECT_GT(frames, 50);
  EXPECT_LE(frames, 63);
}

TEST(FramePacer, AWidgetThatShowsTimeIsDrawnWhenDue) {
  Loop loop;
  loop.needs.wake_in_s = 0.5;
  loop.frames_in(1);
  EXPECT_EQ(loop.frames_in(5), 10);
}

}  // namespace
}  // namespace hw::gui
