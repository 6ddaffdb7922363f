#include "gui/model/goes_on.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "core/session/session.h"
#include "gui/model/tab.h"

namespace hw::gui {

bool reached(const Tab& tab) { return tab.now().link.connected(); }

bool begun_here(const Tab& tab) { return !tab.session() || tab.session()->begun_here(); }

namespace {

bool runs_program(const Tab& tab) { return tab.now().under_way().program; }

/// The link was lost before the outcome of a command was seen.
bool began_unseen(const Tab& tab) {
  const LinkState link = tab.now().link.state;
  return (link == LinkState::lost || link == LinkState::connecting) && tab.session() && begun_here(tab);
}

}  // namespace

bool goes_on(const Tab& tab) { return tab.now().under_way().any() || began_unseen(tab); }

std::string running_words(const Tab& tab, Tense tense) {
  const UnderWay now = tab.now().under_way();
  const std::string_view is = tense == Tense::past ? "was" : "is",
                         are = tense == Tense::past ? "were" : "are";
  if (now.program)
    return fmt::format("{} {} {} {}", tab.catalog().program.slot_word, now.slot, is,
                       now.held ? "held" : "running");
  std::vector<std::string_view> axes;
  for (std::size_t i = 0; i < tab.catalog().axes.size(); ++i)
    if (now.axes >> i & 1) axes.push_back(tab.catalog().axes[i].name);
  if (axes.size() == 1) return fmt::format("axis {} {} moving", axes[0], is);
  if (!axes.empty()) return fmt::format("axes {} {} moving", in_words(axes), are);
  if (now.queued) return fmt::format("commands {} waiting in its queues", are);
  return began_unseen(tab) ? "a motion may have been under way" : std::string();
}

std::string whose(const Tab& tab, std::string_view what) {
  if (!tab.bus || mentions(what, tab.id())) return std::string(tab.name());
  return fmt::format("{}, {}", tab.name(), tab.id());
}

namespace {

using Names = std::vector<std::string_view>;

/// Follows the sentences about controllers whose link was lost. `named`: other controllers are mentioned too,
/// so "it" would be ambiguous.
std::string no_stop_reaches(const Names& lost, bool named) {
  const bool one = lost.size() == 1;
  const std::string whom = named ? in_words(lost) : one ? "it" : "them";
  return fmt::format("A stop cannot reach {} now: use {}.", whom,
                     one ? "its power switch" : "their power switches");
}

std::string unwatched_sentence(std::size_t many) {
  return many > 1 ? "After closing, this console no longer watches them."
                  : "After closing, this console no longer watches it.";
}

/// "01 moves. 02 was moving when the link was lost. After closing, ...": the last part.
std::string consequence_words(std::size_t watched, const Names& lost) {
  std::string sentence = watched > 0 ? unwatched_sentence(watched) : std::string();
  if (lost.empty()) return sentence;
  if (watched > 0) sentence += ' ';
  return sentence + no_stop_reaches(lost, watched > 0);
}

std::string unwatched_alone(const Tab& tab) {
  if (!goes_on(tab)) return "Nothing is moving now.";
  if (!reached(tab)) {
    std::string what = running_words(tab, Tense::past);
    what.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(what.front())));
    return fmt::format("{} when the link was lost. {}", what, no_stop_reaches({tab.name()}, false));
  }
  if (runs_program(tab))
    return fmt::format(
        "{} {} runs in the controller. It continues after closing, and this console no longer watches it.",
        tab.catalog().program.slot_word, tab.now().program.slot);
  return "An axis is moving. After closing, this console no longer watches it.";
}

/// "A program runs in 02. 01 and 03 move. After closing, this console no longer watches them."
std::string unwatched_on_bus(const Bus& bus) {
  Names running, moving, lost;
  for (const Tab* member : bus.members)
    if (!goes_on(*member))
      continue;
    else if (!reached(*member))
      lost.push_back(member->id());
    else if (runs_program(*member))
      running.push_back(member->id());
    else
      moving.push_back(member->id());
  std::string sentence;
  if (!running.empty()) sentence += fmt::format("A program runs in {}. ", in_words(running));
  if (!moving.empty())
    sentence += fmt::format("{} {}. ", in_words(moving), moving.size() == 1 ? "moves" : "move");
  if (!lost.empty())
    sentence += fmt::format("{} {} under way when the link was lost. ", in_words(lost),
                            lost.size() == 1 ? "was" : "were");
  if (sentence.empty()) return "Nothing is moving now.";
  return sentence + consequence_words(running.size() + moving.size(), lost);
}

}  // namespace

std::string goes_on_unwatched(const Tab& tab) {
  return tab.bus ? unwatched_on_bus(*tab.bus) : unwatched_alone(tab);
}

std::string goes_on_unwatched(std::span<Tab* const> tabs) {
  std::string sentence;
  std::size_t watched = 0;
  Names lost;
  for (const Tab* tab : tabs) {
    if (!goes_on(*tab)) continue;
    const bool now = reached(*tab);
    const std::string what = running_words(*tab, now ? Tense::present : Tense::past);
    sentence += fmt::format("{}: {}{}. ", whose(*tab, what), what, now ? "" : " when the link was lost");
    if (now)
      ++watched;
    else
      lost.push_back(tab->bus ? tab->id() : tab->name());
  }
  return sentence.empty() ? "Nothing is moving now." : sentence + consequence_words(watched, lost);
}

void stop_running(std::span<Tab* const> tabs) {
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
