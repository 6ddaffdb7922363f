#pragma once
// Reopens a controller at the address of its new name or rate. The user requests it in a banner. It is done
// between two frames, because the tab is replaced.
#include <string>

namespace hw::gui {

class Console;
class Tab;

/// An offer such as "Follow to address 07". An empty address is the present one.
struct FollowOffer {
  std::string label, address;
  std::string why_not = {};  ///< what the user must do first; empty: nothing
};
FollowOffer offer_to_follow(const Tab& tab);
/// Withdraws this offer from all controllers on the wire; it is not made again.
void decline_follow(Tab& tab, const FollowOffer& offer);

/// Reopens the tab for which the user requested it with TabView::follow_to.
void follow_as_asked(Console& console);

}  // namespace hw::gui
