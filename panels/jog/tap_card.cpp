#include "panels/jog/tap_card.h"

#include <array>

#include "core/device/travel_check.h"
#include "gui/model/tab.h"
#include "panels/widget_path.h"

namespace hw::panels {

using namespace gui;

/// Whether the refusal no longer holds, or the user has done another action since.
static bool is_over(const Tab& tab) {
  const PastTravel& past = tab.messages.tap_past_limit->past;
  const AxisState& axis = tab.now().axes[past.axis.index];
  return tab.jog.holding() || tab.now().axis_moves(past.axis.index) || !axis.travel_holds() ||
         !axis.travel.has(past.side) || axis.travel.end(past.side) != past.nearest;
}

void TapCard::draw(Frame& f, const Rect& pad) {
  bool drawn = false;  // one card at a time
  const auto draw_of = [&](Tab& tab) {
    tab.messages.look_at_pad();
    if (tab.messages.tap_past_limit && is_over(tab)) tab.messages.tap_past_limit.reset();
    if (drawn || !tab.messages.tap_past_limit) return;
    draw(f, tab, pad);
    drawn = true;
  };
  if (!f.tab.bus) return draw_of(f.tab);
  for (Tab* member : f.tab.bus->members) draw_of(*member);
}

void TapCard::draw(Frame& f, Tab& tab, const Rect& pad) {
  const TabMessages::TapPastLimit& refused = *tab.messages.tap_past_limit;
  const AxisId axis = refused.past.axis;
  const std::string& name = tab.catalog().axes[axis.index].name;
  const Path id("jog/{}/refused", name), nearest("jog/{}/nearest", name), about("Jog, {}", name);
  const Steps place = nearest_allowed(tab.now(), refused.past);
  const Path label("Go to {}", format_with_unit(place, tab.settings.unit(axis)).view());
  const std::array<Action, 1> actions = {
      Action{.id = nearest, .label = label, .disabled = tab.why_not_move(axis), .moving = true}};
  card_.begin(f, {.id = id, .about = about, .words = refused.words, .actions = actions}, pad);
  const RefusalTouch done = card_.end();
  if (done.action == 0)
    tab.send_followed(
        intent::MoveTo(std::vector<AxisTarget>(1, {axis, place}), tab.settings.jog_speed(axis)));
  if (done.action == 0 || done.closed) tab.messages.tap_past_limit.reset();
}

}  // namespace hw::panels
