#pragma once
// Chooses the subject of the banner over the centre. The status line does not repeat it.
#include "gui/shell/follow.h"
#include "gui/surface/layout.h"

namespace hw::gui {

class Tab;

/// The subject of the banner over the centre. Where no banner fits, the status line and STOP ALL report the
/// other controllers of a bus.
struct BannerSubject {
  enum class Kind : std::uint8_t { nothing, lost, moved, unset };
  Kind kind = Kind::nothing;
  Tab* tab = nullptr;
  int param = -1;       ///< for `unset`: the parameter
  FollowOffer offer{};  ///< for `moved`
};

/// Height of a banner that is one bar, logical. In a low part the banner is never higher.
inline constexpr float banner_bar_height = 48;

/// `below` is the part under the panel tabs, from which the banner takes its rows. Without that part only a
/// lost link is a subject, because advice would cover the status line.
BannerSubject banner_subject(Tab& tab, const Layout& layout, const Box& below);
/// The parameter that the user must choose before this controller's first move; -1: none.
int unset_in(const Tab& tab);

}  // namespace hw::gui
