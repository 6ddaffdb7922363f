#pragma once
// One instant of one controller, as its driver knows it. A plain value of fixed size: published by the
// driver, copied without allocation, drawn by every panel. What is not known is marked so, never guessed.
#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/fixed_text.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/device/intent.h"
#include "core/device/jog_guard.h"
#include "core/device/travel.h"
#include "core/device/trust.h"
#include "core/link/wire_share.h"
#include "core/time/clock.h"

namespace hw {

enum class LinkState : std::uint8_t { connecting, good, late, lost, closed };  ///< late: missed, or garbled

enum class Activity : std::uint8_t { unknown, idle, moving, jogging, homing, stopping, error };

/// How the latest motion of an axis, or run of a program, came to its end.
enum class EndedBy : std::uint8_t {
  nothing,
  target,
  limit,
  stop,       ///< the console's own, with the ramp
  abort,      ///< the console's own, at once
  elsewhere,  ///< cut short by somebody else: the controller's Stop input, another program on the wire
  error,
  lost,
  not_in_place  ///< of a servo axis: its command has ended, and its encoder did not come there
};
/// Where on its profile a motion is, if the controller tells.
enum class Phase : std::uint8_t { unknown, accelerating, constant, decelerating };

/// What keeps an axis in Activity::error until it is cleared, if the controller tells.
enum class AxisError : std::uint8_t {
  none,
  limit_minus,
  limit_plus,
  limit,  ///< one of the two
  alarm,
  stalled,
  too_far,       ///< closed loop: the load stands further off than is allowed
  not_corrected  ///< closed loop: given up after so many attempts
};

/// How a servo axis (AxisInfo::servo) stands to its command.
enum class Loop : std::uint8_t {
  none,       ///< no servo axis: its position is what the controller counts
  unknown,    ///< nobody has told yet whether its loop is closed
  open,       ///< its motor is free: nothing holds it where its command stands
  following,  ///< on its way behind its command, or settling
  in_place,   ///< its error has lain within the deadband for a while
  off_place   ///< its command has long ended, and it does not come there
};

struct AxisState {
  Steps position{};             ///< of a servo axis: its encoder's
  Instant seen_at{};            ///< when the position was read
  bool position_known = false;  ///< false: never read, or not true any more since a loss or reset
  PositionTrust trust;          ///< of what is known
  Travel travel;                ///< the user's; see travel_holds()
  Backlash backlash;            ///< the user's
  Activity activity = Activity::unknown;
  Phase phase = Phase::unknown;
  AxisError error = AxisError::none;
  EndedBy ended_by = EndedBy::nothing;
  std::int8_t direction = 0;  ///< -1, 0, +1 of the present motion
  Pps speed{};                ///< of the present motion, told or asked; 0 when unknown or at rest
  Pps own_speed{};            ///< of a motion for which none is asked (intent::JogStart); 0: not known yet
  bool has_target = false;
  Steps target{};
  bool in_counts = false;  ///< closed loop: position, speed and target count in Catalog::loop_word
  bool has_encoder = false;
  Steps encoder{};
  Loop loop = Loop::none;
  Steps command{};       ///< of a servo axis: where it is sent at this instant
  bool far_off = false;  ///< its error is so large that closing its loop is asked about: intent::Closing
  bool limit_minus = false, limit_plus = false, home = false, alarm = false;
  bool limits_known = false;
  bool enabled = true;   ///< motor current; see AxisInfo::switchable
  bool slipped = false;  ///< its encoder has lain further off than is allowed, and nobody has cleared that
  bool operator==(const AxisState&) const = default;

