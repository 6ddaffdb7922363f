#pragma once
// What a controller goes on doing when its tab, or the window, is closed. GUI thread.
#include <span>
#include <string>
#include <string_view>

namespace hw::gui {

class Tab;

/// A stop would get to it now.
[[nodiscard]] bool reached(const Tab& tab);
/// A stored program of the user's runs, waits or is held, an axis moves, or commands wait in its queues. One
/// whose link was lost goes on with what it did then: nobody has seen that it has stopped.
[[nodiscard]] bool goes_on(const Tab& tab);
/// Through this console, since it last rested. A tab of no session (tests) has begun whatever it does.
[[nodiscard]] bool begun_here(const Tab& tab);
/// "Program 2 is running", "axes X and Y were moving": what stands behind a name; empty: nothing.
enum class Tense { present, past };
[[nodiscard]] std::string what_goes_on(const Tab& tab, Tense tense);
/// What is written before `what`: the controller's name, and which of its bus, unless `what` tells that.
[[nodiscard]] std::string whose(const Tab& tab, std::string_view what);

/// Of a controller, or of all on its bus, as whole sentences.
[[nodiscard]] std::string goes_on_unwatched(const Tab& tab);
/// The same of all controllers of a window, each with its name.
[[nodiscard]] std::string goes_on_unwatched(std::span<Tab* const> tabs);

/// Stops each of them that goes on.
void stop_what_goes_on(std::span<Tab* const> tabs);

}  // namespace hw::gui
