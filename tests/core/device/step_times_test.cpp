// How long a rehearsed program was at each of its parts.
#include "core/device/step_times.h"

#include <gmock/gmock.h>

#include "core/device/registry.h"
#include "core/device/sequence_draft.h"
#include "core/device/track_path.h"

namespace hw {
namespace {

using testing::ElementsAre;

TEST(StepTimes, ACommandOfNoPartBelongsToThePartBefore) {
  Rehearsal r;
  r.duration_s = 10;
  // Command 3 stands in a subroutine, which no part owns; -1 goes on.
  const std::pair<double, int> turns[] = {{0, 0}, {1, 1}, {3, 3}, {4, -1}, {5, 2}, {9, 1}};
  for (const auto& [t, command] : turns) r.at_work(t, command);
  const std::vector<int> parts{-1, 0, 1, -1};
  EXPECT_THAT(seconds_of_parts(r, parts), ElementsAre(4 + 1, 4));
}

TEST(StepTimes, OfWhatIsNotListedThereIsNothing) {
  Rehearsal r;
  r.duration_s = 10;
  EXPECT_TRUE(seconds_of_parts(r, std::vector<int>{0, 1}).empty());
}

/// By line of the text.
std::vector<double> seconds_of_lines(const char* model, const char* text) {
  const Language& language = find_device_type(model)->language();
  const auto rehearsed = language.rehearse(text, {});
  EXPECT_TRUE(rehearsed) << rehearsed.error().sentence();
  return seconds_of_parts(*rehearsed, lines_of_commands(language.analyse(text, 0), 0));
}

TEST(StepTimes, AMoveHasTheTimeThatIsWaitedForItAndADelayItsOwn) {
  const auto pmx = seconds_of_lines("pmx-4ex-sa", "X5000\nWAITX\nDELAY=3000\nX0\nWAITX\nEND\n");
  ASSERT_GE(pmx.size(), 4u);
  EXPECT_NEAR(pmx[2], 3, 0.1);
  EXPECT_GT(pmx[0], 1);
  EXPECT_NEAR(pmx[0], pmx[3], 0.1) << "there and back";
  const auto board = seconds_of_lines("vme58", "AX;\nMR5000;\nGO;\nWT3000;\nMR-5000;\nGO;\n");
  ASSERT_EQ(board.size(), 6u);
  EXPECT_NEAR(board[3], 3, 0.1);
  EXPECT_NEAR(board[2], board[5], 0.01) << "there and back";
  const auto vxm = seconds_of_lines("vxm", "I1M400\nP30\nI1M-400\n");
  ASSERT_EQ(vxm.size(), 3u);
  EXPECT_NEAR(vxm[1], 3, 0.1);
  EXPECT_NEAR(vxm[0], vxm[2], 0.05) << "there and back";
}

}  // namespace
}  // namespace hw
