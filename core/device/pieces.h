#pragma once
// A sequence cut where its tool is up, or can be lifted, into pieces that its controller can hold: each is
// whole by itself, begins and ends with the tool off, and waits for the one before.
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
  std::optional<IntentBody> what;  ///< none: only others have something to do, see PieceSync
  Duration then{};                 ///< passes behind it
};

struct Piece {
  std::vector<PieceAct> does;       ///< one after the other, each once the controller is at rest
  std::vector<AxisTarget> ends_at;  ///< where that is known
  /// Where a program draws it: the least and the greatest known place of each axis, bulges of arcs among
  /// them.
  std::vector<AxisTarget> reaches;
  int first_step = 0;  ///< place of its first step in the sequence's own list
  int end_step = 0;    ///< behind its last one, where a program draws it
  /// The same of each command that the controller stores, where it runs one program; -1: of none of them.
  std::vector<int> step_of_command;
  int draws = -1;                ///< which of `does` is the list of moves that draws; -1: a program does
  std::vector<int> step_of_row;  ///< of that list
  std::vector<int> step_of_act;  ///< of each of `does`, where several controllers do theirs together
};

/// An axis whose closed loop has to be off while they are done.
struct OpenLoop {
  AxisId axis;
  std::string parameter;  ///< 0 switches it off
};

struct Pieces {
  std::vector<Piece> all;
  std::vector<OpenLoop> open_loops;  ///< none: they do not mind
  int lifts = 0;                     ///< so often the tool is lifted within what it draws in one go
  ToolOff tool;                      ///< of what they switch act by act; a program's text says it by itself
  std::string remark;                ///< what is to be known before; may be empty
  bool one_move = false;             ///< a move in two: nothing else moves meanwhile
  /// The program of a piece at that share of the speeds that stand in it, as near as the controller goes.
  /// Null: none says any speed, or moves go through the controller's buffer.
  std::function<Result<std::string>(const Piece& piece, int percent)> text_at;
};

/// By the language's own texts: as many steps in a piece as fit into its program memory. `from_step`: see
/// Language::in_pieces().
Result<Pieces> cut_by_text(const Language& language, const sequence::Sequence& sequence,
                           const Catalog& catalog, int from_step);
/// Bit per axis whose loop is closed although they need it open.
[[nodiscard]] std::uint32_t loops_in_the_way(const Pieces& pieces, const Snapshot& now);
/// A sentence that says so; empty: there are none.
[[nodiscard]] std::string why_not_begun(const Pieces& pieces, const Catalog& catalog, const Snapshot& now);
/// Why it cannot begin there.
Result<> has_step(const sequence::Sequence& sequence, int step);

}  // namespace hw
