#pragma once
// A list of buffered moves as rows of numbers, and as a file: one move a line, numbers separated by commas,
// column names in a head line. GUI thread.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"

namespace hw::gui {

using MoveRow =
    std::vector<std::int64_t>;  ///< a value for each of MoveListFacts::columns, in units of its last decimal

std::string write_moves(const std::vector<MoveRow>& rows, const MoveListFacts& facts);
/// Faults name the line and its error.
Result<std::vector<MoveRow>> read_moves(std::string_view text, const MoveListFacts& facts);

}  // namespace hw::gui
