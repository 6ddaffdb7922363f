#pragma once
// A sequence cut into pieces that its controller can hold, where its tool is up or can be lifted. Each piece
// is complete, begins and ends with the tool off, and waits for the one before.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/tool_off.h"
#include "core/sequence/sequence.h"
#include "core/time/clock.h"

namespace hw {

class Language;
struct Snapshot;

struct PieceAct {
  std::optional<IntentBody> what;  ///< none: only other controllers act, see PieceSync
  Duration then{};                 ///< pause after it
};

struct Piece {
  std::vector<PieceAct> does;       ///< in this order, each when the controller is at rest
  std::vector<AxisTarget> ends_at;  ///< as far as known
  /// If a program draws the piece: the least and the greatest known place of each axis, arcs included.
  std::vector<AxisTarget> reaches;
  int first_step = 0;  ///< index of its first step in the sequence's list
  int end_step = 0;    ///< one past its last step, if a program draws it
  /// The step of each command that the controller stores, if it runs one program; -1: of no step.
  std::vector<int> step_of_command;
  int draws = -1;                ///< index in `does` of the list of moves that draws; -1: a program draws
  std::vector<int> step_of_row;  ///< the step of each row of that list
  std::vector<int> step_of_act;  ///< the step of each of `does`, if several controllers run together
};

/// An axis whose closed loop must be off while the pieces run.
struct OpenLoop {
  AxisId axis;
  std::string parameter;  ///< the parameter whose value 0 opens the loop
};

struct Pieces {
  std::vector<Piece> all;
  std::vector<OpenLoop> open_loops;  ///< empty: no loop matters
  int lifts = 0;                     ///< how often the tool is lifted within one chain
  ToolOff tool;                      ///< the tool that the acts switch; a program's text names its own
  std::string remark;                ///< to be shown before the run; may be empty
  bool one_move = false;             ///< the two halves of one move
  std::uint64_t drawing = 0;  ///< a number of its own: the rest can be drawn after a stop; 0: it cannot
  /// The program of a piece at a share of its speeds, as near as the controller can. Null: no step names a
  /// speed, or the moves go through the controller's buffer.
  std::function<Result<std::string>(const Piece& piece, int percent)> text_at;
};

/// Puts as many steps into a piece as fit into the program memory. `from_step`: see Language::in_pieces().
Result<Pieces> cut_by_text(const Language& language, const sequence::Sequence& sequence,
                           const Catalog& catalog, int from_step);
/// A bit per axis whose loop is closed but must be open.
[[nodiscard]] std::uint32_t loops_in_the_way(const Pieces& pieces, const Snapshot& now);
/// The reason as a sentence; empty: no loop is in the way.
[[nodiscard]] std::string why_not_begun(const Pieces& pieces, const Catalog& catalog, const Snapshot& now);
/// The fault says why the sequence cannot begin at that step.
Result<> has_step(const sequence::Sequence& sequence, int step);

}  // namespace hw
