#include "gui/shell/follow.h"

#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/session/moved_address.h"
#include "core/session/session_group.h"
#include "gui/model/address_to_follow.h"
#include "gui/model/goes_on.h"
#include "gui/shell/console.h"

namespace hw::gui {
namespace {

const Address& address_of_wire(const Tab& tab) {
  return tab.bus && tab.bus->group ? tab.bus->group->address() : tab.address();
}

template <class Of, class Does>
void for_all_on_wire(Of& tab, Does does) {
  if (!tab.bus) return does(tab);
  for (Tab* member : tab.bus->members) does(*member);
}

std::string unkept_on_wire(const Tab& tab) {
  std::string all;
  for_all_on_wire(tab, [&all](const Tab& one) {
    if (std::string what = one.panels.unkept(); !what.empty()) all += (all.empty() ? "" : " ") + what;
  });
  return all;
}

/// Closing the tab would not stop a controller that moves or may move, and a stop that waits to be sent would
/// be lost.
std::string why_not_closed(const Tab& tab, const Address& to) {
  std::vector<std::string_view> moving, lost;
  for_all_on_wire(tab, [&](const Tab& one) {
    if (goes_on(one) || one.messages.followed.stop_waits())
      (reached(one) ? moving : lost).push_back(one.bus ? one.id() : one.name());
  });
  if (!moving.empty()) return fmt::format("Stop {} first, then follow.", in_words(moving));
  if (lost.empty()) return {};
  const bool one = lost.size() == 1;
  return fmt::format(
      "Switch {} off first: {} may still move, and no stop would go out to {} any more. Then close the tab "
      "and "
      "connect anew, at {}.",
      in_words(lost), one ? "it" : "they", one ? "it" : "them", words_of_move(address_of_wire(tab), to));
}

void follow(Console& console, Tab& tab, const std::string& address) {
  const FollowOffer offer = offer_to_follow(tab);
  if (offer.address != address) return;
  if (!offer.why_not.empty()) return console.toast(Severity::warn, offer.why_not, &tab);
  if (const std::string unkept = unkept_on_wire(tab); !unkept.empty())
    return console.toast(tab, Severity::warn, "Save it first, then follow: " + unkept, &tab);
  const std::string before = address_of_wire(tab).text();
  const std::string panel = tab.panels.in_front;
  const TabProfiles belongings(tab);
  console.close(tab);
  auto opened = console.open(address);
  if (!opened) {
    console.toast(Severity::fault, opened.error().sentence());
    opened = console.open(before);
  }
  if (!opened) return;
  belongings.apply_to(**opened);
  (*opened)->panels.in_front = panel;
}

}  // namespace

FollowOffer offer_to_follow(const Tab& tab) {
  const auto to = address_to_follow(tab);
  if (!to) return {};
  return {"Follow to " + words_of_move(address_of_wire(tab), *to), to->text(), why_not_closed(tab, *to)};
}

void decline_follow(Tab& tab, const FollowOffer& offer) {
  for_all_on_wire(tab, [&offer](Tab& one) { one.view.follow_left = offer.address; });
}

void follow_as_asked(Console& console) {
  for (const auto& tab : console.tabs())
    if (const std::string to = std::exchange(tab->view.follow_to, {}); !to.empty())
      return follow(console, *tab, to);
}

}  // namespace hw::gui
