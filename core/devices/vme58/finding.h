#pragma once
// Finding the board, and saying why not. Moves nothing.
#include "core/devices/vme58/conversation.h"
#include "core/devices/vme58/lines.h"
#include "core/devices/vme58/parameter_values.h"

namespace hw::vme58 {

class Finding {
 public:
  Finding(Wire& wire, Readings& readings, const Selection& selection, Conversation& conversation,
          ParameterValues& values, Lines& lines, const Catalog& catalog, const Variant& variant,
          Snapshot& draft)
      : wire_(wire),
        readings_(readings),
        selection_(selection),
        conversation_(conversation),
        values_(values),
        lines_(lines),
        catalog_(catalog),
        variant_(variant),
        draft_(draft) {}

  /// Only reads, and none that a board would answer by doing something but clear its flags.
  Task<Result<>> find();
  /// Which board it is. Its echo is off then.
  Task<Result<>> identify();

  /// Stands in a cell that only a reset clears. False: nobody has left one since then, which tells of the
  /// gains too.
  Task<Result<bool>> is_marked();
  /// A later session reads in it whether the whole numbers that the data area shows of the gains are all of
  /// them.
  Task<Result<>> leave_mark();
  /// User units that another program has left on would scale all that this one sends.
  Task<Result<>> forget_others_units();

 private:
  Task<Result<>> ask_variant();
  Task<Result<>> ask_axes(std::string_view told_variant);

  Wire& wire_;
  Readings& readings_;
  const Selection& selection_;
  Conversation& conversation_;
  ParameterValues& values_;
  Lines& lines_;
  const Catalog& catalog_;
  const Variant& variant_;
  Snapshot& draft_;
};

}  // namespace hw::vme58
