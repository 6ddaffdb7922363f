#pragma once
// What a controller goes on doing when its tab, or the window, is closed. GUI thread.
#include <span>
#include <string>
#include <string_view>

namespace hw::gui {

class Tab;

/// A stored program of the user's runs, waits or is held.
[[nodiscard]] bool runs_program(const Tab& tab);
/// An axis moves, or commands wait in its queues.
[[nodiscard]] bool moves(const Tab& tab);
/// One of both, where a stop reaches it.
[[nodiscard]] bool goes_on(const Tab& tab);
/// "Program 2 is running", "axes X and Y were moving": what stands behind a name; empty: nothing.
enum class Tense { present, past };
[[nodiscard]] std::string what_goes_on(const Tab& tab, Tense tense);
/// What is written before `what`: the controller's name, and which of its bus, unless `what` tells that.
[[nodiscard]] std::string whose(const Tab& tab, std::string_view what);

/// Of a controller, or of all on its bus, as whole sentences.
[[nodiscard]] std::string goes_on_unwatched(const Tab& tab);

/// Stops each of them that goes on.
void stop_what_goes_on(std::span<Tab* const> tabs);

}  // namespace hw::gui
