#pragma once
// What stands in a DXF file, found without understanding it: which entities, and where. It tells what the
// parser passes over, and keeps from it what it would not survive.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace hw::drawing {

struct ScannedEntity {
  std::string_view name;  ///< "LINE"; a part of the file's text
  int line = 0;           ///< from 1
  bool on_sheet = false;  ///< in paper space
  bool hidden = false;
  bool miscounted = false;  ///< it has another number of parts than it says
  int no_number = 0;        ///< line of a value that should be a number, its points' among them; 0: none
};

struct ScannedDxf {
  std::vector<ScannedEntity> entities;  ///< of the sections BLOCKS and ENTITIES, in their order
  std::size_t longest_line = 0;         ///< bytes
  bool padded_names = false;            ///< blanks stand around some, which the parser would take for a part
  std::string_view text;  ///< as far as its EOF: nobody has looked at what follows, and nobody is to
};
/// The fault says what is wrong with the file as a
/// whole: binary, no DXF at all, cut off, too large, counts that do not fit.
Result<ScannedDxf> scan_dxf(std::string_view text, const std::string& name);

inline constexpr std::size_t largest_dxf = 256'000'000;  // bytes
/// Why a file of that size is not read; nothing: it is.
Result<> may_be_read(std::uintmax_t bytes, const std::string& name);

}  // namespace hw::drawing
