#pragma once
// A request of the user, as a value. The same intents serve every controller; a driver refuses an intent that
// its controller cannot perform, with a sentence.
#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/units.h"
#include "core/device/backlash.h"
#include "core/device/travel.h"
#include "core/device/trust.h"
#include "core/time/clock.h"

namespace hw {

struct Pieces;
class PieceSeat;

using IntentId = std::uint64_t;

struct AxisTarget {
  AxisId axis;
  Steps value;
  bool operator==(const AxisTarget&) const = default;
};

/// Who requested a stop.
enum class StoppedBy : std::uint8_t {
  button,  ///< the console's Stop button
  key,     ///< Esc
  script,
  text,     ///< a command that the user typed
  let_go,   ///< the user let go of a held jog
  console,  ///< the console itself: the hold of a jog was interrupted, the link was lost, the program ends
  unknown
};

namespace intent {

/// How to treat a servo axis that is far from its command when its loop is closed or its gains are raised.
enum class Closing : std::uint8_t {
  ask,    ///< refuse the intent and set IntentOutcome::asks
  drive,  ///< let the loop drive the axis there at once
  stay    ///< hold the axis where it is: its position becomes its command first
};

/// Of one motion, in the controller's own unit (DeviceType::acceleration). None: as the controller is set up.
using Acceleration = std::optional<std::int64_t>;

/// Speed and ramp of one motion. The controller's own settings are restored after it.
struct Pace {
  Pps speed;  ///< 0: as the controller is set up
  Acceleration acceleration = {};
};

/// By axis: its speed in a move of several axes that move in turn (see Capabilities::interpolates); 0: the
/// speed of the move.
using AxisSpeeds = std::array<Pps, max_axes>;

struct MoveTo {
  std::vector<AxisTarget>
      targets;  ///< absolute; several axes move together where the controller can, else in order
  Pps speed;    ///< 0: as the controller is set up
  Acceleration acceleration = {};  ///< see Pace
  AxisSpeeds own_speeds{};
  bool despite_doubt = false;  ///< perform it this once although a position is doubtful; see PositionTrust
  explicit MoveTo(std::vector<AxisTarget> t, Pps s = {}) : targets(std::move(t)), speed(s) {}
};
struct MoveBy {
  std::vector<AxisTarget> distances;
  Pps speed;
  Acceleration acceleration = {};
  AxisSpeeds own_speeds{};
  explicit MoveBy(std::vector<AxisTarget> d, Pps s = {}) : distances(std::move(d)), speed(s) {}
};
template <class Motion>
[[nodiscard]] Pace pace_of(const Motion& motion) {
  return {motion.speed, motion.acceleration};
}
/// Continuous jog. The holder sends JogKeepAlive at least every 250 ms, or the pump stops the axis.
struct JogStart {
  AxisId axis;
  Sign sign;
  Pps speed;      ///< 0: the controller's own jog or high speed
  bool dead_man;  ///< false for scripts, which stop the jog themselves
  /// The user's limit in that direction, filled in by the pump. The jog is sent as a move to it, so that the
  /// controller ends the jog even if the console dies.
  std::optional<Steps> up_to;
  Acceleration acceleration = {};
  JogStart(AxisId a, Sign s, Pps v = {}, bool guarded = true)
      : axis(a), sign(s), speed(v), dead_man(guarded) {}
};
struct JogKeepAlive {};
/// Ends a held jog; a script's jog continues.
struct JogStop {
  int axis = -1;  ///< filled in by the pump: the axis whose jog ends; -1: not known, so all
  StoppedBy by = StoppedBy::let_go;  ///< console: the hold was interrupted
};
struct Home {
  AxisId axis;
  Sign sign;
  int mode;  ///< index into Catalog::homing_modes
  Pace pace = {};
  Home(AxisId a, Sign s, int m = 0) : axis(a), sign(s), mode(m) {}
};
/// Ramp down. Always sent first. Requested twice, or for an axis that is stopping already: at once, without a
/// ramp. The first stop of all axes ramps even if a single axis is stopping.
struct Stop {
  int axis;  ///< -1: all
  StoppedBy by;
  explicit Stop(int a = -1, StoppedBy b = StoppedBy::button) : axis(a), by(b) {}
};
/// Stop at once, without a ramp; positions may be lost.
struct Abort {
  int axis;
  StoppedBy by;
  explicit Abort(int a = -1, StoppedBy b = StoppedBy::button) : axis(a), by(b) {}
};
/// Make the present position read `value` (0: zero here). axis -1: all axes to 0.
struct SetPosition {
  int axis;
  Steps value;
  explicit SetPosition(int a, Steps v = {}) : axis(a), value(v) {}
};
/// Trust the present position, on the user's word. Nothing is sent.
struct TrustPosition {
  AxisId axis;
  explicit TrustPosition(AxisId a) : axis(a) {}
};
/// The positions kept by an earlier session, by AxisId: used for axes whose position is not known better.
/// Nothing is sent.
struct RecallPositions {
  std::vector<KeptPosition> kept;
  explicit RecallPositions(std::vector<KeptPosition> k) : kept(std::move(k)) {}
};
/// Set the user's limits of an axis. Nothing is sent; works without a connection.
struct SetTravel {
  AxisId axis;
  Travel travel;
  SetTravel(AxisId a, Travel t) : axis(a), travel(t) {}
};
/// Set how moves take up the backlash of an axis. Nothing is sent.
struct SetBacklash {
  AxisId axis;
  Backlash backlash;
  SetBacklash(AxisId a, Backlash b) : axis(a), backlash(b) {}
};
/// Make the present encoder count read `value`.
struct SetEncoder {
  int axis;
  Steps value;
  explicit SetEncoder(int a, Steps v = {}) : axis(a), value(v) {}
};
/// Switch the motor current of one axis (-1: all).
struct SetPower {
  int axis;
  bool on;
  Closing closing;
  SetPower(int a, bool o, Closing c = Closing::ask) : axis(a), on(o), closing(c) {}
};
struct SetOutput {
  int number;  ///< the maker's: Catalog::output_number
  bool on;
  SetOutput(int n, bool o) : number(n), on(o) {}
};
struct SetParam {
  std::string mnemonic;
  std::int64_t value;
  bool confirmed;  ///< the user has confirmed the parameter's warning
  Closing closing = Closing::ask;
  SetParam(std::string m, std::int64_t v, bool c = false) : mnemonic(std::move(m)), value(v), confirmed(c) {}
};
/// Read parameters and stored variables into Snapshot::params; or a single parameter, where the controller
/// can be asked for one.
struct ReadParams {
  std::string only;  ///< mnemonic; empty: all
  explicit ReadParams(std::string mnemonic = {}) : only(std::move(mnemonic)) {}
};
/// Read one analog input now: where there are many, a status round reads only one of them.
struct ReadAnalog {
  int number;  ///< from 1
  explicit ReadAnalog(int n) : number(n) {}
};
/// Copy set-up and programs into the controller's non-volatile memory.
struct Store {};
struct SelectProgram {
  int slot;
  explicit SelectProgram(int s) : slot(s) {}
};
/// Clear the slot, write the text, read it back and compare. A text with program headings: slot -1.
struct LoadProgram {
  int slot;
  std::string text;
  LoadProgram(int s, std::string t) : slot(s), text(std::move(t)) {}
};
struct UploadProgram {  ///< -> Notice{program} with the listing
  int slot;
  explicit UploadProgram(int s) : slot(s) {}
};
struct ClearProgram {
  int slot;
  explicit ClearProgram(int s) : slot(s) {}
};
/// `slot`: where the catalog has threads, the thread to run.
struct RunProgram {
  int slot;
  /// The targets of a text that the console has written; a text of the user's is the user's own
  /// responsibility.
  std::vector<AxisTarget> places;
  bool despite_doubt = false;
  bool as_it_is =
      false;  ///< run it this once although it is not what was sent last; see Snapshot::slots_torn
  explicit RunProgram(int s, std::vector<AxisTarget> p = {}) : slot(s), places(std::move(p)) {}
};
struct Pause {  ///< hold before the next command
  int thread;   ///< -1: the only one, or all
  explicit Pause(int t = -1) : thread(t) {}
};
struct Resume {  ///< go on from a hold or a wait for the host
  int thread;
  explicit Resume(int t = -1) : thread(t) {}
};
struct SingleStep {};  ///< from a hold: one command
/// Sent like a stop. Where the catalog has threads, a motion that the thread began continues.
struct HaltProgram {
  int thread;
  StoppedBy by;
  explicit HaltProgram(int t = -1, StoppedBy b = StoppedBy::button) : thread(t), by(b) {}
};
/// One of Catalog::actions with a value for each of its fields.
struct Act {
  int action;  ///< index into Catalog::actions
  std::vector<std::int64_t> values;
  Closing closing = Closing::ask;
  bool despite_doubt = false;
  Act(int a, std::vector<std::int64_t> v) : action(a), values(std::move(v)) {}
};
/// Install Catalog::jog_guard, with the user's consent, or remove it.
struct GuardJogs {
  bool on;
  explicit GuardJogs(bool o) : on(o) {}
};
struct SetVariable {
  int number;
  std::int64_t value;
  SetVariable(int n, std::int64_t v) : number(n), value(v) {}
};
/// These readout groups are on screen: their values are polled in each round. Bit n = group n of
/// Catalog::readout_groups. The other groups are read in turn, one a round.
struct Watch {
  std::uint32_t groups;
  explicit Watch(std::uint32_t g) : groups(g) {}
};
/// Record one axis for `length`, as fast as its controller can be read, into the ring of AxisSample. A new
/// recording ends the one before; length 0 only ends it.
struct Sample {
  AxisId axis;
  std::chrono::milliseconds length;
  Sample(AxisId a, std::chrono::milliseconds l) : axis(a), length(l) {}
};
/// Feed a list of moves into the controller's buffer as places become free; see MoveListFacts. A stop ends
/// it.
struct FeedMoves {
  /// In a row: the position of the axis when the list begins, or its own speed.
  static constexpr std::int64_t as_it_is = std::numeric_limits<std::int64_t>::min();
  std::vector<std::vector<std::int64_t>> rows;
  bool despite_doubt = false;
  explicit FeedMoves(std::vector<std::vector<std::int64_t>> r) : rows(std::move(r)) {}
};
/// Run a sequence in pieces; see Pieces. A stop ends it, a hold keeps the next piece back, and a new one
/// replaces the rest.
struct RunInPieces {
  std::shared_ptr<const Pieces> pieces;
  std::shared_ptr<PieceSeat> seat;  ///< among the controllers that run it together; null: it runs alone
  bool despite_doubt = false;
  explicit RunInPieces(std::shared_ptr<const Pieces> p, std::shared_ptr<PieceSeat> s = {})
      : pieces(std::move(p)), seat(std::move(s)) {}
};
/// Change the speed of a sequence in pieces, from the next buffered move or the next piece on.
struct OverrideSpeed {
  int percent;  ///< of the requested speeds, 10 to 200
  explicit OverrideSpeed(int p) : percent(p) {}
};
/// Send the maker's own text; the driver adds the framing. Does not wait for what it begins.
struct SendText {
  std::string text;
  bool broadcast;  ///< to all devices on the wire; no reply is expected
  explicit SendText(std::string t, bool to_all = false) : text(std::move(t)), broadcast(to_all) {}
};
struct Reset {};      ///< as if power had been switched off and on
struct Reconnect {};  ///< try to connect now
struct ReadAgain {};  ///< read the whole state again

}  // namespace intent

using AnyIntent = std::variant<
    intent::MoveTo, intent::MoveBy, intent::JogStart, intent::JogKeepAlive, intent::JogStop, intent::Home,
    intent::Stop, intent::Abort, intent::SetPosition, intent::TrustPosition, intent::RecallPositions,
    intent::SetTravel, intent::SetBacklash, intent::SetEncoder, intent::SetPower, intent::SetOutput,
    intent::SetParam, intent::ReadParams, intent::ReadAnalog, intent::Store, intent::SelectProgram,
    intent::LoadProgram, intent::UploadProgram, intent::ClearProgram, intent::RunProgram, intent::Pause,
    intent::Resume, intent::SingleStep, intent::HaltProgram, intent::Act, intent::GuardJogs,
    intent::SetVariable, intent::Watch, intent::Sample, intent::FeedMoves, intent::RunInPieces,
    intent::OverrideSpeed, intent::SendText, intent::Reset, intent::Reconnect, intent::ReadAgain>;

// What copies, moves, destroys or visits any intent is not inline: every file that includes this one would
// compile it again, two seconds each.

struct IntentBody : AnyIntent {
  using AnyIntent::AnyIntent;
  IntentBody(const IntentBody& other);
  IntentBody(IntentBody&& other) noexcept;
  IntentBody& operator=(const IntentBody& other);
  IntentBody& operator=(IntentBody&& other) noexcept;
  ~IntentBody();
};

template <class... Intents>
bool is_any_of(const IntentBody& body) {
  return (std::holds_alternative<Intents>(body) || ...);
}

/// The answer in an intent that may close a servo loop; null for any other intent.
intent::Closing* closing_of(IntentBody& body);

/// Notes who requested a stop; does nothing to any other intent.
void asked_by(IntentBody& body, StoppedBy by);

struct Intent {
  IntentId id = 0;
  IntentBody body;
  Instant asked_at{};  ///< when the hand or script requested it, on its own thread; 0: not known
  Intent(IntentId i, IntentBody b, Instant at = {});
};

}  // namespace hw
