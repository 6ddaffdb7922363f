#include "gui/goes_on.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "gui/tab.h"

namespace hw::gui {

bool runs_program(const Tab& tab) {
  const ProgramState& p = tab.now().program;
  return p.owned && p.run != RunState::idle && p.run != RunState::error;
}

bool moves(const Tab& tab) {
  return tab.now().any_axis_moving() || tab.now().working || tab.now().feed.running;
}

bool goes_on(const Tab& tab) {
  const LinkState link = tab.now().link.state;
  return (moves(tab) || runs_program(tab)) && (link == LinkState::good || link == LinkState::late);
}

std::string what_goes_on(const Tab& tab, Tense tense) {
  const Snapshot& now = tab.now();
  const std::string_view is = tense == Tense::past ? "was" : "is",
                         are = tense == Tense::past ? "were" : "are";
  if (runs_program(tab))
    return fmt::format("{} {} {} {}", tab.catalog().program.slot_word, now.program.slot, is,
                       now.program.run == RunState::held ? "held" : "running");
  std::vector<std::string_view> axes;
  for (int i = 0; i < now.axis_count; ++i)
    if (now.axis_moves(i)) axes.push_back(tab.catalog().axes[static_cast<std::size_t>(i)].name);
  if (axes.size() == 1) return fmt::format("axis {} {} moving", axes[0], is);
  if (!axes.empty()) return fmt::format("axes {} {} moving", in_words(axes), are);
  return moves(tab) ? fmt::format("commands {} waiting in its queues", are) : std::string();
}

std::string whose(const Tab& tab, std::string_view what) {
  if (!tab.bus || speaks_of(what, tab.id())) return std::string(tab.name());
  return fmt::format("{}, {}", tab.name(), tab.id());
}

namespace {

std::string unwatched_alone(const Tab& tab) {
  if (runs_program(tab))
    return fmt::format(
        "{} {} runs in the controller, and goes on there when this window no longer watches it.",
        tab.catalog().program.slot_word, tab.now().program.slot);
  return moves(tab) ? "An axis is moving, and nobody would watch it." : "Nothing moves any more.";
}

/// "A program runs in 02. 01 and 03 move. Nobody would watch them."
std::string unwatched_on_bus(const Bus& bus) {
  std::vector<std::string_view> running, moving;
  for (const Tab* member : bus.members)
    if (runs_program(*member))
      running.push_back(member->id());
    else if (moves(*member))
      moving.push_back(member->id());
  if (running.empty() && moving.empty()) return "Nothing moves any more.";
  std::string said;
  if (!running.empty()) said += fmt::format("A program runs in {}. ", in_words(running));
  if (!moving.empty())
    said += fmt::format("{} {}. ", in_words(moving), moving.size() == 1 ? "moves" : "move");
  return said + (running.size() + moving.size() > 1 ? "Nobody would watch them." : "Nobody would watch it.");
}

}  // namespace

std::string goes_on_unwatched(const Tab& tab) {
  return tab.bus ? unwatched_on_bus(*tab.bus) : unwatched_alone(tab);
}

void stop_what_goes_on(std::span<Tab* const> tabs) {
  std::vector<Bus*> stopped;
  for (Tab* tab : tabs) {
    if (!goes_on(*tab)) continue;
    if (!tab->bus) {
      tab->stop_all();
    } else if (std::find(stopped.begin(), stopped.end(), tab->bus.get()) == stopped.end()) {
      stopped.push_back(tab->bus.get());
      tab->bus->stop_all();
    }
  }
}

}  // namespace hw::gui
