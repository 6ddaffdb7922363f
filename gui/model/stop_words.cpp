#include "gui/model/stop_words.h"

#include <algorithm>
#include <vector>

#include <fmt/core.h>

#include "gui/model/bus.h"
#include "gui/model/tab.h"

namespace hw::gui {
namespace {

bool runs_on(RunState run) { return run != RunState::idle && run != RunState::error; }

bool runs(const Snapshot& now) {
  return runs_on(now.program.run) ||
         std::any_of(now.threads.begin(), now.threads.end(),
                     [](const ThreadState& thread) { return runs_on(thread.run); });
}

bool is_reached(const Tab& tab) {
  const LinkState link = tab.now().link.state;
  return link == LinkState::good || link == LinkState::late;
}

/// The names of the controllers for which `which` is true; on a bus, of its devices.
template <class Which>
std::vector<std::string_view> names(std::span<const std::unique_ptr<Tab>> tabs, Which which) {
  std::vector<std::string_view> all;
  for (const auto& tab : tabs)
    if (which(*tab)) all.push_back(tab->bus ? tab->id() : tab->name());
  return all;
}

std::string stopped(std::span<const std::string_view> names, std::string_view doing) {
  if (names.empty()) return {};
  return fmt::format(" It also stopped {}, which {} {}.", in_words(names), names.size() == 1 ? "was" : "were",
                     doing);
}

}  // namespace

std::string words_of_esc(std::span<const std::unique_ptr<Tab>> tabs) {
  const auto moving = names(tabs, [](const Tab& t) { return is_reached(t) && t.now().any_axis_moving(); });
  const auto running =
      names(tabs, [](const Tab& t) { return is_reached(t) && !t.now().any_axis_moving() && runs(t.now()); });
  const auto lost = names(tabs, [](const Tab& t) { return t.now().link.state == LinkState::lost; });
  std::string words = "Esc closed the open list or dialog.";
  words += stopped(moving, "moving");
  words += stopped(running, "running");
  if (moving.empty() && running.empty()) words += " Nothing was moving or running.";
  if (!lost.empty()) words += fmt::format(" Stop does not reach {}.", in_words(lost));
  return words;
}

}  // namespace hw::gui