  /// Where its moves begin, and what relative ones add to.
  [[nodiscard]] Steps commanded() const { return loop == Loop::none ? position : command; }
  /// Its count tells where it stands within its travel: a limit by a doubtful count would be none.
  [[nodiscard]] bool travel_holds() const {
    return travel.any() && position_known && !trust.doubtful() && travel.in_counts == in_counts;
  }
  /// Where it is sent now, or stands.
  [[nodiscard]] Steps goal() const { return has_target ? target : commanded(); }
  [[nodiscard]] Steps following_error() const { return commanded() - position; }
};

enum class RunState : std::uint8_t { idle, running, waiting, held, error };

struct ProgramState {
  RunState run = RunState::idle;
  bool owned = false;                   ///< a stored program of the user's, not a move of the console
  std::int8_t slot = -1;                ///< the program that runs, or the selected one
  std::int16_t command = -1;            ///< index of the live command in the slot's listing; -1 unknown
  bool command_told = false;            ///< true: the controller said so; false: worked out
  bool stepping = false;                ///< stops before each command
  EndedBy ended_by = EndedBy::nothing;  ///< of the latest run of the user's programs
  Instant started_at{};
  bool operator==(const ProgramState&) const = default;
};

/// One thread of a controller that runs several programs at once (ProgramFacts::threads).
struct ThreadState {
  RunState run = RunState::idle;
  bool known = false;
  std::int16_t line = -1;  ///< line of the stored code that runs or waits; -1 unknown
  bool operator==(const ThreadState&) const = default;
};

/// A list of moves on its way into the controller's buffer (intent::FeedMoves).
struct FeedState {
  bool running = false;
  std::int32_t sent = 0, total = 0;
  bool operator==(const FeedState&) const = default;
};

/// What is done in pieces (intent::RunInPieces), as far as it has come.
struct PiecesState {
  bool running = false;
  bool held = false;                 ///< the next piece waits until it is resumed
  bool draws = false;                ///< act by act, without a program: its tool may be on between them
  bool rests = false;                ///< held, and nothing of it is under way here or elsewhere
  bool speed_can_change = false;     ///< intent::OverrideSpeed is taken
  std::int32_t done = 0, total = 0;  ///< pieces
  std::int32_t step = -1;            ///< of the sequence's own list: that is at work, or was last; -1: none
  std::int32_t percent = 100;        ///< of the speeds that were asked for; see intent::OverrideSpeed
  FixedText<240> ended_because;      ///< what has broken it off, as a sentence; empty: nothing
  bool operator==(const PiecesState&) const = default;
};

/// A stored program on its way to or from the controller.
struct TransferState {
  enum class Phase : std::uint8_t { reading, writing, comparing };  ///< comparing: what was written is read
  bool running = false;
  Phase phase = Phase::reading;
  std::int8_t slot = -1;   ///< of it; where programs run in threads, 0 for all
  std::int32_t done = 0;   ///< lines in this phase; it stays when the transfer is broken off
  std::int32_t total = 0;  ///< 0: not known
  Duration left{};         ///< of the whole, by the rate so far; 0: not known
  bool operator==(const TransferState&) const = default;
};

/// What became of the newest intents; a panel finds its own by id.
enum class Fate : std::uint8_t { pending, done, refused, failed };
struct IntentFate {
  static constexpr std::size_t sentence_room = 320;
  IntentId id = 0;
  Fate fate = Fate::pending;
  FaultKind kind = FaultKind::refused;  ///< refused or failed: of the fault
  FixedText<sentence_room> sentence;    ///< the same: Fault::sentence()
  std::uint16_t advice_at = 0;          ///< where in the sentence Fault::advice begins; 0: there is none
  bool asks = false;                    ///< refused until intent::Closing says what is to be done
  std::uint32_t doubtful = 0;           ///< refused for it: bit per axis whose position is not to be trusted
  std::optional<PastTravel> past = {};  ///< refused for it

  void tell(const Fault& fault) {
    const std::string whole = fault.sentence();
    const std::size_t at = whole.size() - fault.advice.size();
    const bool apart = !fault.advice.empty() && at > 0 && whole.size() <= sentence_room;
    kind = fault.kind;
    sentence = whole;
    advice_at = static_cast<std::uint16_t>(apart ? at : 0);
  }
  /// What was told, as far as it is known; its sentence is the same.
  [[nodiscard]] Fault fault() const {
    if (advice_at == 0) return {kind, std::string(sentence.view())};
    return {kind,
            std::string(sentence.view().substr(0, advice_at - 1u)),
            {},
            std::string(sentence.view().substr(advice_at))};
  }
  bool operator==(const IntentFate&) const = default;
};

struct ParamState {
  std::int64_t value = 0;
  bool known = false;
  bool stored = true;  ///< false: changed in RAM since the last store
  bool operator==(const ParamState&) const = default;
};

/// The memory window of a controller as the console has last read it (Catalog::memory says what lies where).
/// A register that reading clears shows what the last reading brought. A copy of what is not known is
/// empty: nothing of before is there when something is known again.
struct WindowImage {
  static constexpr std::size_t bytes = 4096;
  bool known = false;
  bool rings_known = false;  ///< somebody looks: the rings are read too
  std::array<std::uint8_t, bytes> memory{};

  WindowImage() = default;
  WindowImage(const WindowImage& image) { *this = image; }
  WindowImage& operator=(const WindowImage& image) {
    if (image.known)
      memory = image.memory;
    else if (known)
      memory.fill(0);
    known = image.known, rings_known = image.rings_known;
    return *this;
  }

