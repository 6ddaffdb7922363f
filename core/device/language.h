#pragma once
// What a console wants to know of a program text while it is typed, and before metal moves.
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/bench.h"
#include "core/device/catalog.h"
#include "core/device/pieces.h"
#include "core/device/sequence_text.h"
#include "core/sequence/sequence.h"
#include "core/time/clock.h"

namespace hw {

enum class TokenKind : std::uint8_t { moves, flow, plain, comment, bad };
struct Token {
  int begin = 0, end = 0;  ///< bytes within the line
  TokenKind kind = TokenKind::plain;
};
struct Problem {
  bool error = true;                     ///< false: a warning
  int line = 0, column = 0, length = 0;  ///< from 0, in bytes
  std::string sentence;
  std::string fix_label, fix_text;  ///< not empty: replacing column..+length by fix_text mends it
};
struct LineReport {
  std::vector<Token> tokens;
  int cost = 0;            ///< bytes or low-level lines
  int first_command = -1;  ///< index of its first stored command within the slot's listing
  int command_count = 0;
  int slot = -1;  ///< for texts with program headings
};
struct ProgramReport {
  std::vector<LineReport> lines;
  std::vector<Problem> problems;
  std::map<int, int> cost;                          ///< per slot, in the catalog's capacity unit
  std::map<int, std::vector<std::string>> listing;  ///< per slot: the commands in canonical form
  std::vector<int> programs;                        ///< the numbers of those that the text of slot 0 holds
  [[nodiscard]] bool has_errors() const {
    for (const Problem& p : problems)
      if (p.error) return true;
    return false;
  }
};

struct RehearsedAxis {
  std::string name;
  std::int64_t position = 0, minimum = 0, maximum = 0;  ///< as the controller counts it
  std::int64_t travel = 0;                              ///< the way made, in both directions
  bool in_counts = false;                               ///< closed loop: all of this is in Catalog::loop_word
  std::int64_t begin = 0;                               ///< where it stood at the start
};
struct RehearsedEvent {
  double t = 0;
  std::string what;
  int slot = -1, command = -1;
};
/// From this time on this command was at work.
struct RehearsedTurn {
  double t = 0;
  int command = -1;
};
/// A value that the rehearsal had to take from somewhere because nobody has told it.
struct RehearsedAssumption {
  std::string name;   ///< the maker's, or in words: "HSPD", "V5", "speed of motor 1"
  std::string value;  ///< what it was taken to be
};
/// Something stopped before the text said so: at a limit switch, by a refusal, an error, or the end of time.
struct RehearsedStop {
  double t = 0;
  int line = -1;       ///< of the text, from 0, that was at work; -1: none, or not known
  std::string axis;    ///< of a limit switch: the one that ran into it ...
  int direction = 0;   ///< ... to -1 or +1; 0: something else
  std::string reason;  ///< a sentence, without line and time
};
/// Where all axes are at a time, as the controller counts.
struct RehearsedPlace {
  double t = 0;
  std::array<std::int64_t, max_axes> position{};  ///< by place in the catalog
  std::uint32_t outputs = 0;                      ///< as BenchView::outputs
};
struct Rehearsal {
  double duration_s = 0;
  bool finished = false;
  std::string error;  ///< not empty: what stopped it, as a sentence
  std::vector<RehearsedAxis> axes;
  std::map<std::string, int> outputs;           ///< by number; 1: on
  std::map<std::string, int> outputs_at_first;  ///< as power-up leaves them; those that are missing: off
  std::string sent_to_host;
  std::map<std::string, int> program_size;  ///< "0" -> 14
  std::vector<RehearsedEvent> events;       ///< in order of time; at most `most_events`, and one that says so
  /// Of the program that was started, in order of time: what waits for a motion is of the command that began
  /// it. At most `most_events`; what came then is missing.
  std::vector<RehearsedTurn> turns;
  int moves = 0;
  bool limit_touched = false;
  bool endless = false;              ///< it goes round in a loop that nothing leaves; `error` names its line
  std::vector<RehearsedStop> stops;  ///< in order of time; at most 200
  std::vector<RehearsedAssumption> assumptions;
  std::vector<RehearsedPlace> track;  ///< in order of time, where it was asked for

  static constexpr std::size_t most_events = 200'000;
  void add(RehearsedEvent event) {
    if (events.size() == most_events) event = {event.t, "more events, not listed", -1, -1};
    if (events.size() <= most_events) events.push_back(std::move(event));
  }
  /// `command` -1: the one before goes on.
  void at_work(double t, int command) {
    const bool goes_on = command < 0 || (!turns.empty() && turns.back().command == command);
    if (!goes_on && turns.size() < most_events) turns.push_back({t, command});
  }
};
struct ControllerState;
struct RehearseOptions {
  double for_seconds = 3600;
  double track_every_s = 0;                   ///< how often Rehearsal::track looks while axes move; 0: not
  int slot = 0;                               ///< the program that is started
  std::string bench_toml;                     ///< a bench file's text, or empty
  int axes = 0;                               ///< 0: as few as the text needs
  std::map<std::string, std::string> device;  ///< Catalog::made_from of the controller that it is meant for
  /// Where the counters stand at the start, by axis; those that are missing: 0, as after power-up. Where one
  /// cannot begin there, RehearsedAxis::begin tells.
  std::vector<std::int64_t> start_at;
  /// Done on the emulated controller's bench before the start and before what `bench_toml` says. Its loads
  /// stand at 0 then.
  std::vector<BenchCommand> bench;
  /// What is known of the controller at the start; what it does not tell is taken as after power-up, and
  /// named (Rehearsal::assumptions). Null: all is, and only `start_at` differs. See
  /// core/device/controller_state.h.
  std::shared_ptr<const ControllerState> from;
};

class Language {
 public:
  virtual ~Language() = default;
  /// `slot`: where text before the first program heading belongs.
  [[nodiscard]] virtual ProgramReport analyse(std::string_view text, int slot) const = 0;
  /// Dry run from the state that the options tell, in virtual time. Pure and long: for a worker thread.
  [[nodiscard]] virtual Result<Rehearsal> rehearse(std::string_view text,
                                                   const RehearseOptions& options) const = 0;
  /// The fault names the step that the controller cannot do, and why.
  [[nodiscard]] virtual Result<SequenceText> write(const sequence::Sequence& sequence,
                                                   const Catalog& catalog) const = 0;
  /// The same for any length, in pieces; from the place on where the tool was up last before `from_step`, a
  /// place in the sequence's own list. Long: for a worker thread.
  [[nodiscard]] virtual Result<Pieces> in_pieces(const sequence::Sequence& sequence, const Catalog& catalog,
                                                 int from_step = 0) const;
  /// Steps in the unit and axes of `frame` that write() makes the same program of: what they cannot hold
  /// stays text of the controller's own. The fault names the line where that does not help. Long: for a
  /// worker.
  [[nodiscard]] virtual Result<SequenceRead> read(std::string_view text, const sequence::Sequence& frame,
                                                  const Catalog& catalog) const = 0;
};

}  // namespace hw
