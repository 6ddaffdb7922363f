#include "gui/model/bus.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/session/session_group.h"
#include "gui/model/axis_look.h"
#include "gui/model/tab.h"

namespace hw::gui {

std::string in_words(std::span<const std::string_view> names) {
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words += fmt::format("{}{}", i == 0 ? "" : i + 1 == names.size() ? " and " : ", ", names[i]);
  return words;
}

bool mentions(std::string_view sentence, std::string_view id) {
  return sentence.starts_with(fmt::format("{} ", id)) || sentence.starts_with(fmt::format("{}:", id)) ||
         sentence.find(fmt::format(" {} ", id)) != sentence.npos;
}

std::string_view Bus::name() const {
  const std::string& users = members.front()->settings.profile.bus_name;
  return users.empty() ? default_name : users;
}

void Bus::rename(std::string name) {
  members.front()->settings.profile.bus_name = std::move(name);
  members.front()->settings.edited();
}

Tab& Bus::worst() const {
  Tab* worst = members[chosen];
  for (Tab* member : members)
    if (badness(worst_state(member->now(), member->clock())) >
        badness(worst_state(worst->now(), worst->clock())))
      worst = member;
  return *worst;
}

Tab& Bus::most_urgent() const {
  const auto urgency = [](const Tab* member) {
    const int bad = badness(worst_state(member->now(), member->clock()));
    const bool warns = bad < badness(State::connecting) && needs_attention(member->now());
    return warns ? badness(State::connecting) : bad;
  };
  Tab* most = members[chosen];
  for (Tab* member : members)
    if (urgency(member) > urgency(most)) most = member;
  return *most;
}

std::size_t Bus::connected() const {
  return static_cast<std::size_t>(std::count_if(members.begin(), members.end(), [](const Tab* member) {
    const LinkState link = member->now().link.state;
    return link == LinkState::good || link == LinkState::late;
  }));
}

void Bus::stop_all(StoppedBy by) {
  if (!group) {
    for (Tab* member : members) member->stop_all(by);
    return;
  }
  const std::vector<IntentId> stops = group->stop(false, by);
  for (std::size_t i = 0; i < members.size(); ++i) members[i]->stopped_with(stops[i]);
}

void Bus::send_to_pieces(const IntentBody& request) {
  for (Tab* member : members)
    if (member->now().pieces.running) member->send(request);
}

const PiecesState& Bus::pieces() const {
  const PiecesState* latest = &front().now().pieces;
  for (const Tab* member : members) {
    const PiecesState& pieces = member->now().pieces;
    if (pieces.running) return pieces;
    if (latest->total == 0) latest = &pieces;
  }
  return *latest;
}

State worst_state(const Tab& tab) {
  if (!tab.bus) return worst_state(tab.now(), tab.clock());
  const Tab& worst = tab.bus->worst();
  const State state = worst_state(worst.now(), worst.clock());
  const auto moving = std::count_if(tab.bus->members.begin(), tab.bus->members.end(), [](const Tab* member) {
    return is_motion(worst_state(member->now(), member->clock()));
  });
  return is_motion(state) && moving > 1 ? State::moving : state;
}

}  // namespace hw::gui
