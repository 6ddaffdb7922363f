#pragma once
// What the user wants, as a value. A few verbs serve every controller; what a controller cannot do its driver
// refuses with a sentence.
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

/// Who has asked for a stop.
enum class StoppedBy : std::uint8_t {
  button,  ///< of the console, under the mouse
  key,     ///< Esc
  script,
  text,     ///< the maker's own words
  let_go,   ///< a jog's hand
  console,  ///< the console itself: nobody held the jog any more, a link that was lost, its end
  nobody    ///< that is known
};

namespace intent {

/// What becomes of a servo axis whose loop is about to close, or to drive harder, while it stands far from
/// its command.
enum class Closing : std::uint8_t {
  ask,    ///< nothing: the intent is refused, and IntentFate::asks is set
  drive,  ///< it is driven there at once
  stay    ///< it stays: the place where it stands becomes its command first
};

/// Of one motion, in the controller's own unit: see DeviceType::acceleration. None: as the controller is set.
using Acceleration = std::optional<std::int64_t>;

/// How fast a motion goes, and how it comes there. What it sets is given back behind it.
struct Pace {
  Pps speed;  ///< 0: as the controller is set
  Acceleration acceleration = {};
};

struct MoveTo {
  std::vector<AxisTarget>
      targets;  ///< absolute; several axes: together where the controller can, else in order
  Pps speed;    ///< 0: as the controller is set
  Acceleration acceleration = {};  ///< see Pace
  bool despite_doubt = false;      ///< this once, although a position is not to be trusted; see PositionTrust
  explicit MoveTo(std::vector<AxisTarget> t, Pps s = {}) : targets(std::move(t)), speed(s) {}
};
struct MoveBy {
  std::vector<AxisTarget> distances;
  Pps speed;
  Acceleration acceleration = {};
  explicit MoveBy(std::vector<AxisTarget> d, Pps s = {}) : distances(std::move(d)), speed(s) {}
};
template <class Motion>
[[nodiscard]] Pace pace_of(const Motion& motion) {
  return {motion.speed, motion.acceleration};
}
/// Continuous jog. Whoever holds it sends JogKeepAlive at least every 250 ms, else the pump stops the axis.
struct JogStart {
  AxisId axis;
  Sign sign;
  Pps speed;      ///< 0: the controller's own jog or high speed
  bool dead_man;  ///< false for scripts, which stop it themselves
  /// The end of the user's travel that way, which the pump fills in: the jog is sent as a move there, so that
  /// the controller ends it whatever becomes of the console.
  std::optional<Steps> up_to;
  Acceleration acceleration = {};
  JogStart(AxisId a, Sign s, Pps v = {}, bool guarded = true)
      : axis(a), sign(s), speed(v), dead_man(guarded) {}
};
struct JogKeepAlive {};
/// The hand lets go of its jog; a jog that a script holds goes on.
struct JogStop {
  int axis = -1;  ///< filled in on the way: that of the jog which ends; -1: not known, so all
};
struct Home {
  AxisId axis;
  Sign sign;
  int mode;  ///< index into Catalog::homing_modes
  Pace pace = {};
  Home(AxisId a, Sign s, int m = 0) : axis(a), sign(s), mode(m) {}
};
/// Ramp down. Always goes out first. On an axis that is already stopping, or asked twice: at once, without
/// ramp. The first one of all axes ramps also beside that of a single axis.
struct Stop {
  int axis;  ///< -1: all
  StoppedBy by;
  explicit Stop(int a = -1, StoppedBy who = StoppedBy::button) : axis(a), by(who) {}
};
/// At once, without ramp; positions may be lost.
struct Abort {
  int axis;
  StoppedBy by;
  explicit Abort(int a = -1, StoppedBy who = StoppedBy::button) : axis(a), by(who) {}
};
/// Makes the present position read `value` (0: zero here). axis -1: all axes to 0.
struct SetPosition {
  int axis;
  Steps value;
  explicit SetPosition(int a, Steps v = {}) : axis(a), value(v) {}
};
/// Takes the present position for true as it reads, on the user's word. Nothing is sent.
struct TrustPosition {
  AxisId axis;
  explicit TrustPosition(AxisId a) : axis(a) {}
};
/// What an earlier session has kept of all axes, by AxisId: taken for axes of which nothing better is known.
/// Nothing is sent.
struct RecallPositions {
  std::vector<KeptPosition> kept;
  explicit RecallPositions(std::vector<KeptPosition> k) : kept(std::move(k)) {}
};
/// How far the user lets an axis go. Nothing is sent; also without a connection.
struct SetTravel {
  AxisId axis;
  Travel travel;
  SetTravel(AxisId a, Travel t) : axis(a), travel(t) {}
};
/// How the play of an axis is taken up by moves from now on. Nothing is sent.
struct SetBacklash {
  AxisId axis;
  Backlash backlash;
  SetBacklash(AxisId a, Backlash b) : axis(a), backlash(b) {}
};
/// Makes the present encoder count read `value`.
struct SetEncoder {
  int axis;
  Steps value;
  explicit SetEncoder(int a, Steps v = {}) : axis(a), value(v) {}
};
/// Motor current of one axis (-1: all) on or off.
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
  bool confirmed;  ///< the user has read the parameter's warning
  Closing closing = Closing::ask;
  SetParam(std::string m, std::int64_t v, bool c = false) : mnemonic(std::move(m)), value(v), confirmed(c) {}
};
/// Into Snapshot::params. All of them, and the variables that are stored; or only one, where the controller
/// can be asked for one.
struct ReadParams {
  std::string only;  ///< mnemonic; empty: all
  explicit ReadParams(std::string mnemonic = {}) : only(std::move(mnemonic)) {}
};
/// One analog input, now: where there are many, a round of status reads one of them.
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
/// Clear the slot, write the text, read it back and compare. Texts with own program headings: slot -1.
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
  /// Where a text that the console itself has written goes; a text of the user's is his own word.
  std::vector<AxisTarget> places;
  bool despite_doubt = false;
  bool as_it_is = false;  ///< this once, although it is not what was sent last; see Snapshot::slots_torn
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
/// Goes out like a stop. Where the catalog has threads the motion that one has begun goes on.
struct HaltProgram {
  int thread;
  StoppedBy by;
  explicit HaltProgram(int t = -1, StoppedBy who = StoppedBy::button) : thread(t), by(who) {}
};
/// One of Catalog::actions with a value for each of its fields.
struct Act {
  int action;  ///< index into Catalog::actions
  std::vector<std::int64_t> values;
  Closing closing = Closing::ask;
  bool despite_doubt = false;
  Act(int a, std::vector<std::int64_t> v) : action(a), values(std::move(v)) {}
};
/// Catalog::jog_guard is installed, as its user has agreed to, or taken away again.
struct GuardJogs {
  bool on;
  explicit GuardJogs(bool o) : on(o) {}
};
struct SetVariable {
  int number;
  std::int64_t value;
  SetVariable(int n, std::int64_t v) : number(n), value(v) {}
};
/// Somebody looks at these readout groups: their values are polled in each round. Bit n = group n of
/// Catalog::readout_groups. The rest is read in turn, one a round.
struct Watch {
  std::uint32_t groups;
  explicit Watch(std::uint32_t g) : groups(g) {}
};
/// Records one axis as fast as its controller can be read, for `length`, into the ring of AxisSample. A new
/// one ends the one before; length 0 only ends it.
struct Sample {
  AxisId axis;
  std::chrono::milliseconds length;
  Sample(AxisId a, std::chrono::milliseconds l) : axis(a), length(l) {}
};
/// Feeds a list of moves into the controller's buffer as places become free; see MoveListFacts. A stop ends
/// it.
struct FeedMoves {
  /// In a row: where that axis stands when the list begins; its own speed.
  static constexpr std::int64_t as_it_is = std::numeric_limits<std::int64_t>::min();
  std::vector<std::vector<std::int64_t>> rows;
  bool despite_doubt = false;
  explicit FeedMoves(std::vector<std::vector<std::int64_t>> r) : rows(std::move(r)) {}
};
/// A sequence in pieces; see Pieces. A stop ends it, a hold keeps the next piece back, and another one takes
/// the place of what is left.
struct RunInPieces {
  std::shared_ptr<const Pieces> pieces;
  std::shared_ptr<PieceSeat> seat;  ///< among those that do theirs together with it; null: it is alone
  bool despite_doubt = false;
  explicit RunInPieces(std::shared_ptr<const Pieces> p, std::shared_ptr<PieceSeat> s = {})
      : pieces(std::move(p)), seat(std::move(s)) {}
};
/// Of what is done in pieces: from the next move on that goes into the controller's buffer, or the next
/// piece.
struct OverrideSpeed {
  int percent;  ///< of the speeds that were asked for, 10 to 200
  explicit OverrideSpeed(int p) : percent(p) {}
};
/// The maker's own text, framing added by the driver, no waiting.
struct SendText {
  std::string text;
  bool broadcast;  ///< to all devices of the wire; no reply is expected
  explicit SendText(std::string t, bool to_all = false) : text(std::move(t)), broadcast(to_all) {}
};
struct Reset {};      ///< as if power had been switched off and on
struct Reconnect {};  ///< try now
struct ReadAgain {};  ///< read the whole state afresh (after a doubt)

}  // namespace intent