  [[nodiscard]] std::uint32_t value(std::size_t offset, int width) const {
    std::uint32_t v = 0;
    for (int i = 0; i < width; ++i) v = v << 8 | memory[(offset + static_cast<std::size_t>(i)) % bytes];
    return v;
  }
  void put(std::size_t offset, int width, std::uint32_t v) {
    for (int i = width; i-- > 0; v >>= 8)
      memory[(offset + static_cast<std::size_t>(i)) % bytes] = static_cast<std::uint8_t>(v);
  }
  bool operator==(const WindowImage& other) const {
    return known == other.known && rings_known == other.rings_known && (!known || memory == other.memory);
  }
};

/// What the controller has said of itself.
struct Identity {
  FixedText<32> model;     ///< as the controller or catalog names it
  FixedText<24> firmware;  ///< empty: not known
  FixedText<24> serial;
  bool operator==(const Identity&) const = default;
};

/// What a controller does by itself, and goes on doing when nobody watches it.
struct UnderWay {
  std::uint32_t axes = 0;  ///< bit per axis that moves
  bool program = false;    ///< a stored one of the user's runs, waits or is held
  bool held = false;       ///< it, and at present
  std::int8_t slot = -1;   ///< of it
  bool queued = false;     ///< commands wait in its queues
  [[nodiscard]] bool moves() const { return axes != 0 || queued; }
  [[nodiscard]] bool any() const { return program || moves(); }
};

struct LinkHealth {
  LinkState state = LinkState::connecting;
  Duration round_trip{};
  float polls_per_second = 0;
  std::uint32_t misses_in_a_row = 0;
  std::uint64_t timeouts = 0, unparsed_bytes = 0;
  Instant lost_at{};
  Instant next_attempt{};
  int attempts = 0;
  FixedText<640> sentence;  ///< why it is late, lost or closed; what is being done
  /// When the link was lost; nothing any more when it is good again.
  UnderWay when_lost;
  JogEnds jog_ends = JogEnds::by_nobody;  ///< a held one, when this program dies

  [[nodiscard]] bool connected() const { return state == LinkState::good || state == LinkState::late; }
};

inline constexpr int max_inputs = 32, max_outputs = 32, max_analog = 8, max_params = 256, max_slots = 8;
inline constexpr int max_readouts = 96, max_variables = 128, max_threads = 4;

struct Snapshot {
  std::uint64_t sequence = 0;
  Instant at{};
  LinkHealth link;
  Identity identity;
  int axis_count = 0;
  std::array<AxisState, max_axes> axes{};
  std::uint32_t inputs = 0, inputs_known = 0;    ///< bit n-1 = the catalog's input n; 1 = electrically high
  std::uint32_t outputs = 0, outputs_known = 0;  ///< bit n-1 = output n; 1 = on
  Instant io_seen_at{};
  Instant inputs_asked_at{};  ///< of the answer in `inputs`: they may be newer than the outputs
  std::array<std::int32_t, max_analog> analog{};
  std::uint32_t analog_known = 0;
  std::array<Instant, max_analog> analog_seen_at{};
  ProgramState program;
  std::array<ThreadState, max_threads> threads{};
  std::array<std::int16_t, max_axes> queue_free{};  ///< of Catalog::queue_depth; see queue_known
  std::uint32_t queue_known = 0;                    ///< bit per axis
  WindowImage window;
  FeedState feed;
  PiecesState pieces;
  TransferState transfer;
  JogGuard jog_guard;
  std::array<std::int64_t, max_readouts> readouts{};  ///< by index in Catalog::readouts
  std::bitset<max_readouts> readouts_known;
  std::array<Instant, max_readouts> readouts_seen_at{};
  std::array<std::int32_t, max_variables> variables{};  ///< by number
  std::bitset<max_variables> variables_known;
  std::array<std::int16_t, max_slots> slot_bytes_used{};  ///< -1 unknown
  /// Bit per slot (where programs run in threads, 0 for all): what it holds is not what was sent last,
  /// because the transfer was broken off or it reads back otherwise. Until it is loaded again, or read.
  std::uint8_t slots_torn = 0;
  std::array<ParamState, max_params> params{};           ///< by index in Catalog::params
  bool unsaved_setup = false, unsaved_programs = false;  ///< in RAM and not stored
  bool working = false;           ///< at commands that wait in its queues, though no axis may move
  std::uint32_t restarts = 0;     ///< of the controller, as its answers showed while it was connected
  std::int32_t store_count = -1;  ///< writes used of the non-volatile memory; an emulator knows
  /// Commands that may have changed what the controller's programs are, and the last of them (0: a raw
  /// question).
  std::uint32_t program_changes = 0;
  IntentId program_changed_by = 0;
  Duration poll_period{};             ///< what the poll law asks for now
  std::array<IntentFate, 8> fates{};  ///< newest first; what is settled makes room
  FixedText<320> notice;  ///< the worst thing that is true now and is not in the fields above; empty: nothing

