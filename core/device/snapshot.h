#pragma once
// One instant of one controller, as its driver knows it. A plain value of fixed size: published by the
// pump, copied without allocation, drawn by every panel. An unknown value is marked as unknown, never
// guessed.
#include <algorithm>
#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>

#include "core/base/fixed_text.h"
#include "core/base/result.h"
#include "core/base/units.h"
#include "core/device/axis_state.h"
#include "core/device/intent.h"
#include "core/device/jog_guard.h"
#include "core/link/wire_share.h"
#include "core/time/clock.h"

namespace hw {

enum class LinkState : std::uint8_t {
  connecting,
  good,
  late,
  lost,
  closed
};  ///< late: an answer was missed or garbled

enum class RunState : std::uint8_t { idle, running, waiting, held, error };

struct ProgramState {
  RunState run = RunState::idle;
  bool owned = false;                   ///< the user's stored program, not a move of the console
  std::int8_t slot = -1;                ///< the program that runs, or the selected one
  std::int16_t command = -1;            ///< index of the live command in the slot's listing; -1 unknown
  bool command_reported = false;        ///< true: reported by the controller; false: worked out
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

/// The progress of a sequence that runs in pieces (intent::RunInPieces).
struct PiecesState {
  bool running = false;
  bool held = false;                 ///< the next piece waits until it is resumed
  bool draws = false;                ///< drawn act by act, without a program: the tool may be on between acts
  bool rests = false;                ///< held, and no act is under way on any controller
  bool speed_can_change = false;     ///< intent::OverrideSpeed is accepted
  std::int32_t done = 0, total = 0;  ///< pieces
  std::int32_t step = -1;            ///< place in the sequence's list of the present or latest step; -1: none
  std::int32_t percent = 100;        ///< of the requested speeds; see intent::OverrideSpeed
  FixedText<240> ended_because;      ///< why the run was broken off, as a sentence; empty: it was not
  std::uint64_t drawing = 0;         ///< Pieces::drawing of the present or latest run
  /// The latest unfinished drawing, and the step where its rest begins; kept while sequences run that are no
  /// drawings. 0: none.
  std::uint64_t rest_of = 0;
  std::int32_t rest_step = 0;
  bool operator==(const PiecesState&) const = default;
};

/// A stored program on its way to or from the controller.
struct TransferState {
  enum class Phase : std::uint8_t {
    reading,
    writing,
    comparing
  };  ///< comparing: reading back what was written
  bool running = false;
  Phase phase = Phase::reading;
  std::int8_t slot = -1;   ///< of the program; 0 for all where programs run in threads
  std::int32_t done = 0;   ///< lines in this phase; kept when the transfer is broken off
  std::int32_t total = 0;  ///< 0: not known
  Duration left{};         ///< for all phases, by the rate so far; 0: not known
  bool operator==(const TransferState&) const = default;
};

/// The outcome of the newest intents; a panel finds its own by id.
enum class IntentState : std::uint8_t { pending, done, refused, failed };
struct IntentOutcome {
  static constexpr std::size_t sentence_room = 320;
  IntentId id = 0;
  IntentState state = IntentState::pending;
  FaultKind kind = FaultKind::refused;  ///< of the fault, if refused or failed
  FixedText<sentence_room> sentence;    ///< Fault::sentence(), if refused or failed
  std::uint16_t advice_at = 0;          ///< where in the sentence Fault::advice begins; 0: there is none
  bool asks = false;                    ///< refused until intent::Closing says what to do
  std::uint32_t doubtful = 0;  ///< why it was refused: a bit per axis whose position cannot be trusted
  std::optional<PastTravel> past = {};  ///< why it was refused

  void set_fault(const Fault& fault) {
    const std::string whole = fault.sentence();
    const std::size_t at = whole.size() - fault.advice.size();
    const bool apart = !fault.advice.empty() && at > 0 && whole.size() <= sentence_room;
    kind = fault.kind;
    sentence = whole;
    advice_at = static_cast<std::uint16_t>(apart ? at : 0);
  }
  /// The fault that was reported, as far as it is kept; its sentence is the same.
  [[nodiscard]] Fault fault() const {
    if (advice_at == 0) return {kind, std::string(sentence.view())};
    return {kind,
            std::string(sentence.view().substr(0, advice_at - 1u)),
            {},
            std::string(sentence.view().substr(advice_at))};
  }
  bool operator==(const IntentOutcome&) const = default;
};

struct ParamState {
  std::int64_t value = 0;
  bool known = false;
  bool stored = true;  ///< false: changed in RAM since the last store
  bool operator==(const ParamState&) const = default;
};

/// The memory window of a controller as the console has last read it (layout: Catalog::memory). A register
/// that is cleared by reading shows its last value. Copying an unknown image empties the copy, so that no old
/// value remains when cells are read again.
struct WindowImage {
  static constexpr std::size_t bytes = 4096;
  bool known = false;
  bool rings_known = false;  ///< the rings are on screen, and so read too
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

/// The identity that the controller reports.
struct Identity {
  FixedText<32> model;     ///< the controller's own name, else the catalog's
  FixedText<24> firmware;  ///< empty: not known
  FixedText<24> serial;
  bool operator==(const Identity&) const = default;
};

/// The work that a controller does by itself, and continues without the console.
struct UnderWay {
  std::uint32_t axes = 0;  ///< bit per axis that moves
  bool program = false;    ///< the user's stored program runs, waits or is held
  bool held = false;       ///< the program is held now
  std::int8_t slot = -1;   ///< of the program
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
  FixedText<640> sentence;  ///< why the link is late, lost or closed, and what the console does about it
  /// The work under way when the link was lost; empty once it is good again.
  UnderWay when_lost;
  JogEnds jog_ends = JogEnds::never;  ///< who ends a held jog when this program dies

