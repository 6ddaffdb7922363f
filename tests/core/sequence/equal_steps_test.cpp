// Steps differ if any part of them does. Each field is changed, one at a time.
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "core/sequence/sequence.h"

namespace hw::sequence {
namespace {

void change(double& value) { value += 1; }
void change(int& value) { value += 1; }
void change(bool& value) { value = !value; }
void change(OwnSpeeds& own) { own.emplace(); }
void change(StepList& steps) { steps.emplace_back(); }
void change(Plane& plane) { plane.up += 1; }
void change(Step::Body& body) { body = Comment{"another"}; }

/// `tie` names the fields of a value.
template <class T, class Tie>
void expect_each_field_to_count(const Tie& tie) {
  T same{}, changed{};
  EXPECT_EQ(same, changed);
  constexpr std::size_t count = std::tuple_size_v<decltype(tie(changed))>;
  [&]<std::size_t... field>(std::index_sequence<field...>) {
    (
        [&] {
          changed = T{};
          change(std::get<field>(tie(changed)));
          EXPECT_FALSE(changed == same) << "field " << field;
        }(),
        ...);
  }
  (std::make_index_sequence<count>());
}

TEST(EqualSteps, EachFieldCounts) {
  expect_each_field_to_count<Contour>([](Contour& c) {
    auto& [x, y, lead_in, ends_ramped, own, steps, plane] = c;
    return std::tie(x, y, lead_in, ends_ramped, own, steps, plane);
  });
  expect_each_field_to_count<Repeat>([](Repeat& r) {
    auto& [times, steps] = r;
    return std::tie(times, steps);
  });
  expect_each_field_to_count<Step>([](Step& s) {
    auto& [body, skipped] = s;
    return std::tie(body, skipped);
  });
}

}  // namespace
}  // namespace hw::sequence
