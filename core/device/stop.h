#pragma once
// The stops of one controller: the scope of each, whether it ramps, and which have not taken effect yet. The
// pump asks the desk which stop to send; only the desk counts stops. Io thread only.
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

/// One stop. The driver sends all of it, as often as it is asked to.
struct StopOrder {
  enum class What : std::uint8_t {
    everything,  ///< motion, and the programs that cause it
    jog,         ///< a held jog; programs and the axes that they move continue
    program,     ///< a program; where the catalog has threads, its motion continues
    broadcast,   ///< the maker's message to all controllers on the wire
    words,       ///< a text that the user typed
    tool         ///< the outputs of a tool, after the stop of the motion that uses it
  };
  What what = What::everything;
  int axis = -1;         ///< -1: all
  int thread = -1;       ///< of `program`; -1: all
  bool at_once = false;  ///< without a ramp
  ToolOff tool;          ///< of `tool`: what to switch
  std::string words;
  TextMeaning meaning;                              ///< meaning of `words`
  Duration patience{};                              ///< time allowed for an answer to `words`
  std::function<void(Result<std::string>)> answer;  ///< called once, with the answer or the fault
  IntentId intent = 0;                              ///< 0: requested by the console itself
  StoppedBy by = StoppedBy::console;
  Instant asked_at{};        ///< see Intent; 0: now
  std::uint64_t number = 0;  ///< its number at the desk

  int times_sent = 0;
  Instant sent_at{}, first_sent_at{};
  bool sent = false;       ///< sent since it was last due
  bool confirmed = false;  ///< the controller has acknowledged it, or acknowledges none
  bool reported = false;   ///< the requester knows the outcome
  bool in_haste = false;   ///< a more urgent stop waits for the wire

  [[nodiscard]] bool same_scope(const StopOrder& other) const {
    return what == other.what && axis == other.axis && thread == other.thread;
  }
  /// Sent first, this stop does all that `other` would do, no less abruptly.
  [[nodiscard]] bool covers(const StopOrder& other) const {
    if (what == What::tool || other.what == What::tool) return false;
    return what == What::broadcast || (what == What::everything && axis < 0 && other.what != What::words &&
                                       other.what != What::broadcast && (at_once || !other.at_once));
  }
  /// `other` must wait until this stop is sent completely, as it does not cover all of it.
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

/// The progress of a stop, as a status round shows it.
struct StopProgress {
  enum class Now : std::uint8_t {
    stands,   ///< everything in the scope of the stop is at rest
    wait,     ///< it is taking effect
    again,    ///< no effect seen: send it again, in the same form
    at_once,  ///< its ramp does not end: stop at once
    failed    ///< sent as often as is useful; `why` names what still runs
  };
  Now now = Now::stands;
  std::optional<Fault> why;

  static StopProgress stands() { return {}; }
  static StopProgress wait() { return {Now::wait, {}}; }
  static StopProgress again() { return {Now::again, {}}; }
  static StopProgress at_once() { return {Now::at_once, {}}; }
  static StopProgress failed(Fault fault) { return {Now::failed, std::move(fault)}; }
};

/// The stops that were requested and have not been seen to take effect.
class StopDesk {
 public:
  /// A second stop of the same scope, while the first is under way, stops at once. A stop of another scope,
  /// and the first of all axes, ramps. Releasing a jog never counts as a second stop.
  StopOrder& ask(StopOrder order);
  /// Switches the tool off; repeated if that is under way already. Drops nothing that waits to be started.
  StopOrder& ask_tool(const ToolOff& tool);
  /// The number of stops requested so far; an intent from an older epoch must not start anything.
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
  /// Another session on this wire sends a stop: begins a new epoch.
  void note_another() { ++epoch_; }

  [[nodiscard]] bool any() const { return !orders_.empty(); }
  /// Everything is at rest, and only a tool is still being switched off.
  [[nodiscard]] bool only_tool() const;
  [[nodiscard]] bool has_tool() const;
  /// A stop of all axes is under way: a second one means at once.
  [[nodiscard]] bool stops_all() const;
  /// The next stop to send: the latest of those sent least often, unless an older one outlasts it. Null: all
  /// are sent.
  [[nodiscard]] StopOrder* due();
  /// Another stop has not been sent at all, or must be sent before each repetition of this one. Never true of
  /// two stops for each other.
  [[nodiscard]] bool another_waits(const StopOrder& order) const;
  [[nodiscard]] bool all_were_sent(int times) const;
  /// A stop is being sent, or is about to be sent for the first time.
  [[nodiscard]] bool uses_the_wire() const;
  /// Sends all again, as nothing shows that any has arrived.
  void send_all_again();
  /// The stop with that number; null: it is closed.
  [[nodiscard]] StopOrder* find(std::uint64_t number);
  void close(const StopOrder& order);
  void clear() { orders_.clear(); }
  // ---- the typed stop that is being sent
  void begin_sending(const StopOrder& order) { sending_ = order.number; }
  void end_sending() { sending_ = 0; }
  /// Null: none, or it has been withdrawn.
  [[nodiscard]] const StopOrder* sending() { return sending_ == 0 ? nullptr : find(sending_); }

  [[nodiscard]] std::list<StopOrder>& orders() { return orders_; }
  [[nodiscard]] const std::list<StopOrder>& orders() const { return orders_; }

 private:
  std::list<StopOrder>
      orders_;  ///< oldest first; a stop keeps its address while others are added and removed
  std::uint64_t epoch_ = 0, asked_ = 0, sending_ = 0;
};

/// The stop that an intent requests; none: it is not a stop.
std::optional<StopOrder> stop_order_of(const Intent& intent);

}  // namespace hw