using IntentBody = std::variant<
    intent::MoveTo, intent::MoveBy, intent::JogStart, intent::JogKeepAlive, intent::JogStop, intent::Home,
    intent::Stop, intent::Abort, intent::SetPosition, intent::TrustPosition, intent::RecallPositions,
    intent::SetTravel, intent::SetBacklash, intent::SetEncoder, intent::SetPower, intent::SetOutput,
    intent::SetParam, intent::ReadParams, intent::ReadAnalog, intent::Store, intent::SelectProgram,
    intent::LoadProgram, intent::UploadProgram, intent::ClearProgram, intent::RunProgram, intent::Pause,
    intent::Resume, intent::SingleStep, intent::HaltProgram, intent::Act, intent::GuardJogs,
    intent::SetVariable, intent::Watch, intent::Sample, intent::FeedMoves, intent::RunInPieces,
    intent::OverrideSpeed, intent::SendText, intent::Reset, intent::Reconnect, intent::ReadAgain>;

/// Of an intent that may close a servo loop; null: of no other.
inline intent::Closing* closing_of(IntentBody& body) {
  if (auto* i = std::get_if<intent::SetPower>(&body)) return &i->closing;
  if (auto* i = std::get_if<intent::SetParam>(&body)) return &i->closing;
  if (auto* i = std::get_if<intent::Act>(&body)) return &i->closing;
  return nullptr;
}

/// Of a stop; of nothing else.
inline void asked_by(IntentBody& body, StoppedBy who) {
  std::visit(
      [who](auto& wish) {
        if constexpr (requires { wish.by; }) wish.by = who;
      },
      body);
}

struct Intent {
  IntentId id = 0;
  IntentBody body;
  Instant asked_at{};  ///< by a hand or a script, on its own thread; 0: not told
  Intent(IntentId i, IntentBody b, Instant at = {}) : id(i), body(std::move(b)), asked_at(at) {}
};

}  // namespace hw
