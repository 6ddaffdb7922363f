#pragma once
// Turns intents into transactions of one model, polls its state, decodes what comes back. Written as
// coroutines that read like the manual's procedures. The pump runs one of them at a time; a stop ends it
// (Station::preempt) and takes its place. Io thread only.
//
// What the other parts of the program expect of a driver:
//
// - Intents. MoveTo, MoveBy, JogStart, Home, SetPosition, SetParam, ReadParams, SendText, Reset and ReadAgain
//   are handled by every driver, as far as its catalog offers them. A driver refuses what its controller
//   cannot do with FaultKind::refused and a sentence, before a byte is sent: panels request only what the
//   catalog offers (outputs, programs, actions, readouts to watch), but scripts anything. Stop, Abort,
//   JogStop, JogKeepAlive, Reconnect, TrustPosition, RecallPositions, SetTravel, SetBacklash, RunInPieces and
//   OverrideSpeed never come here: the pump handles them.
// - Faults. refused: nothing was sent. controller: it refused. no_answer, garbled: the command may have been
//   carried out. stopped: a stop took the wire. lost: the wire is gone. The pump repeats nothing.
// - Stops: see stop(). `tool` switches the outputs of StopOrder::tool. Without outputs there is nothing to do
//   for `tool`, without programs nothing for `program`. A second stop of the same scope comes with
//   StopOrder::at_once. stop_progress() says `stands` only from values read since the stop was sent.
// - Outputs. SetOutput reads them back: outputs, outputs_known and io_seen_at are those of that reading.
// - Snapshot. The driver writes the axes (but travel and backlash), programs, threads, the feed, transfers,
//   parameters, readouts, lines and its identity. The pump writes link, pieces, outcomes and poll_period. A
//   value that is no longer known is marked as unknown, never left as it was: a parameter before it is
//   written, since a stop may cut the reading that follows.
// - Restarts. The driver increments Snapshot::restarts when the controller was switched on or reset, and in
//   the same round marks each axis that may have lost its zero (PositionTrust::doubt).
// - Notices. info, warning, error: a sentence for the user. program: the listing of a slot for which the
//   editor waits. question: a move needs one of these slots to be emptied first.
#include <functional>
#include <string>
#include <string_view>

#include "core/base/asio.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/script_texts.h"
#include "core/device/snapshot.h"
#include "core/device/stop.h"
#include "core/device/text_goals.h"
#include "core/link/station.h"

namespace hw {

/// What a driver is given. All of it outlives the driver.
struct DriverContext {
  Scheduler& scheduler;
  const Catalog& catalog;
  Snapshot& snapshot;                  ///< the driver writes it; the pump publishes it
  ScriptTexts& texts;                  ///< unsolicited messages, for scripts
  std::function<void(Notice)> notify;  ///< messages that must not be lost
  std::function<void()> changed;       ///< an unsolicited message came: publish and poll soon
  std::function<void(const AxisSample&)> sample = nullptr;  ///< samples of a recording: intent::Sample
};

/// The questions of a status round.
enum class Round : std::uint8_t {
  stopping,  ///< only readings that show whether the controller is at rest
  usual,
  everything  ///< a caller waits for it: also the readings that are usually taken in turn
};

class Driver {
 public:
  virtual ~Driver() = default;

  /// A wire is open, and stops may be sent. The state of the controller is not known yet. Must send nothing.
  virtual void attach(Station& station) = 0;
  /// Make the controller listen, identify it, and read its state. Moves nothing.
  virtual Task<Result<>> connect() = 0;
  /// Run one status round.
  virtual Task<Result<>> poll(Round round) = 0;
  /// A script reacts to inputs until then: a long round reads them again between its other questions, and
  /// publishes them at once.
  virtual void watch_inputs(Instant /*until*/) {}
  /// The same for limit switches.
  virtual void watch_limits(Instant /*until*/) {}
  /// Perform any intent but a stop. Returns when a motion is under way, or anything else is finished.
  virtual Task<Result<>> perform(const IntentBody& intent) = 0;
  /// Send a stop completely, without waiting for its effect: returns when the controller has acknowledged the
  /// last byte, or has had the time to. Must work before connect(), and in any state. Called again for the
  /// same order until stop_progress() says that it stands. Returns the answer to a stop that the user typed,
  /// if any. If that answer is a refusal, return a fault of kind `controller`: the console's own stop
  /// follows.
  virtual Task<Result<std::string>> stop(const StopOrder& order) = 0;
  /// The exact bytes that stop a jog of these axes (a bit each) when the console is dead, for the attached
  /// wire. They begin with what discards a torn message, or at least ends it: on most wires a line end. They
  /// may stop more axes where the controller has no smaller stop.
  [[nodiscard]] virtual LastWill last_will(unsigned axes) const = 0;
  /// How far the stop has come, by the status round that has just ended. If this asks for a stop that the
  /// user typed to be repeated, the console's own stop is sent. Never called for `tool`, whose outputs the
  /// pump reads, nor for a typed stop that is answered at once.
  virtual StopProgress stop_progress(const StopOrder& order) = 0;
  /// The wire is gone: forget motions under way, replies awaited and commands half sent, mark positions as
  /// unknown, send nothing. The set-up may be left as it was read; connect() reads it again. The station is
  /// invalid afterwards.
  virtual void wire_lost() = 0;

  /// Send raw text and return its reply without terminator (scripts, `send`). Never a stop.
  virtual Task<Result<std::string>> query(std::string text, Duration patience) = 0;
  [[nodiscard]] virtual TextMeaning meaning_of(const intent::SendText& text) const = 0;
  /// Where a raw text sends the axes, from where they stand now. Called before it is sent, so it must be
  /// quick even for a long text.
  [[nodiscard]] virtual TextGoals goals_of(std::string_view /*text*/) const { return {}; }
  /// Another session on this wire sends this text to all its controllers, and so to this one.
  virtual void note_broadcast(const std::string& /*text*/) {}

  /// The controller still holds data that the console put there for its own use. The next status rounds
  /// remove it; the wire stays open for that.
  [[nodiscard]] virtual bool clears_up() const { return false; }
  /// A sentence on unexpected data that stays in the controller if the connection is closed now; empty: none.
  /// Also valid while the wire is lost.
  [[nodiscard]] virtual std::string leaves_behind() const { return {}; }

  /// The poll law: how long to wait between rounds.
  [[nodiscard]] virtual Duration moving_period() const = 0;
  [[nodiscard]] virtual Duration idle_period() const = 0;
};

}  // namespace hw
