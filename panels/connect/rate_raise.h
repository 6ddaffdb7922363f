#pragma once
// Raises the rate of a controller, or of all controllers of a line: sets the rate, stores it, reopens the
// line with it, and undoes all of this if no reply comes. GUI thread; never blocks a frame.
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

/// The parameter for the rate of a line, whose choices are rates; -1: the console cannot set the rate.
int find_rate_param(const Catalog& catalog);
/// The parameter's value for this rate; -1: none.
std::int64_t rate_choice(const ParamInfo& param, int rate);
/// The address that was opened; on a bus, the address of all its controllers.
const Address& address_of_all(const gui::Tab& tab);
/// The rate of the wire in the address; 0: none.
int rate_of(const gui::Tab& tab);
/// Reopens the controller at another address. The connection page stays in front. A fault means that the
/// address is invalid; the controller then stays open at its old address.
Result<gui::Tab*> open_elsewhere(gui::Console& console, gui::Tab& tab, const std::string& address);

class RateRaise {
 public:
  void start(gui::Console& console, gui::Tab& tab, int rate);
  /// Call once a frame.
  void tick(gui::Console& console);
  /// Goes back to the old rate. Call when the user cancels the wait.
  void go_back(gui::Console& console);

  enum class Step : std::uint8_t { idle, set, store, ask, back, set_back, store_back, done, failed };
  [[nodiscard]] Step step() const { return step_; }
  [[nodiscard]] bool under_way() const { return step_ > Step::idle && step_ < Step::done; }
  /// Whether no reply came at the new rate for so long that the user must switch the power.
  [[nodiscard]] bool waits_for_power(const gui::Console& console) const;
  /// The result, or why the rate is being restored.
  [[nodiscard]] const std::string& words() const { return words_; }
  /// The tab that is open now; null: closed.
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
  std::string address_, old_address_, new_address_;  ///< address_: open now
  std::string mnemonic_, words_;
  std::int64_t old_value_ = 0, new_value_ = 0;
  int old_rate_ = 0, new_rate_ = 0;
  bool stored_ = false;  ///< the new rate was stored
  Instant since_{};
  std::vector<IntentId> asked_;  ///< command sent to each controller on the wire
};

}  // namespace hw::panels
