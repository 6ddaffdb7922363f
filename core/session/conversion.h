#pragma once
// From a drawing to the sequence that a controller can carry out: layers chosen, ends joined, placed on the
// table, put into order, and made into what its machine can do. Pure and long: for a worker thread.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/device/catalog.h"
#include "core/drawing/chains.h"
#include "core/drawing/placing.h"
#include "core/sequence/sequence.h"

namespace hw {

struct ConversionOptions {
  std::string unit = "mm";           ///< in which the sequence is to be
  std::string drawing_unit;          ///< where the file does not say it; else empty
  std::vector<sequence::Axis> axes;  ///< the first goes along the drawing's X
  std::vector<std::string> layers;   ///< none: those that are shown
  std::vector<int> without;          ///< places in Drawing::paths that are left out
  drawing::Placing placing;          ///< its scale comes from the units
  double touching = 0.001;           ///< ends so near are joined, in `unit`
  std::optional<double> tolerance;   ///< of chords and stairs, in `unit`; none: half a step
  bool keep_order = false;           ///< of the file
  sequence::Speeds cutting, travel;
  sequence::StepList pen_up, pen_down;
  std::optional<drawing::Box> table;  ///< where the tool gets, in `unit`
};

struct Conversion {
  sequence::Sequence sequence;
  sequence::Sequence frame;            ///< once around it with the tool up
  drawing::Affine placed;              ///< from the drawing to the sequence
  std::vector<drawing::Chain> chains;  ///< as they are drawn, in `unit`
  std::vector<std::size_t> begins;     ///< at which of the sequence's steps each of them begins
  drawing::Box box;
  int box_around = -1;  ///< of all else, as margins are: its place in `chains`; -1: there is none
  drawing::Going going = drawing::Going::lines;
  double tolerance = 0;
  double drawn = 0;                        ///< length of all chains
  double way_as_drawn = 0, way = 0;        ///< with the tool up: in the order of the file, and as ordered
  std::vector<std::size_t> off_the_table;  ///< places in `chains`
};

/// How the controller gets along a chain; and by the axes that draw.
drawing::Going going_of(const Catalog& catalog);
drawing::Going going_of(const Catalog& catalog, const ConversionOptions& options);
/// How far splines and ellipses may lie beside their chords, in the unit of the options.
double finest_chord(const Catalog& catalog, const ConversionOptions& options);
/// The file, its splines and ellipses as fine as that. May block: for a worker.
Result<drawing::Drawing> read_drawing(const std::filesystem::path& file, const Catalog& catalog,
                                      const ConversionOptions& options);
/// "mm", "in" ... in millimetres; none: it is no unit.
std::optional<double> millimetres(const std::string& unit);

/// Of controllers that draw together: what is to be known of their tool. A program's text says it by itself.
Result<std::string> said_of_tool(const sequence::Sequence& sequence, const Catalog& together);

Result<Conversion> convert(const drawing::Drawing& drawing, const Catalog& catalog,
                           const ConversionOptions& options, const drawing::Progress& progress = {});

}  // namespace hw
