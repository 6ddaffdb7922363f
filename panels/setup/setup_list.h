#pragma once
// The order in which the set-up is listed, and the one width of its fields. Settings of one heading stand
// together, those of an axis beside each other in the catalog's order.
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "gui/surface/ui.h"

namespace hw::panels {

class SetupList {
 public:
  struct Section {
    std::string title;
    std::vector<std::size_t> params;  ///< indexes into Catalog::params
  };
  /// Made at the first call.
  const std::vector<Section>& sections(const Catalog& catalog);
  /// Logical, of `room` for a whole row: as wide as the longest choice, if half of the row has place for it.
  float field_width(const gui::Ui& ui, const Catalog& catalog, float room);

 private:
  std::vector<Section> sections_;
  float width_ = 0, scale_ = 0, room_ = 0;
};

}  // namespace hw::panels
