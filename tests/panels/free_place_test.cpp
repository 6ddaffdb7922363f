// The place of a card: the search that jumps finds what a search of every place finds.
#include "panels/free_place.h"

#include <random>

#include <gtest/gtest.h>

namespace hw::panels {
namespace {

using namespace gui;

constexpr FreePlace::Band band{8, 500, 4};
const ImVec2 card(100, 60);

Widget mover(float left, float top, float width, float height) {
  Widget w;
  w.rect = {ImVec2(left, top), ImVec2(left + width, top + height)};
  w.clip = {ImVec2(0, 0), ImVec2(1000, 1000)};
  w.moving = true;
  return w;
}

std::optional<Rect> tried_one_by_one(const FreePlace& free, ImVec2 wanted) {
  for (float away = 0; away <= band.high; away += band.step)
    for (const float y : {wanted.y - away, wanted.y + away}) {
      const Rect place{ImVec2(wanted.x, y), ImVec2(wanted.x + card.x, y + card.y)};
      if (y >= band.low && y <= band.high && free.leaves(place)) return place;
    }
  return {};
}

TEST(FreePlace, IsTheNearestOfAll) {
  std::mt19937 random(1);
  const auto up_to = [&](int most) { return static_cast<float>(random() % static_cast<unsigned>(most)); };
  int found = 0, none = 0;
  for (int n = 0; n < 2000; ++n) {
    std::vector<Widget> widgets;
    for (unsigned i = random() % 12; i > 0; --i)
      widgets.push_back(mover(up_to(200), up_to(560), 1 + up_to(150), 1 + up_to(120)));
    FreePlace free;
    free.look(widgets, "");
    const ImVec2 wanted(up_to(100), band.low + up_to(492));
    const auto expected = tried_one_by_one(free, wanted), is = free.nearest(wanted, card, band);
    ASSERT_EQ(is.has_value(), expected.has_value()) << n;
    if (is) {
      ASSERT_EQ(is->min.y, expected->min.y) << n;
    }
    (is ? found : none)++;
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 10);
}

TEST(FreePlace, IgnoresWidgetsThatAreScrolledOutOfSight) {
  Widget hidden = mover(0, 100, 100, 60);
  hidden.clip = {ImVec2(0, 300), ImVec2(1000, 400)};
  FreePlace free;
  free.look(std::span(&hidden, 1), "");
  EXPECT_TRUE(free.leaves({ImVec2(0, 100), ImVec2(100, 160)}));
}

TEST(FreePlace, KeepsClearOfTheCardsOfRowsAbove) {
  std::vector<Widget> cards(2);
  for (std::size_t i = 0; i < 2; ++i) {
    const float top = 100 + 100 * static_cast<float>(i);
    cards[i] = mover(0, top, 100, 60);
    cards[i].moving = false, cards[i].card = true;
    cards[i].id = i == 0 ? "first" : "second";
  }
  FreePlace free;
  free.look(cards, "second");
  EXPECT_FALSE(free.leaves({ImVec2(0, 100), ImVec2(100, 160)}));
  EXPECT_TRUE(free.leaves({ImVec2(0, 200), ImVec2(100, 260)})) << "its own place";
}

}  // namespace
}  // namespace hw::panels
