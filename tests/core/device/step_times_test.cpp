// How long a rehearsed program was at each of its parts.
#include "core/device/step_times.h"

#include <gmock/gmock.h>

namespace hw {
namespace {

using testing::ElementsAre;

TEST(StepTimes, ACommandOfNoPartBelongsToThePartBefore) {
  Rehearsal r;
  r.duration_s = 10;
  // Command 3 stands in a subroutine, which no part owns; the fourth event is of another program.
  r.events = {{0, "", 0, 0}, {1, "", 0, 1}, {3, "", 0, 3}, {4, "", 1, 0}, {5, "", 0, 2}, {9, "", 0, 1}};
  const std::vector<int> parts{-1, 0, 1, -1};
  EXPECT_THAT(seconds_of_parts(r, parts), ElementsAre(4 + 1, 4));
}

TEST(StepTimes, OfWhatIsNotListedThereIsNothing) {
  Rehearsal r;
  r.duration_s = 10;
  EXPECT_TRUE(seconds_of_parts(r, std::vector<int>{0, 1}).empty());
}

}  // namespace
}  // namespace hw
