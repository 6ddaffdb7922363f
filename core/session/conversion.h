#pragma once
// Converts a drawing to a sequence that a controller can carry out: chooses layers, joins ends, places the
// drawing on the table, orders the chains, and adapts them to the machine. Pure and long: for a worker
// thread.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/drawing/chains.h"
#include "core/drawing/placing.h"
#include "core/drawing/tool_path.h"
#include "core/sequence/sequence.h"

namespace hw {

struct ConversionOptions {
  std::string unit = "mm";           ///< of the sequence
  std::string drawing_unit;          ///< overrides the file's unit; empty: the file's
  double times = 1;                  ///< scale factor on the size in the file
  std::vector<sequence::Axis> axes;  ///< the first follows the drawing's X
  std::vector<std::string> layers;   ///< empty: those that are shown
  std::vector<int> without;          ///< indexes in Drawing::paths to leave out
  drawing::Placing placing;          ///< its scale is set from the units
  double touching = 0.001;           ///< ends this close are joined, in `unit`
  std::optional<double> tolerance;   ///< of chords and stairs, in `unit`; none: half a step
  bool keep_order = false;           ///< keep the order of the file
  sequence::Speeds cutting, travel;
  /// The names of the two speeds in messages to the user.
  std::string cutting_name = "the speed with the tool on", travel_name = "the speed with the tool off";
  sequence::StepList pen_up, pen_down;
  std::optional<drawing::Box> table;  ///< reach of the tool, in `unit`
};

struct Conversion {
  sequence::Sequence sequence;
  sequence::Sequence frame;            ///< drives once around the drawing, tool up
  drawing::Affine placed;              ///< from the drawing to the sequence
  std::vector<drawing::Chain> chains;  ///< in drawing order, in `unit`
  std::vector<std::size_t> begins;     ///< first step in the sequence of each chain
  drawing::Box box;
  int box_around = -1;  ///< index in `chains` of a box around all others, such as margins; -1: none
  drawing::CurveMode curve_mode = drawing::CurveMode::lines;
  double tolerance = 0;
  double drawn = 0;  ///< length of all chains
  /// Travel of the machine with the tool up: in the file's order, and in the order of `chains`.
  double way_as_drawn = 0, way = 0;
  std::vector<std::size_t> off_the_table;  ///< places in `chains`
};

/// How the controller follows a chain; the second form considers the drawing axes too.
drawing::CurveMode curve_mode_of(const Catalog& catalog);
drawing::CurveMode curve_mode_of(const Catalog& catalog, const ConversionOptions& options);
/// Largest distance of splines and ellipses from their chords, in the options' unit.
double finest_chord(const Catalog& catalog, const ConversionOptions& options);
/// Reads a file, its splines and ellipses as fine as finest_chord(). May block: for a worker.
Result<drawing::Drawing> read_drawing(const std::filesystem::path& file, const Catalog& catalog,
                                      const ConversionOptions& options);
/// The chosen part of a drawing and where it would lie, shown until all options needed to draw it are given.
/// A drawing without a unit is taken to be in `unit`.
struct Outline {
  drawing::ToolPath path;  ///< in `unit`, tool always on; a source is a chain
  drawing::Affine placed;  ///< from the drawing
  bool unit_is_given = true;
};
Result<Outline> outline_of(const drawing::Drawing& drawing, const ConversionOptions& options);
/// The unit assumed for the drawing; empty: unknown.
[[nodiscard]] const std::string& unit_of(const drawing::Drawing& drawing, const ConversionOptions& options);
/// "mm", "in" ... in millimetres; none: not a unit.
std::optional<double> millimetres(const std::string& unit);

/// Notes on the tool for controllers that draw together; a program's text already has them.
Result<std::string> tool_remark(const sequence::Sequence& sequence, const Catalog& together);

Result<Conversion> convert(const drawing::Drawing& drawing, const Catalog& catalog,
                           const ConversionOptions& options, const drawing::Progress& progress = {});

}  // namespace hw
