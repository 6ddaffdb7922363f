#pragma once
// The default catalogs of all controllers, as the connection page offers them. Making a catalog is slow, so
// each is made once, when the page is first shown.
#include <span>
#include <vector>

#include "core/device/registry.h"

namespace hw::panels {

class UsualCatalogs {
 public:
  explicit UsualCatalogs(std::span<const DeviceType> types = device_types()) : types_(types) {}
  [[nodiscard]] const std::vector<Catalog>& all() const {
    if (made_) return catalogs_;
    made_ = true;
    for (const DeviceType& type : types_)
      if (auto catalog = type.make_catalog({})) catalogs_.push_back(std::move(*catalog));
    return catalogs_;
  }

 private:
  std::span<const DeviceType> types_;
  mutable bool made_ = false;
  mutable std::vector<Catalog> catalogs_;
};

}  // namespace hw::panels
