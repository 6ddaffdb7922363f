#include "gui/surface/layout.h"

#include <algorithm>
#include <cmath>

namespace hw::gui {
namespace {

Tier tier_of(float width, float height) {
  if (width >= 1280 && height >= 780) return Tier::wide;
  if (width >= 960 && height >= 600) return Tier::medium;
  return Tier::narrow;
}

// Places the parts from right to left, those that must never disappear first.
void lay_out_top(Layout& l, const LayoutInput& w) {
  const float height = 56, stop = l.tier == Tier::wide ? 200.0f : 160.0f;
  // A medium window has only the logo, which opens the menu, and the help; a narrow window only the logo.
  const float brand = l.tier == Tier::wide ? 304.0f : l.tier == Tier::medium ? 88.0f : 56.0f;
  l.brand = {0, 0, brand, height};
  l.stop = {w.width - stop, 0, stop, height};
  // Where the link does not fit, the status line shows it.
  const float link_wanted = l.tier == Tier::wide     ? 184.0f
                            : l.tier == Tier::medium ? 128.0f
                            : w.width < 560          ? 0.0f
                                                     : 104.0f;
  l.link = {l.stop.x - link_wanted, 0, link_wanted, height};
  // Tabs become narrower before they become a menu. A width of 120 holds twelve letters, and the state as a
  // shape and a word.
  const float tab_wanted = l.tier == Tier::wide ? 176.0f : 160.0f, tab_least = 120;
  const float room = l.link.x - brand - 48;
  const float share = std::floor(room / static_cast<float>(std::max(w.controllers, 1)));
  l.controller_menu = l.tier == Tier::narrow || share < tab_least;
  l.tab_width = std::clamp(share, tab_least, tab_wanted);
  const float used = l.controller_menu ? std::min(room, 176.0f)
                                       : l.tab_width * static_cast<float>(std::max(w.controllers, 0));
  l.tabs = {brand, 0, std::max(0.0f, used), height};
  l.add = {l.tabs.right(), 0, 48, height};
}

void lay_out_columns(Layout& l, const LayoutInput& w, float top, float bottom) {
  const float height = bottom - top;
  const float left = l.tier == Tier::wide ? std::clamp(w.splitters.left, 264.0f, 400.0f) : 264.0f;
  l.right_is_rail = l.tier == Tier::medium;
  const float right = l.right_is_rail ? 56.0f : std::clamp(w.splitters.right, 240.0f, 400.0f);
  l.left = {0, top, left, height};
  l.right = {w.width - right, top, right, height};
  l.centre = {left, top, w.width - left - right, height};
  if (!l.right_is_rail || !w.right_open) return;
  constexpr float unfolded = 272, centre_at_least = 700;
  l.unfolded = {l.right.x - unfolded, top, unfolded, height};
  l.unfolded_covers = l.centre.width - unfolded < centre_at_least;
  if (!l.unfolded_covers) l.centre.width -= unfolded;
}

void lay_out_strip(Layout& l, const LayoutInput& w, float top, float bottom) {
  constexpr float centre_at_least = 84;  // in windows smaller than the design allows, positions come first
  const float strip = std::min(w.strip_height, std::max((bottom - top) / 2, bottom - top - centre_at_least));
  l.left = {0, top, w.width, strip};
  l.centre = {0, top + strip, w.width, bottom - top - strip};
  l.right = {};
}

}  // namespace

Layout lay_out(const LayoutInput& w) {
  Layout l;
  l.tier = tier_of(w.width, w.height);
  lay_out_top(l, w);
  const float status = l.tier == Tier::narrow ? 32.0f : 36.0f;
  const float bottom = w.height - status;
  l.status = {0, bottom, w.width, status};
  if (l.tier == Tier::narrow)
    lay_out_strip(l, w, l.stop.bottom(), bottom);
  else
    lay_out_columns(l, w, l.stop.bottom(), bottom);
  return l;
}

float below_height(float centre_height, const Splitters& s, Tier tier, float wanted) {
  constexpr float title = 44, row = 20, command = 48, work_at_least = 280, title_from = 620;
  const bool titled = tier == Tier::wide || (tier == Tier::medium && centre_height >= title_from);
  const float least = (titled ? title : 0) + 3 * row + command;
  if (tier == Tier::narrow || centre_height < work_at_least + least) return 0;
  const float set = tier == Tier::medium ? s.below_medium : s.below;
  const float usual = tier == Tier::medium ? Splitters().below_medium : Splitters().below;
  const float given = wanted > 0 && set == usual ? std::min(set, centre_height - wanted) : set;
  return std::clamp(given, least, centre_height - work_at_least);
}

}  // namespace hw::gui
