#pragma once
// A path at constant speed and a staircase of speeds as somebody draws them, before they are a controller's
// text. A Language of a controller with Capabilities::contours is a ContourWriter too.
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/device/catalog.h"

namespace hw {

struct ContourPiece {
  enum class Kind : std::uint8_t { line, arc, output };
  Kind kind = Kind::line;
  Steps x{}, y{};      ///< line: its end; arc: its centre
  double degrees = 0;  ///< arc: how far it goes round, counterclockwise
  int output = 0;      ///< place in Catalog::outputs
  bool on = true;
};

/// In two axes: the first to the right, the second up.
struct ContourPlan {
  AxisId first{0}, second{1};
  Pps speed{1000};
  Steps x{}, y{};    ///< where it begins
  Steps lead_in{};   ///< parked so far before its begin, in its first direction, to be at speed there
  bool ramp = true;  ///< at the end: with a ramp, on along the last direction; false: at once
  std::vector<ContourPiece> pieces;
};

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

struct ContourPoint {
  double x = 0, y = 0;
};
/// What a plan draws.
struct ContourShape {
  ContourPoint park;  ///< where the lead-in begins
  struct Leg {
    std::size_t first = 0, size = 0;  ///< its points, the first of them the end of the leg before
    std::size_t piece = 0;
    int outputs_on = 0;  ///< how many are on while it is drawn
  };
  std::vector<ContourPoint> points;
  std::vector<Leg> legs;
  double length = 0;  ///< in steps, without lead-in
};
/// The fault names the piece, from 1, and what is wrong with it: an arc around the point where it begins, an
/// output that does not exist, a position out of range, nothing that moves.
Result<ContourShape> draw_contour(const ContourPlan& plan, const Catalog& catalog);
/// Whether all steps lie on the way from `from` to `stop_at`, with speeds that the catalog allows.
Result<> check_staircase(const StaircasePlan& plan, const Catalog& catalog);

class ContourWriter {
 public:
  virtual ~ContourWriter() = default;
  /// The whole text: speed, definition, the way to its begin, and the start.
  [[nodiscard]] virtual Result<std::string> write_contour(const ContourPlan& plan,
                                                          const Catalog& catalog) const = 0;
  [[nodiscard]] virtual Result<std::string> write_staircase(const StaircasePlan& plan,
                                                            const Catalog& catalog) const = 0;
  /// Places in Catalog::outputs that can be switched on the way.
  [[nodiscard]] virtual std::vector<int> contour_outputs(const Catalog& catalog) const = 0;
};

}  // namespace hw
