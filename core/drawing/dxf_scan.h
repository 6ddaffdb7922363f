#pragma once
// Finds the entities of a DXF file and their lines without interpreting them. It reports what the parser
// ignores, and keeps from the parser what would crash it.
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
  bool miscounted = false;  ///< its number of parts differs from its count
  int no_number = 0;        ///< line of an invalid number, points included; 0: none
};

struct ScannedDxf {
  std::vector<ScannedEntity> entities;  ///< of the sections BLOCKS and ENTITIES, in their order
  std::size_t longest_line = 0;         ///< bytes
  bool padded_names = false;            ///< some have blanks around, which the parser would not remove
  std::string_view text;                ///< up to its EOF: the rest is unchecked and must not be used
};
/// The fault concerns the whole file: binary, not DXF, truncated, too large, wrong counts.
Result<ScannedDxf> scan_dxf(std::string_view text, const std::string& name);

inline constexpr std::size_t largest_dxf = 256'000'000;  // bytes
/// A fault for a file that is too large to be read.
Result<> may_be_read(std::uintmax_t bytes, const std::string& name);

}  // namespace hw::drawing
