// When the user's session ends without a question, the console stops the motions and programs that it began,
// records them, and reports them at the next start.
#include <algorithm>
#include <atomic>
#include <thread>

#include <fmt/core.h>

#include "core/session/last_end.h"
#include "core/session/session.h"
#include "gui/model/goes_on.h"
#include "gui/shell/console.h"
#include "gui/shell/outside.h"

namespace hw::gui {
namespace {

constexpr Duration for_rest = std::chrono::seconds(5);

/// A controller to which a stop was sent; shared with the io thread.
struct Watched {
  std::size_t place;  ///< index in LastEnd::controllers
  std::atomic<bool> over{false}, rests{false};
  explicit Watched(std::size_t p) : place(p) {}
};

bool at_rest(const Snapshot& s) {
  const bool runs = s.program.run != RunState::idle && s.program.run != RunState::error;
  return s.link.state == LinkState::good && !runs && !s.working && !s.any_axis_moving();
}

// The state observed after the stop decides, even if the stop was refused or failed.
Task<> see_at_rest(std::shared_ptr<Session> session, IntentId stop, std::shared_ptr<Watched> watched) {
  co_await session->outcome(stop);
  co_await session->wait_until_idle(for_rest);
  watched->rests = at_rest(session->known());
  watched->over = true;
}

}  // namespace

void Console::shut_down(std::string_view how) {
  LastEnd end{date_of_today(), time_of_day(clock()), std::string(how), {}};
  std::vector<std::shared_ptr<Watched>> watched;
  for (const auto& tab : tabs_) {
    const std::string what = running_words(*tab, Tense::past);
    if (what.empty()) continue;
    LastEnd::Controller& controller = end.controllers.emplace_back();
    controller.name = whose(*tab, what), controller.what = what;
    controller.outcome = !begun_here(*tab) ? LastEnd::Outcome::left_alone
                         : reached(*tab)   ? LastEnd::Outcome::stop_sent
                                           : LastEnd::Outcome::no_stop_sent;
    if (controller.outcome == LastEnd::Outcome::left_alone) continue;
    tab->jog.forget();  // the stop ends the jog; a second stop would mean "at once, without ramp"
    const IntentId stop = tab->send(intent::Stop(-1, StoppedBy::console));
    if (!tab->session() || controller.outcome == LastEnd::Outcome::no_stop_sent) continue;
    watched.push_back(std::make_shared<Watched>(end.controllers.size() - 1));
    Task<> seen = see_at_rest(tab->session(), stop, watched.back());
    asio::co_spawn(outside_->scheduler.executor(), std::move(seen), asio::detached);
  }
  if (end.controllers.empty()) return;
  const LastEnds ends(outside_->folders);
  report_failure(ends.keep(end));  // the program may be killed while waiting
  const auto give_up = std::chrono::steady_clock::now() + for_rest;
  const auto over = [](const auto& one) { return one->over.load(); };
  while (!std::all_of(watched.begin(), watched.end(), over) && std::chrono::steady_clock::now() < give_up)
    std::this_thread::sleep_for(Millis(2));
  for (const auto& one : watched)
    if (one->rests) end.controllers[one->place].outcome = LastEnd::Outcome::at_rest;
  if (!watched.empty()) report_failure(ends.keep(end));
}

void Console::note_unreached(std::span<Tab* const> closed, std::string_view how) {
  LastEnd end{date_of_today(), time_of_day(clock()), std::string(how), {}};
  for (const Tab* tab : closed) {
    if (reached(*tab) || !goes_on(*tab) || !begun_here(*tab)) continue;
    const std::string what = running_words(*tab, Tense::past);
    end.controllers.push_back({whose(*tab, what), what, LastEnd::Outcome::no_stop_sent});
  }
  if (!end.controllers.empty()) report_failure(LastEnds(outside_->folders).keep(end));
}

void Console::report_last_ends() {
  const auto ends = LastEnds(outside_->folders).take();
  if (!ends) return toast(Severity::warn, ends.error().sentence());
  for (const LastEnd& end : *ends)
    toasts_.add_staying(end.harmless() ? Severity::warn : Severity::fault, end.sentence(date_of_today()));
}

}  // namespace hw::gui