  [[nodiscard]] const IntentFate* fate_of(IntentId id) const {
    for (const IntentFate& f : fates)
      if (f.id == id && id != 0) return &f;
    return nullptr;
  }
  /// It was taken up, and so many others have been since that what became of it stands here no more.
  [[nodiscard]] bool forgotten(IntentId id) const {
    if (id == 0 || fate_of(id)) return false;
    return std::any_of(fates.begin(), fates.end(), [id](const IntentFate& f) { return f.id > id; });
  }
  [[nodiscard]] bool axis_moves(int axis) const {
    const Activity now = axes[axis].activity;
    return now == Activity::moving || now == Activity::jogging || now == Activity::homing ||
           now == Activity::stopping;
  }
  [[nodiscard]] bool any_axis_moving() const {
    for (int i = 0; i < axis_count; ++i)
      if (axis_moves(i)) return true;
    return false;
  }
  [[nodiscard]] UnderWay shows_under_way() const {
    UnderWay shown;
    for (int i = 0; i < axis_count; ++i)
      if (axis_moves(i)) shown.axes |= 1u << i;
    shown.program = program.owned && program.run != RunState::idle && program.run != RunState::error;
    shown.held = program.run == RunState::held;
    shown.slot = program.slot;
    shown.queued = working || feed.running;
    return shown;
  }
  /// Without a link what was under way is taken to go on: nobody has seen that it has stopped.
  [[nodiscard]] UnderWay under_way() const { return link.connected() ? shows_under_way() : link.when_lost; }
};

/// Older than three poll periods (and at least 0.6 s): shown dimmed and marked.
inline bool is_stale(Instant seen_at, Instant now, Duration poll_period) {
  const Duration limit = std::max<Duration>(3 * poll_period, Millis(600));
  return now - seen_at > limit;
}

/// One instant of one axis, of a recording that intent::Sample asks for. They travel in a ring, as notices
/// do.
struct AxisSample {
  Instant at{};
  std::uint8_t axis = 0;
  bool moving = false;
  Steps command{}, encoder{};  ///< where it is sent, where it is
  Pps velocity{};              ///< commanded, without sign
  /// Of what the drive output can give, -100 to 100. Worked out by the console from error, speed and gains:
  /// no controller of ours tells it. Known while all gains are.
  float output_percent = 0;
  bool output_known = false;
};

/// How a motion or a program came to its end: told once for each. What a program or a list moves is told with
/// it, unless it ended badly.
struct Ending {
  enum class What : std::uint8_t { motion, jog, homing, program, list, pieces };
  What what = What::motion;
  int axis = -1;          ///< of a motion, jog or homing
  int slot = -1;          ///< of a program: where the catalog has threads, which of them; -1: not known
  Instant began{}, at{};  ///< as they were first seen
  EndedBy by = EndedBy::nothing;
  StoppedBy who = StoppedBy::nobody;  ///< where it was stopped
  /// Of a motion that the console has stopped, from when its core was told: to the first byte, and to rest.
  bool timed = false;
  Duration to_wire{}, to_rest{};
  Steps ran_on{};                     ///< meanwhile, worked out from where it was seen last and its speed
  AxisError error = AxisError::none;  ///< of the axis; of a program that stopped in error: of `failed_axis`
  int failed_axis = -1;               ///< -1: none is in error
  int line = -1;                      ///< of the stored code, from 0: where a program stopped in error
  bool limit_minus = false, limit_plus = false;  ///< are hit
  bool at_travel_end = false;                    ///< of a jog: it went to the end of the user's travel
  bool place_known = false;
  Steps place{};                     ///< where it came to rest
  Steps off{};                       ///< of a servo axis: from its command
  std::int32_t done = 0, total = 0;  ///< of a list or pieces
  bool operator==(const Ending&) const = default;
};

/// Things that must not be lost: they travel in a ring beside the snapshots.
struct Notice {
  enum class Kind : std::uint8_t { info, warning, error, program, question };
  Kind kind = Kind::info;
  Instant at{};
  IntentId intent = 0;
  int slot = -1;           ///< program: which slot `text` is the listing of ...
  bool whole = true;       ///< ... and false: `text` leaves out code that means nothing here
  std::string text;        ///< a sentence, or the listing
  std::vector<int> slots;  ///< question: one of these must be emptied before a move is possible

  Notice() = default;
  Notice(Kind k, Instant when, std::string t) : kind(k), at(when), text(std::move(t)) {}
};

}  // namespace hw
