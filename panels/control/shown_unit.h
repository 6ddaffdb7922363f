#pragma once
// Shows and reads a number of the catalog (steps, steps/s, or another quantity) in the unit that the user has
// chosen for its axis.
#include <cstdint>
#include <string>
#include <string_view>

#include "core/device/catalog.h"
#include "gui/shell/frame.h"

namespace hw::panels {

struct ShownUnit {
  std::string name;  ///< "mm/s"; empty: a bare number
  double per = 1;    ///< shown units of one unit of the catalog
  int decimals = 0;
  int own_decimals = 0;  ///< the catalog's integers count units of 10^-own_decimals
  bool operator==(const ShownUnit&) const = default;

  [[nodiscard]] double shown(std::int64_t value) const;
  [[nodiscard]] std::int64_t value(double shown) const;
};

ShownUnit shown_unit(const gui::Frame& frame, const ParamInfo& param);
ShownUnit shown_unit(const gui::Frame& frame, const ReadoutInfo& readout);
/// "2.5000", without its unit. A value that is not a number of steps is written as the controller writes it:
/// "4EX07".
std::string text_in(const ShownUnit& unit, const ParamInfo& param, std::int64_t value);
/// "0 or 0.0025 to 15", without its unit.
std::string range_in(const ShownUnit& unit, const ParamInfo& param);
/// The unit of a field for `axis`; -1: no axis, so the catalog's own unit.
ShownUnit shown_unit(const gui::Frame& frame, const ActionField& field, int axis);

/// Collects the units of a column's rows, each once: "mm/s", or "mm/s, °/s".
class UnitsOfRows {
 public:
  void add(std::string_view name);
  [[nodiscard]] std::string_view view() const { return {bytes_, size_}; }

 private:
  [[nodiscard]] bool has(std::string_view name) const;
  char bytes_[48];
  std::size_t size_ = 0;
};

}  // namespace hw::panels
