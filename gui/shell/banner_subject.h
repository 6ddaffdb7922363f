#pragma once
// The subject of the banner over the centre, which the status line then need not repeat.
#include "gui/shell/follow.h"
#include "gui/surface/layout.h"

namespace hw::gui {

class Tab;

/// The subject of the banner over the centre. Without room for one, the status line and STOP ALL report the
/// others of a bus.
struct BannerSubject {
  enum class What : std::uint8_t { nothing, lost, moved, unset };
  What what = What::nothing;
  Tab* tab = nullptr;
  int param = -1;       ///< unset
  FollowOffer offer{};  ///< moved
};

/// Of a banner that is one bar: in a low part it is never higher.
inline constexpr float banner_bar_height = 48;

/// `below`: the part under the panel tabs, of which it takes its rows. Without that part only a lost link is
/// a subject: advice would cover the status line.
BannerSubject banner_subject(Tab& tab, const Layout& layout, const Box& below);
/// The parameter to choose before this controller's first move; -1: none.
int unset_in(const Tab& tab);

}  // namespace hw::gui
