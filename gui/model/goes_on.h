#pragma once
// Work that a controller continues when its tab or the window is closed. GUI thread.
#include <span>
#include <string>
#include <string_view>

namespace hw::gui {

class Tab;

/// Returns whether a stop would reach the controller now.
[[nodiscard]] bool reached(const Tab& tab);
/// Returns whether a stored program of the user runs, waits or is held, an axis moves, or commands wait in
/// the controller's queues. After a lost link, the last known activity counts as under way: its end was not
/// seen.
[[nodiscard]] bool goes_on(const Tab& tab);
/// Returns whether the activity was begun through this console, since the controller last rested. Without a
/// session (tests): always true.
[[nodiscard]] bool begun_here(const Tab& tab);
/// "Program 2 is running", "axes X and Y were moving": to follow a name; empty: nothing.
enum class Tense { present, past };
[[nodiscard]] std::string running_words(const Tab& tab, Tense tense);
/// The text before `what`: the controller's name, and its id on a bus unless `what` names it.
[[nodiscard]] std::string whose(const Tab& tab, std::string_view what);

/// The activity of a controller, or of all on its bus, in whole sentences.
[[nodiscard]] std::string goes_on_unwatched(const Tab& tab);
/// The same for all controllers of a window, each with its name.
[[nodiscard]] std::string goes_on_unwatched(std::span<Tab* const> tabs);

/// Stops each controller that goes on.
void stop_running(std::span<Tab* const> tabs);

}  // namespace hw::gui
