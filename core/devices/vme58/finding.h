#pragma once
// Finds the board, or reports why it was not found. Moves nothing.
#include "core/devices/vme58/conversation.h"
#include "core/devices/vme58/lines.h"
#include "core/devices/vme58/parameter_values.h"

namespace hw::vme58 {

class Finding {
 public:
  Finding(Wire& wire, Readings& readings, const Selection& selection, Conversation& conversation,
          ParameterValues& values, Lines& lines, const Catalog& catalog, const Variant& variant,
          Snapshot& snapshot)
      : wire_(wire),
        readings_(readings),
        selection_(selection),
        conversation_(conversation),
        values_(values),
        lines_(lines),
        catalog_(catalog),
        variant_(variant),
        snapshot_(snapshot) {}

  /// Only reads, and only cells whose reading has no effect on a board other than clearing flags.
  Task<Result<>> find();
  /// Identifies the board and switches its echo off.
  Task<Result<>> identify();

  /// Whether a program has left its mark since the last reset, in a cell that only a reset clears. The mark,
  /// or its absence, also shows whether all gains are whole numbers.
  Task<Result<bool>> is_marked();
  /// Leaves the mark, which shows a later session whether the gains are whole numbers, as in the data area.
  Task<Result<>> leave_mark();
  /// Switches user units off: those left on by another program would scale all numbers sent by this one.
  Task<Result<>> forget_others_units();

 private:
  Task<Result<>> ask_variant();
  Task<Result<>> ask_axes(std::string_view reported_variant);

  Wire& wire_;
  Readings& readings_;
  const Selection& selection_;
  Conversation& conversation_;
  ParameterValues& values_;
  Lines& lines_;
  const Catalog& catalog_;
  const Variant& variant_;
  Snapshot& snapshot_;
};

}  // namespace hw::vme58
