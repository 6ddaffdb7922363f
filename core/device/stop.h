#pragma once
// Stops of one controller: what each is for, whether it ramps, which have not taken effect yet. The pump asks
// the desk what to send; nobody else counts stops. Io thread only.
#include <cstdint>
#include <functional>
#include <list>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/device/intent.h"
#include "core/device/text_meaning.h"
#include "core/device/tool_off.h"
#include "core/time/clock.h"

namespace hw {

/// One stop. The driver sends it as a whole, as often as it is asked to.
struct StopOrder {
  enum class What : std::uint8_t {
    everything,  ///< motion, and the programs that cause it
    jog,         ///< what a held jog moves; programs, and axes that they move, go on
    program,     ///< a program; what it has begun to move goes on where the catalog has threads
    broadcast,   ///< the maker's one message to all controllers of the wire
    words,       ///< the user's own text
    tool         ///< outputs that switch a tool off: behind whatever stops what it cuts, and at its end
  };
  What what = What::everything;
  int axis = -1;         ///< -1: all
  int thread = -1;       ///< of `program`; -1: all
  bool at_once = false;  ///< without a ramp
  ToolOff tool;          ///< what is switched, of `tool`
  std::string words;
  TextMeaning meaning;                              ///< of `words`
  Duration patience{};                              ///< with an answer to `words`
  std::function<void(Result<std::string>)> answer;  ///< called once, with that answer or why there is none
  IntentId intent = 0;                              ///< 0: the console's own
  StoppedBy by = StoppedBy::console;
  Instant asked_at{};        ///< see Intent; 0: when it comes here
  std::uint64_t number = 0;  ///< by which the desk finds it

  int times_sent = 0;
  Instant sent_at{}, first_sent_at{};
  bool sent = false;       ///< since it was last due
  bool confirmed = false;  ///< the controller has acknowledged it, or acknowledges none
  bool told = false;       ///< what became of it is known to whoever asked
  bool in_haste = false;   ///< another one that goes first waits behind it

  [[nodiscard]] bool same_scope(const StopOrder& other) const {
    return what == other.what && axis == other.axis && thread == other.thread;
  }
  /// Sent first, it does all that `other` is for, and nothing harsher is asked of that.
  [[nodiscard]] bool covers(const StopOrder& other) const {
    if (what == What::tool || other.what == What::tool) return false;
    return what == What::broadcast || (what == What::everything && axis < 0 && other.what != What::words &&
                                       other.what != What::broadcast && (at_once || !other.at_once));
  }
  /// `other` waits until it is sent as a whole: it would leave alone what this one stops.
  [[nodiscard]] bool outlasts(const StopOrder& other) const {
    if (other.what == What::tool) return what != What::tool;
    if (what == What::tool) return false;
    return covers(other) || (other.what == What::program && what != What::program && what != What::words);
  }
  [[nodiscard]] bool stops_all() const {
    return what == What::words ? meaning.stops == TextMeaning::Stops::all
                               : axis < 0 && what == What::everything;
  }
};

/// What a round of status shows of a stop.
struct StopProgress {
  enum class Now : std::uint8_t {
    stands,   ///< what it was for is at rest
    wait,     ///< it takes effect
    again,    ///< its effect does not show: send it again, in the same form
    at_once,  ///< its ramp does not end
    failed    ///< it was sent as often as makes sense; `why` says what goes on
  };
  Now now = Now::stands;
  std::optional<Fault> why;

  static StopProgress stands() { return {}; }
  static StopProgress wait() { return {Now::wait, {}}; }
  static StopProgress again() { return {Now::again, {}}; }
  static StopProgress at_once() { return {Now::at_once, {}}; }
  static StopProgress failed(Fault fault) { return {Now::failed, std::move(fault)}; }
};

/// The stops that were asked for and have not been seen to take effect.
class StopDesk {
 public:
  /// The same scope, asked again while its stop is under way, means: at once. Another scope, or the first of
  /// all axes, ramps beside it. Letting go of a jog is never the second stop.
  StopOrder& ask(StopOrder order);
  /// Switches the tool off, once more if that is under way already. Nothing that waits to be started is
  /// dropped for it.
  StopOrder& ask_tool(const ToolOff& tool);
  /// How many have been asked for; what was asked for under an older number must not start anything.
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
  /// A stop that somebody else sends on the same wire: nothing from before may start anything.
  void heard_another() { ++epoch_; }

  [[nodiscard]] bool any() const { return !orders_.empty(); }
  /// Whatever was to stop stands: a tool is being switched off.
  [[nodiscard]] bool only_tool() const;
  [[nodiscard]] bool has_tool() const;
  /// A stop of all axes is under way: another one would mean at once.
  [[nodiscard]] bool stops_all() const;
  /// The next to be sent: of those that were sent least often the latest, unless an older one outlasts it.
  /// Null: all have been.
  [[nodiscard]] StopOrder* due();
  /// One of the others has not gone out at all, or goes first as often as it is sent again. Never so of two
  /// for each other.
  [[nodiscard]] bool another_waits(const StopOrder& order) const;
  [[nodiscard]] bool all_were_sent(int times) const;
  /// One is being sent, or is about to be for the first time.
  [[nodiscard]] bool uses_the_wire() const;
  /// Each is sent again: nothing shows that any has arrived.
  void send_all_again();
  /// By its number; null: it is closed.
  [[nodiscard]] StopOrder* find(std::uint64_t number);
  void close(const StopOrder& order);
  void clear() { orders_.clear(); }
  // ---- the one whose words are on their way
  void begin_sending(const StopOrder& order) { sending_ = order.number; }
  void end_sending() { sending_ = 0; }
  /// Null: none is, or it has been withdrawn.
  [[nodiscard]] const StopOrder* sending() { return sending_ == 0 ? nullptr : find(sending_); }

  [[nodiscard]] std::list<StopOrder>& orders() { return orders_; }
  [[nodiscard]] const std::list<StopOrder>& orders() const { return orders_; }

 private:
  std::list<StopOrder> orders_;  ///< oldest first; they keep their place while others come and go
  std::uint64_t epoch_ = 0, asked_ = 0, sending_ = 0;
};

/// The order that an intent asks for; none: it is no stop.
std::optional<StopOrder> stop_order_of(const Intent& intent);

}  // namespace hw
