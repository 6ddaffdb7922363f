#include "panels/free_place.h"

#include <algorithm>
#include <cmath>

namespace hw::panels {

using namespace gui;

namespace {

bool overlap(const Rect& a, const Rect& b) {
  return a.min.x < b.max.x && b.min.x < a.max.x && a.min.y < b.max.y && b.min.y < a.max.y;
}

Rect seen(const Widget& w) {
  return {ImVec2(std::max(w.rect.min.x, w.clip.min.x), std::max(w.rect.min.y, w.clip.min.y)),
          ImVec2(std::min(w.rect.max.x, w.clip.max.x), std::min(w.rect.max.y, w.clip.max.y))};
}

bool reached_for(const Widget& w) {
  const bool text = w.kind == Kind::editor || w.kind == Kind::link || w.kind == Kind::row;
  return w.moving || w.stops || (w.usable() && !text);
}

}  // namespace

void FreePlace::look(std::span<const Widget> widgets, std::string_view own) {
  cards_.clear();
  taken_.clear();
  for (const Widget& w : widgets)
    if (w.card) cards_.push_back(w.rect);
  const auto on_a_card = [this](const Widget& w) {
    return std::any_of(cards_.begin(), cards_.end(),
                       [&](const Rect& card) { return card.contains(w.rect.centre()); });
  };
  bool above = true;
  for (const Widget& w : widgets) {
    above = above && w.id != own;
    if (w.card ? !above : !reached_for(w) || on_a_card(w)) continue;
    const Rect r = seen(w);
    if (r.width() > 0 && r.height() > 0) taken_.push_back(r);
  }
}

const Rect* FreePlace::blocker(const Rect& place) const {
  const auto found =
      std::find_if(taken_.begin(), taken_.end(), [&](const Rect& r) { return overlap(r, place); });
  return found == taken_.end() ? nullptr : &*found;
}

/// Jumps past each rectangle in the way: a search pixel by pixel takes longer than all of the frame.
std::optional<float> FreePlace::steps_away(Rect place, const Band& band, bool down) const {
  const float wanted = place.min.y, height = place.height();
  float steps = 0;
  while (place.min.y >= band.low && place.min.y <= band.high) {
    const Rect* in_the_way = blocker(place);
    if (!in_the_way) return steps;
    const float past = down ? in_the_way->max.y - place.min.y : place.max.y - in_the_way->min.y;
    steps += std::ceil(past / band.step);
    place.min.y = wanted + (down ? steps : -steps) * band.step;
    place.max.y = place.min.y + height;
  }
  return {};
}

std::optional<Rect> FreePlace::nearest(ImVec2 wanted, ImVec2 size, const Band& band) const {
  const Rect there{wanted, ImVec2(wanted.x + size.x, wanted.y + size.y)};
  const auto up = steps_away(there, band, false), down = steps_away(there, band, true);
  if (!up && !down) return {};
  const float by = up && (!down || *up <= *down) ? -*up : *down;
  const float y = wanted.y + by * band.step;
  return Rect{ImVec2(wanted.x, y), ImVec2(wanted.x + size.x, y + size.y)};
}

}  // namespace hw::panels
