#pragma once
// The structure of a DXF file: blocks of shapes and inserts of blocks, before these are placed.
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing/dxf_scan.h"
#include "core/drawing/shape.h"

namespace hw::drawing {

struct DxfInsert {
  std::string block;
  Affine place;  ///< of the first copy
  int columns = 1, rows = 1;
  Point column, row;  ///< from one copy to the next
};
struct DxfEntity {
  std::vector<Shape> shapes;  ///< connected
  std::vector<DxfInsert> inserts;
  std::string layer;
  std::string_view name;  ///< "LINE"
  int number = 0, line = 0;
};
struct DxfBlock {
  Point base;
  std::vector<DxfEntity> entities;
};
/// Orders names, ignoring case.
struct LessName {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const;
};
struct DxfFile {
  std::vector<Layer> layers;
  std::set<std::string, LessName>
      frozen;  ///< frozen layers: an insert on one is hidden with all its contents
  std::map<std::string, DxfBlock, LessName> blocks;
  DxfBlock model;
  std::vector<LeftOut> left_out, understood;
  int unit = 0;  ///< $INSUNITS
  std::string version;
};

/// `scanned`: of the same text.
Result<DxfFile> read_blocks(std::string_view text, const std::vector<ScannedEntity>& scanned,
                            const std::string& name);

}  // namespace hw::drawing
