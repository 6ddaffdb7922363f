#pragma once
// Turns intents into transactions of one model, polls its state, decodes what comes back. Written as
// coroutines that read like the manual's procedures. The pump runs one of them at a time; a stop ends it
// (Station::preempt) and takes its place. Io thread only.
//
// What a driver owes, so that the rest of the house can rely on it:
//
// - Intents. MoveTo, MoveBy, JogStart, Home, SetPosition, SetParam, ReadParams, SendText, Reset and ReadAgain
//   are taken by every driver, as far as its catalog offers them. What the controller cannot do is refused,
//   with FaultKind::refused and a sentence, before a byte is sent. Stop, Abort, JogStop, JogKeepAlive,
//   Reconnect, TrustPosition, RecallPositions, SetTravel, SetBacklash, RunInPieces and OverrideSpeed never
//   come here: the pump does them.
// - Faults. refused: nothing was sent. controller: it said no. no_answer, garbled: it may have been done.
//   stopped: a stop took the wire. lost: the wire is gone. The pump repeats nothing.
// - Stops: see stop(). A second stop of the same scope comes with StopOrder::at_once. stop_progress() says
//   `stands` only of what was read since the stop was sent.
// - Snapshot. The driver writes the axes (but travel and backlash), programs, threads, the feed, transfers,
//   parameters, readouts, lines and its identity. The pump writes link, pieces, fates and poll_period. A
//   value that is not known any more is marked so; it is never left as it was.
// - Restarts. Snapshot::restarts goes up whenever the controller has been switched on or reset, and each axis
//   that may have lost its zero is doubted (PositionTrust::doubt) in the same round.
// - Notices. info, warning, error: a sentence that somebody must read. program: the listing of a slot for
//   which the editor waits. question: a move is possible when these slots have been emptied.
#include <functional>
#include <string>

#include "core/base/asio.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/script_texts.h"
#include "core/device/snapshot.h"
#include "core/device/stop.h"
#include "core/link/station.h"

namespace hw {

/// What a driver is given. All outlive it.
struct DriverContext {
  Scheduler& scheduler;
  const Catalog& catalog;
  Snapshot& draft;                     ///< the driver writes it; the pump publishes it
  ScriptTexts& texts;                  ///< what came unasked, for scripts
  std::function<void(Notice)> notify;  ///< what must not be lost
  std::function<void()> changed;       ///< something came unasked: publish soon, poll soon
  std::function<void(const AxisSample&)> sample = nullptr;  ///< of a recording: intent::Sample
};

/// How much a round of status asks.
enum class Round : std::uint8_t {
  stopping,  ///< what shows whether the controller stands, and nothing else
  usual,
  everything  ///< somebody waits for what it reads: also what is otherwise asked in turn
};

class Driver {
 public:
  virtual ~Driver() = default;

  /// A wire is open, and stops may be sent. Nothing is known of the controller yet. Sends nothing.
  virtual void attach(Station& station) = 0;
  /// Get the controller to listen, find out what it is, read its state. Moves nothing.
  virtual Task<Result<>> connect() = 0;
  /// One round of status.
  virtual Task<Result<>> poll(Round round) = 0;
  /// Somebody reacts to inputs until then: a long round asks for them again between its other questions, and
  /// shows them at once.
  virtual void watch_inputs(Instant /*until*/) {}
  /// Everything but stops. Returns when the intent is under way (moves) or finished (the rest).
  virtual Task<Result<>> perform(const IntentBody& intent) = 0;
  /// Sends a stop, all of it, and does not wait for its effect: it returns when the controller has
  /// acknowledged the last byte, or has been given the time to. Also before connect(), and whatever is known
  /// of the state. Called again for the same order until stop_progress() says that it stands. Returns the
  /// answer to the user's words, if they have one.
  virtual Task<Result<std::string>> stop(const StopOrder& order) = 0;
  /// What stops a jog of these axes (a bit each) when nobody can ask the controller anything any more: the
  /// exact bytes for the wire that is attached, with the end of a message that was cut short in front. It may
  /// stop more than these axes where the controller knows no less.
  [[nodiscard]] virtual LastWill last_will(unsigned axes) const = 0;
  /// What the round of status that has just ended shows of it. The user's own words are followed by the
  /// console's stop where this asks for them again.
  virtual StopProgress stop_progress(const StopOrder& order) = 0;
  /// The wire is gone: what was under way, waited for or half said is forgotten, positions are not known any
  /// more, and nothing is sent. What was read of the set-up may stay to be shown; connect() reads it again.
  /// The station is invalid afterwards.
  virtual void wire_lost() = 0;

  /// Raw text and its reply without terminator (scripts, `send`). No stop.
  virtual Task<Result<std::string>> query(std::string text, Duration patience) = 0;
  [[nodiscard]] virtual TextMeaning meaning_of(const intent::SendText& text) const = 0;
  /// Another session of this wire sends this text to all its controllers, and so to this one.
  virtual void overhear(const std::string& /*text*/) {}

  /// What the console has put into the controller for its own use is still there, and the next rounds of
  /// status take it away: a wire that is given up stays open for that.
  [[nodiscard]] virtual bool clears_up() const { return false; }
  /// What stays in the controller, as far as is known, when the connection is closed now, and nobody expects
  /// there; empty: nothing. Also while the wire is lost.
  [[nodiscard]] virtual std::string leaves_behind() const { return {}; }

  /// The poll law: how long to wait between rounds.
  [[nodiscard]] virtual Duration moving_period() const = 0;
  [[nodiscard]] virtual Duration idle_period() const = 0;
};

}  // namespace hw
