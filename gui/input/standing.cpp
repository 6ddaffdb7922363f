#include "gui/input/standing.h"

#include <algorithm>

namespace hw::gui {
namespace {

bool same(const Rect& a, const Rect& b) {
  return a.min.x == b.min.x && a.min.y == b.min.y && a.max.x == b.max.x && a.max.y == b.max.y;
}

}  // namespace

Standing::Place& Standing::see(ImGuiID id, const Rect& rect, bool ready, double now_s) {
  auto place = std::find_if(places_.begin(), places_.end(), [&](const Place& p) { return p.id == id; });
  const bool is_new = place == places_.end();
  if (is_new) place = places_.insert(places_.end(), Place{.id = id});
  const bool moved = is_new || !same(place->rect, rect), woke = ready && !place->ready;
  if (moved || woke || !ready) place->since_s = now_s;
  if (moved || woke) place->came_alive = !moved;
  place->rect = rect;
  place->ready = ready;
  place->seen = true;
  return *place;
}

void Standing::end_frame() {
  std::erase_if(places_, [](const Place& p) { return !p.seen; });
  for (Place& p : places_) p.seen = false;
}

}  // namespace hw::gui
