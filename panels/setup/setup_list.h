#pragma once
// Gives the order of the set-up list, and the common width of its fields. Settings of a heading are together,
// those of an axis are adjacent in catalog order.
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
  /// The sections, made at the first call.
  const std::vector<Section>& sections(const Catalog& catalog);
  /// The logical width of a field in a row as wide as `room`: that of the longest choice, if half of the row
  /// can hold it.
  float field_width(const gui::Ui& ui, const Catalog& catalog, float room);

 private:
  std::vector<Section> sections_;
  float width_ = 0, scale_ = 0, room_ = 0;
};

}  // namespace hw::panels