  [[nodiscard]] bool connected() const { return state == LinkState::good || state == LinkState::late; }
};

inline constexpr int max_outputs = 32, max_analog = 8, max_params = 256, max_slots = 8;
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
  Instant inputs_asked_at{};  ///< when `inputs` were asked for: they may be newer than the outputs
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
  /// Bit per slot (bit 0 for all where programs run in threads): the slot does not hold the text sent last,
  /// because the transfer was broken off or the slot reads back differently. Cleared when it is loaded or
  /// read again.
  std::uint8_t slots_torn = 0;
  std::array<ParamState, max_params> params{};           ///< by index in Catalog::params
  bool unsaved_setup = false, unsaved_programs = false;  ///< changed in RAM and not stored
  bool working = false;           ///< the controller works on queued commands, even if no axis moves
  std::uint32_t restarts = 0;     ///< of the controller, as seen while connected
  std::int32_t store_count = -1;  ///< writes to the non-volatile memory so far; only an emulator knows
  /// How many commands may have changed the stored programs, and the last of them (0: a raw query).
  std::uint32_t program_changes = 0;
  IntentId program_changed_by = 0;
  Duration poll_period{};                   ///< as the poll law wants it now
  std::array<IntentOutcome, 8> outcomes{};  ///< newest first; settled ones are dropped to make room
  FixedText<320> notice;  ///< the worst present condition that the fields above do not show; empty: none

  [[nodiscard]] const IntentOutcome* outcome_of(IntentId id) const {
    for (const IntentOutcome& f : outcomes)
      if (f.id == id && id != 0) return &f;
    return nullptr;
  }
  /// The intent was performed so long ago that its outcome has been dropped.
  [[nodiscard]] bool forgotten(IntentId id) const {
    if (id == 0 || outcome_of(id)) return false;
    return std::any_of(outcomes.begin(), outcomes.end(), [id](const IntentOutcome& f) { return f.id > id; });
  }
  [[nodiscard]] bool axis_moves(int axis) const { return axes[axis].moves(); }
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
  /// While the link is lost: the work under way at the loss, as its end has not been seen.
  [[nodiscard]] UnderWay under_way() const { return link.connected() ? shows_under_way() : link.when_lost; }
};

/// Older than three poll periods, and than 0.6 s: shown dimmed and marked.
inline bool is_stale(Instant seen_at, Instant now, Duration poll_period) {
  const Duration limit = std::max<Duration>(3 * poll_period, Millis(600));
  return now - seen_at > limit;
}

/// One sample of one axis, recorded for intent::Sample. Samples travel in a ring, like notices.
struct AxisSample {
  Instant at{};
  std::uint8_t axis = 0;
  bool moving = false;
  Steps command{}, encoder{};  ///< commanded and measured position
  Pps velocity{};              ///< commanded, unsigned
  /// Drive output, -100 to 100 % of its range. Calculated by the console from error, speed and gains, as no
  /// controller reports it. Known while all gains are known.
  float output_percent = 0;
  bool output_known = false;
};

/// How a motion or a program ended, reported once. A program or a list is reported as a whole, with its
/// motions, unless one of them ended badly.
struct Ending {
  enum class What : std::uint8_t { motion, jog, homing, program, list, pieces };
  What what = What::motion;
  int axis = -1;          ///< of a motion, jog or homing
  int slot = -1;          ///< of a program, or its thread where the catalog has threads; -1: not known
  Instant began{}, at{};  ///< when each was first seen
  EndedBy by = EndedBy::nothing;
  StoppedBy stopped_by = StoppedBy::unknown;  ///< if it was stopped
  Doubt lost_with = Doubt::none;              ///< if it was lost: the state of the controller afterwards
  bool beside_program = false;                ///< of a motion: a program of the controller ran when it ended
  bool of_run = false;                        ///< of a motion: a program, list or drawing ran while it moved
  bool perhaps_limit = false;  ///< of a motion cut short: nothing shows that it was not by a switch
  /// Of a motion that the console stopped: from the request to the first byte, and to rest.
  bool timed = false;
  Duration to_wire{}, to_rest{};
  /// To the first answer after the stop in which the axis slowed down; none: the controller does not report
  /// it.
  std::optional<Duration> to_slowing;
  Steps ran_on{};  ///< distance in that time, from its last seen position and speed
  AxisError error =
      AxisError::none;   ///< of the axis, or of `failed_axis` of a program that stopped with an error
  int failed_axis = -1;  ///< -1: no axis is in error
  int line = -1;         ///< of the stored code, from 0, where a program stopped with an error
  bool limit_minus = false, limit_plus = false;  ///< active at the end
  bool at_travel_end = false;                    ///< of a jog: it reached the user's limit
  bool place_known = false;
  Steps place{};                     ///< where it came to rest
  Steps off{};                       ///< servo axis: distance from its command
  std::int32_t done = 0, total = 0;  ///< of a list or pieces
  bool operator==(const Ending&) const = default;
};

/// A message that must not be lost: notices travel in a ring beside the snapshots.
struct Notice {
  enum class Kind : std::uint8_t { info, warning, error, program, question };
  Kind kind = Kind::info;
  Instant at{};
  IntentId intent = 0;
  int slot = -1;                        ///< program: which slot `text` is the listing of ...
  bool whole = true;                    ///< ... and false: `text` leaves out code that could not be read
  std::string text;                     ///< a sentence, or the listing
  std::vector<int> slots;               ///< question: one of these must be emptied before a move is possible
  std::optional<PastTravel> past = {};  ///< warning: a passed limit, to show `text` in other units

  Notice() = default;
  Notice(Kind k, Instant when, std::string t) : kind(k), at(when), text(std::move(t)) {}
};

}  // namespace hw
