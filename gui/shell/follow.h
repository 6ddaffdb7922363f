#pragma once
// Reopens a controller at the address of its new name or rate: requested in a banner, done between two
// frames, because its tab is replaced.
#include <string>

namespace hw::gui {

class Console;
class Tab;

/// "Follow to address 07", and the address; empty: the present one.
struct FollowOffer {
  std::string label, address;
  std::string why_not = {};  ///< what must be done before it can be followed; empty: nothing
};
FollowOffer offer_to_follow(const Tab& tab);
/// The offer to all on its wire is not made again.
void leave_where_it_is(Tab& tab, const FollowOffer& offer);

/// Reopens the tab that requested it with Tab::follow_to.
void follow_as_asked(Console& console);

}  // namespace hw::gui
