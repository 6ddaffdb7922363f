// Which steps of the whole those of a rest are.
#include "core/sequence/rows_of_rest.h"

#include <gmock/gmock.h>

#include "core/sequence/rest.h"
#include "core/sequence/within_loop.h"

namespace hw::sequence {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Sequence of_steps(StepList steps) {
  Sequence s;
  s.axes = {{"X", 1}, {"Y", 1}};
  s.steps = std::move(steps);
  return s;
}
Step goes_to(double x) {
  Move m;
  m.to[0] = x;
  return {m};
}
/// Behind those that lead there, which are of none.
std::vector<int> rows_behind(const Rest& rest, const Sequence& whole) {
  std::vector<int> rows = rows_of_rest(rest.sequence, whole);
  if (rows.size() < rest.leading) return {};
  const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(rest.leading);
  EXPECT_THAT(std::vector<int>(rows.begin(), begin), Each(-1));
  return {begin, rows.end()};
}

TEST(RowsOfRest, AreThoseFromTheStepOnAlsoWhereWhatLeadsThereLooksLikeTheStepsBefore) {
  const Sequence s =
      of_steps({goes_to(1), {WaitMotion{}}, {Repeat{2, {goes_to(2), {Delay{5}}}}}, goes_to(3)});
  EXPECT_THAT(rows_behind(*rest_from(s, 2), s), ElementsAre(2, 3, 4, 5));
  EXPECT_THAT(rows_behind(*rest_from(s, 3), s), ElementsAre(5));
  EXPECT_THAT(rows_behind(*rest_from(s, 0), s), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(RowsOfRest, OfAPassOfALoopThoseOfTheLoop) {
  const Sequence s = of_steps({goes_to(0), {Repeat{3, {goes_to(1), goes_to(2)}}}, goes_to(9)});
  EXPECT_THAT(rows_behind(rest_within(s, 3, 0)->rest, s), ElementsAre(3, 1, 2, 3, 4))
      << "two passes are left";
  EXPECT_THAT(rows_behind(rest_within(s, 3, 2)->rest, s), ElementsAre(3, 4)) << "the last one";
  const Sequence deep = of_steps({{Repeat{2, {goes_to(1), {Repeat{2, {goes_to(2), goes_to(3)}}}}}}});
  EXPECT_THAT(rows_behind(rest_within(deep, 4, 0)->rest, deep), ElementsAre(4, 2, 3, 4, 0, 1, 2, 3, 4));
}

TEST(RowsOfRest, OfALoopWithoutEndOnesBeforeItOrOfOneOfItsPasses) {
  const Sequence s = of_steps({goes_to(5), {WaitMotion{}}, {Repeat{0, {goes_to(1), {WaitMotion{}}}}}});
  EXPECT_THAT(rows_behind(*rest_from(s, 1), s), ElementsAre(1, 2, 3, 4));
  const Sequence other = of_steps({goes_to(5), {WaitMotion{}}, {Repeat{0, {goes_to(1), {Delay{5}}}}}});
  EXPECT_THAT(rows_behind(rest_within(other, 4, 7)->rest, other), ElementsAre(4, 2, 3, 4));
}

TEST(RowsOfRest, AreNotKnownOnceTheWholeHasBeenChanged) {
  Sequence s = of_steps({goes_to(0), goes_to(1), goes_to(2)});
  const Rest rest = *rest_from(s, 1);
  s.steps[1] = goes_to(7);
  EXPECT_THAT(rows_of_rest(rest.sequence, s), IsEmpty());
  EXPECT_THAT(rows_of_rest(of_steps({goes_to(3)}), s), Each(-1)) << "nothing of it is a rest";
}

}  // namespace
}  // namespace hw::sequence
