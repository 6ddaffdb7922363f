#pragma once
// Turns intents into transactions of one model, polls its state, decodes what comes back. Written as
// coroutines that read like the manual's procedures. Io thread only; the pump calls it.
#include <functional>
#include <optional>
#include <string>

#include "core/base/asio.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/link/station.h"

namespace hw {

/// What a driver is given. All outlive it.
struct DriverContext {
  Scheduler& scheduler;
  const Catalog& catalog;
  Snapshot& draft;                           ///< the driver writes it; the pump publishes it
  std::function<void(Notice)> notify;        ///< what must not be lost
  std::function<void()> changed;             ///< something came unasked: publish soon, poll soon
  std::function<void(bool all)> stop_heard;  ///< somebody else on the wire stops this controller
  std::function<void(const AxisSample&)> sample = nullptr;  ///< of a recording: intent::Sample
};

class Driver {
 public:
  virtual ~Driver() = default;

  /// Wire is open: get the controller to listen, find out what it is, read its state. Moves nothing.
  virtual Task<Result<>> connect(Station& station) = 0;
  /// One round of status. Called when no intent waits.
  virtual Task<Result<>> poll() = 0;
  /// Of the next round: somebody waits for what it reads, so it asks everything that it otherwise asks in
  /// turn.
  bool everything_wanted = false;
  /// Everything but Stop and Abort. Returns when the intent is under way (moves) or finished (the rest).
  virtual Task<Result<>> perform(const IntentBody& intent) = 0;
  /// Stop and Abort: runs beside whatever perform() or poll() is under way, which finds its waiting
  /// transactions dropped.
  virtual Task<Result<>> stop(int axis, bool at_once) = 0;
  /// A held jog was let go: stops what it moves. Programs that run beside it go on where there can be any.
  virtual Task<Result<>> stop_jog(int axis) { return stop(axis, false); }
  /// Ends a program (-1: all), beside whatever is under way. Goes out like a stop.
  virtual Task<Result<>> halt_program(int /*thread*/) { return stop(-1, false); }
  /// One message that stops every controller of this kind on the wire, where the maker has one (broadcast).
  /// The stop of each follows.
  virtual Task<Result<>> stop_wire(bool /*at_once*/) { co_return Result<>(); }
  /// What the console has put into the controller for its own use is still there, and the next rounds of
  /// status take it away: a wire that is given up stays open for that.
  [[nodiscard]] virtual bool clears_up() const { return false; }
  /// What stays in the controller when the connection is closed now and nobody expects there; empty: nothing.
  [[nodiscard]] virtual std::string leaves_behind() const { return {}; }
  /// The wire is gone: nothing may be believed any more. The station is invalid afterwards.
  virtual void wire_lost() = 0;
  /// Raw text and its reply without terminator (scripts, `send`).
  virtual Task<Result<std::string>> query(std::string text, Duration patience) = 0;
  /// The same of a text that stops, beside whatever is under way. Where its answer comes long after it,
  /// `said` is called as soon as all of it has gone out.
  virtual Task<Result<std::string>> query_stop(std::string text, Duration patience,
                                               std::function<void()> /*said*/) {
    return query(std::move(text), patience);
  }
  /// Whether the controller answers this raw text by itself and at once.
  [[nodiscard]] virtual bool answers(std::string_view) const { return true; }
  /// Whether it tells by itself, later, that what this raw text began is over: a prompt.
  [[nodiscard]] virtual bool answers_later(std::string_view) const { return false; }
  /// Whether this raw text may change what the controller's programs are.
  [[nodiscard]] virtual bool changes_programs(std::string_view) const { return true; }
  /// Whether this raw text stops what is under way, here or in another controller of the wire, so that
  /// nothing may keep it back.
  [[nodiscard]] virtual bool is_stop(std::string_view) const { return false; }
  /// And whether it stops all axes and programs.
  [[nodiscard]] virtual bool stops_all(std::string_view text) const { return is_stop(text); }
  /// Which devices of a wire that several share this raw text is for.
  [[nodiscard]] virtual Addressees meant_for(const intent::SendText&) const { return Addressees::none(); }
  /// A text that a controller in an error state takes although it answers nothing, connecting included: it
  /// is remembered, and said on the user's word if the controller is silent at the next connect(). False:
  /// this is no such text.
  virtual bool recover_by(std::string_view) { return false; }
  /// Of the latest connect(): the reply to that text. None: it has not been said.
  virtual std::optional<std::string> take_recovery() { return std::nullopt; }
  /// Next unsolicited text for a script, if any has come since the last call.
  virtual bool take_unsolicited(std::string& text) = 0;

  /// The poll law: how long to wait between rounds.
  [[nodiscard]] virtual Duration moving_period() const = 0;
  [[nodiscard]] virtual Duration idle_period() const = 0;
};

}  // namespace hw
