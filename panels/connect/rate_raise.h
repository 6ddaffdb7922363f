#pragma once
// A controller, or all of a line, is brought to a higher rate: set, stored, opened again at the new rate, and
// all of it taken back when nobody answers there. GUI thread; nothing waits in a frame.
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/address.h"
#include "gui/model/tab.h"

namespace hw::gui {
class Console;
}

namespace hw::panels {

/// The parameter of a line's rate: its choices are rates. -1: the console cannot set it.
int find_rate_param(const Catalog& catalog);
/// What the parameter is set to for this rate; -1: nothing.
std::int64_t rate_choice(const ParamInfo& param, int rate);
/// The address that was opened: of a bus that of all its controllers.
const Address& address_of_all(const gui::Tab& tab);
/// Rate of the wire as the address says it; 0: it has none.
int rate_of(const gui::Tab& tab);
/// The controller is opened afresh at another address, and the connection page stays in front. The fault says
/// why that makes no sense; then it stays open where it is.
Result<gui::Tab*> open_elsewhere(gui::Console& console, gui::Tab& tab, const std::string& address);

class RateRaise {
 public:
  void start(gui::Console& console, gui::Tab& tab, int rate);
  /// Once a frame.
  void tick(gui::Console& console);
  /// The user has had enough of waiting.
  void go_back(gui::Console& console);

  enum class Step : std::uint8_t { idle, set, store, ask, back, set_back, store_back, done, failed };
  [[nodiscard]] Step step() const { return step_; }
  [[nodiscard]] bool under_way() const { return step_ > Step::idle && step_ < Step::done; }
  /// Long enough without an answer at the new rate that the power must be switched by hand.
  [[nodiscard]] bool waits_for_power(const gui::Console& console) const;
  /// How it ended, or why it goes back.
  [[nodiscard]] const std::string& words() const { return words_; }
  /// Where it is open now; null: it was closed.
  [[nodiscard]] gui::Tab* tab(gui::Console& console) const;
  [[nodiscard]] int old_rate() const { return old_rate_; }
  [[nodiscard]] int new_rate() const { return new_rate_; }

  static constexpr Duration before_power = std::chrono::seconds(3), longest_wait = std::chrono::seconds(90),
                            longest_way_back = std::chrono::seconds(15);

 private:
  enum class Outcome : std::uint8_t { pending, done, failed };
  void enter(gui::Console& console, Step step);
  void send_to_all(gui::Tab& tab, const IntentBody& body);
  Outcome outcome(gui::Console& console);
  void reopen(gui::Console& console, const std::string& address);
  void fail(std::string words);
  void tick_ask(gui::Console& console);
  void tick_back(gui::Console& console);

  Step step_ = Step::idle;
  std::string address_, old_address_, new_address_;  ///< the first: open now
  std::string mnemonic_, words_;
  std::int64_t old_value_ = 0, new_value_ = 0;
  int old_rate_ = 0, new_rate_ = 0;
  bool stored_ = false;  ///< the new rate
  Instant since_{};
  std::vector<IntentId> asked_;  ///< of each controller on the wire
};

}  // namespace hw::panels
