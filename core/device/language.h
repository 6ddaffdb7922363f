#pragma once
// Answers the console's questions about a program text: while it is typed, and before anything moves.
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
  std::string fix_label, fix_text;  ///< not empty: replacing column..+length by fix_text corrects it
};
struct LineReport {
  std::vector<Token> tokens;
  int cost = 0;            ///< bytes or low-level lines
  int first_command = -1;  ///< index of its first stored command within the slot's listing
  int command_count = 0;
  int slot = -1;  ///< in texts with program headings
};
struct ProgramReport {
  std::vector<LineReport> lines;
  std::vector<Problem> problems;
  std::map<int, int> cost;                          ///< per slot, in the catalog's capacity unit
  std::map<int, std::vector<std::string>> listing;  ///< per slot: the commands in canonical form
  std::vector<int> programs;                        ///< the numbers of the programs in the text of slot 0
  [[nodiscard]] bool has_errors() const {
    for (const Problem& p : problems)
      if (p.error) return true;
    return false;
  }
};

struct RehearsedAxis {
  std::string name;
  std::int64_t position = 0, minimum = 0, maximum = 0;  ///< as the controller counts it
  std::int64_t travel = 0;                              ///< distance travelled, in both directions
  bool in_counts = false;                               ///< closed loop: all values are in Catalog::loop_word
  std::int64_t begin = 0;                               ///< position at the start
};
struct RehearsedEvent {
  double t = 0;
  std::string what;
  int slot = -1, command = -1;
  /// The change of an output or input at this event; `waits`: the program waits for an input, until it
  /// `comes`.
  enum class Line : std::uint8_t { none, switched, looked_at, waits, comes };
  Line line = Line::none;
  std::string name = {};  ///< of that output or input: "output 1", "DI3"
  int level = 0;          ///< switched or looked at: the level from here on
};
/// From this time on this command was running.
struct RehearsedTurn {
  double t = 0;
  int command = -1;
};
/// A value that the rehearsal had to assume.
struct RehearsedAssumption {
  std::string name;   ///< the maker's name, or words: "HSPD", "V5", "speed of motor 1"
  std::string value;  ///< the value assumed
};
/// Something stopped too early: at a limit switch, by a refusal or an error, or when the time was over.
struct RehearsedStop {
  double t = 0;
  int line = -1;       ///< the running line of the text, from 0; -1: none, or not known
  std::string axis;    ///< the axis that ran into a limit switch ...
  int direction = 0;   ///< ... in direction -1 or +1; 0: stopped by something else
  std::string reason;  ///< a sentence, without line and time
};
/// The positions of all axes at one time, as the controller counts.
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
  std::map<std::string, int> outputs_at_first;  ///< as power-up leaves them; missing ones are off
  std::string sent_to_host;
  std::map<std::string, int> program_size;  ///< "0" -> 14
  std::vector<RehearsedEvent> events;  ///< in order of time; at most `most_events`, then one that says so
  /// The commands of the started program, in order of time: a wait for a motion belongs to the command that
  /// began the motion. At most `most_events`; later ones are missing.
  std::vector<RehearsedTurn> turns;
  int moves = 0;
  bool limit_touched = false;
  bool endless = false;              ///< the program runs in a loop that nothing ends; `error` names its line
  std::vector<RehearsedStop> stops;  ///< in order of time; at most 200
  std::vector<RehearsedAssumption> assumptions;
  std::vector<RehearsedPlace> track;  ///< in order of time, if RehearseOptions::track_every_s asks for it

  static constexpr std::size_t most_events = 200'000;
  void add(RehearsedEvent event) {
    if (events.size() == most_events) event = {event.t, "more events, not listed", -1, -1};
    if (events.size() <= most_events) events.push_back(std::move(event));
  }
  /// `command` -1: the one before continues.
  void at_work(double t, int command) {
    const bool goes_on = command < 0 || (!turns.empty() && turns.back().command == command);
    if (!goes_on && turns.size() < most_events) turns.push_back({t, command});
  }
};
struct ControllerState;
struct RehearseOptions {
  double for_seconds = 3600;
  double track_every_s = 0;                   ///< sampling of Rehearsal::track while axes move; 0: no track
  int slot = 0;                               ///< the program to start
  std::string bench_toml;                     ///< a bench file's text, or empty
  int axes = 0;                               ///< 0: as few as the text needs
  std::map<std::string, std::string> device;  ///< Catalog::made_from of the controller that the text is for
  /// Counts at the start, by axis; missing ones are 0, as after power-up. RehearsedAxis::begin tells where an
  /// axis really began.
  std::vector<std::int64_t> start_at;
  /// Carried out on the emulated bench before the start and before `bench_toml`, while its loads stand at 0.
  std::vector<BenchCommand> bench;
  /// The known state of the controller at the start; the rest is as after power-up, and is named in
  /// Rehearsal::assumptions. Null: all is as after power-up but for `start_at`. See
  /// core/device/controller_state.h.
  std::shared_ptr<const ControllerState> from;
};

class Language {
 public:
  virtual ~Language() = default;
  /// `slot`: the program to which text before the first heading belongs.
  [[nodiscard]] virtual ProgramReport analyse(std::string_view text, int slot) const = 0;
  /// Dry run in virtual time, from the state in `options`. Pure, and may take long: for a worker thread.
  [[nodiscard]] virtual Result<Rehearsal> rehearse(std::string_view text,
                                                   const RehearseOptions& options) const = 0;
  /// The fault names a step that the controller cannot carry out, and why.
  [[nodiscard]] virtual Result<SequenceText> write(const sequence::Sequence& sequence,
                                                   const Catalog& catalog) const = 0;
  /// The same for any length, in pieces, from the last place before `from_step` (in the sequence's list)
  /// where the tool was up. May take long: for a worker thread.
  [[nodiscard]] virtual Result<Pieces> in_pieces(const sequence::Sequence& sequence, const Catalog& catalog,
                                                 int from_step = 0) const;
  /// The text as steps, in the unit and axes of `frame`, from which write() makes the same program. Text that
  /// no step can hold stays text. The fault names the line where that is not possible. May take long: for a
  /// worker.
  [[nodiscard]] virtual Result<SequenceRead> read(std::string_view text, const sequence::Sequence& frame,
                                                  const Catalog& catalog) const = 0;
  /// Compiled lines (ProgramReport::listing) as a text that can be loaded like the program's own. Empty:
  /// programs are stored as they are written.
  [[nodiscard]] virtual std::string write_listing(const std::vector<std::string>& /*lines*/) const {
    return {};
  }
};

}  // namespace hw
