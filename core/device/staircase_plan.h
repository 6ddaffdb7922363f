#pragma once
// A staircase of speeds as somebody draws it, before it is a controller's text. A Language of a controller
// with Capabilities::contours is a StaircaseWriter too.
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/device/catalog.h"

namespace hw {

struct StaircaseStep {
  Steps until{};  ///< at `speed` up to this position
  Pps speed{};
};
struct StaircasePlan {
  AxisId axis{};
  Steps from{};  ///< where it stands
  std::vector<StaircaseStep> steps;
  Steps stop_at{};
};
/// Whether all steps lie on the way from `from` to `stop_at`, with speeds that the catalog allows.
Result<> check_staircase(const StaircasePlan& plan, const Catalog& catalog);

class StaircaseWriter {
 public:
  virtual ~StaircaseWriter() = default;
  [[nodiscard]] virtual Result<std::string> write_staircase(const StaircasePlan& plan,
                                                            const Catalog& catalog) const = 0;
};

}  // namespace hw
