#include "core/session/conversion.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/drawing/dxf_reader.h"
#include "core/drawing/dxf_scan.h"
#include "core/session/user_files.h"

namespace hw {
namespace {

using drawing::Going;

constexpr int entries_of_a_piece = 4;  // of a contour, at most

tl::unexpected<Fault> refuse(std::string what, std::string advice = {}) {
  return fail(FaultKind::text, std::move(what), "Nothing was converted.", std::move(advice));
}

Result<double> scale_of(const drawing::Drawing& drawing, const ConversionOptions& o) {
  const std::string& from = drawing.unit.empty() ? o.drawing_unit : drawing.unit;
  if (from.empty())
    return refuse("The drawing does not say in which unit it is.", "Say whether it is mm or in.");
  const auto its = millimetres(from), ours = millimetres(o.unit);
  if (!its || !ours) return refuse(fmt::format("\"{}\" is no unit of length.", its ? o.unit : from));
  return *its / *ours;
}

/// Only the layers that are meant.
Result<drawing::Drawing> choose_layers(const drawing::Drawing& whole,
                                       const std::vector<std::string>& wanted) {
  drawing::Drawing chosen = whole;
  if (wanted.empty()) return chosen;
  for (drawing::Layer& layer : chosen.layers)
    layer.shown = std::find(wanted.begin(), wanted.end(), layer.name) != wanted.end();
  for (const std::string& name : wanted)
    if (std::none_of(whole.layers.begin(), whole.layers.end(),
                     [&](const drawing::Layer& layer) { return layer.name == name; }))
      return refuse(fmt::format("The drawing has no layer \"{}\".", name));
  return chosen;
}

double length_of(const std::vector<drawing::Chain>& chains) {
  double all = 0;
  for (const drawing::Chain& chain : chains)
    for (const drawing::Curve& curve : chain.curves) all += curve.length();
  return all;
}

Result<double> tolerance_of(Going going, const ConversionOptions& o) {
  if (o.tolerance) {
    if (!(*o.tolerance > 0)) return refuse("The tolerance has to be more than 0.");
    return *o.tolerance;
  }
  if (going == Going::stairs)
    return refuse("This controller moves one axis at a time: a slanted line becomes a staircase.",
                  "Say how far its corners may lie beside the line.");
  double finest = 0;
  for (const sequence::Axis& axis : o.axes) finest = std::max(finest, axis.per_unit);
  return 0.5 / finest;
}

std::vector<std::size_t> off_the(const drawing::Box& table, const std::vector<drawing::Chain>& chains) {
  std::vector<std::size_t> off;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const drawing::Box box = drawing::box_of({chains[i]});
    if (box.low.x < table.low.x || box.low.y < table.low.y || box.high.x > table.high.x ||
        box.high.y > table.high.y)
      off.push_back(i);
  }
  return off;
}

}  // namespace

std::optional<double> millimetres(const std::string& unit) {
  static constexpr std::array<std::pair<std::string_view, double>, 9> units{{{"mm", 1},
                                                                             {"in", 25.4},
                                                                             {"inch", 25.4},
                                                                             {"cm", 10},
                                                                             {"m", 1000},
                                                                             {"um", 0.001},
                                                                             {"ft", 304.8},
                                                                             {"mil", 0.0254},
                                                                             {"uin", 0.0000254}}};
  for (const auto& [name, length] : units)
    if (name == unit) return length;
  return std::nullopt;
}

double finest_chord(const ConversionOptions& o) {
  if (o.tolerance) return *o.tolerance;
  double finest = 1;
  for (const sequence::Axis& axis : o.axes) finest = std::min(finest, 0.5 / axis.per_unit);
  return finest;
}

// Splines and ellipses are flattened as they are read: again, finer, where the file's unit asks for that.
Result<drawing::Drawing> read_drawing(const std::filesystem::path& path, const ConversionOptions& o) {
  const auto file = read_file(path, drawing::largest_dxf);
  if (!file) return fail(file.error());
  const double finest = finest_chord(o);
  drawing::Tolerance tolerance{finest};
  auto drawing = drawing::read_dxf(*file, path.string(), tolerance);
  if (!drawing) return drawing;
  const auto its = millimetres(drawing->unit.empty() ? o.drawing_unit : drawing->unit);
  tolerance.chord = finest * millimetres(o.unit).value_or(1) / its.value_or(1);
  return tolerance.chord < finest ? drawing::read_dxf(*file, path.string(), tolerance) : drawing;
}

Going going_of(const Catalog& catalog) {
  if (catalog.can.contours) return Going::contours;
  if (catalog.can.arcs) return Going::arcs;
  return catalog.can.interpolates ? Going::lines : Going::stairs;
}

Result<Conversion> convert(const drawing::Drawing& whole, const Catalog& catalog, const ConversionOptions& o,
                           const drawing::Progress& progress) {
  if (o.axes.size() < 2)
    return refuse(fmt::format("A drawing needs two axes; {} {} given.", o.axes.size(),
                              o.axes.size() == 1 ? "is" : "are"));
  Conversion made;
  made.going = going_of(catalog);
  // Arcs are of the first two axes; and where the axes differ in their steps a circle is none of the
  // controller's any more.
  const bool first_two = catalog.axes.size() > 1 && o.axes[0].name == catalog.axes[0].name &&
                         o.axes[1].name == catalog.axes[1].name;
  const bool no_arcs = o.axes[0].per_unit != o.axes[1].per_unit || (made.going == Going::arcs && !first_two);
  if (no_arcs && made.going != Going::stairs)
    made.going = catalog.can.interpolates ? Going::lines : Going::stairs;
  const auto scale = scale_of(whole, o);
  if (!scale) return fail(scale.error());
  const auto tolerance = tolerance_of(made.going, o);
  if (!tolerance) return fail(tolerance.error());
  const auto chosen = choose_layers(whole, o.layers);
  if (!chosen) return fail(chosen.error());

  made.tolerance = *tolerance;
  made.chains = drawing::join(*chosen, o.touching / *scale, o.without);
  if (made.chains.empty()) return refuse("There is nothing in the drawing that could be drawn.");
  drawing::Placing placing = o.placing;
  placing.scale = *scale;
  made.placed = drawing::place(made.chains, placing);
  made.way_as_drawn = made.way = drawing::way_between(made.chains, {});
  if (!o.keep_order) {
    drawing::order(made.chains, {}, progress);
    made.way = drawing::way_between(made.chains, {});
  }
  made.box = drawing::box_of(made.chains);
  made.box_around = drawing::box_around(made.chains);
  made.drawn = length_of(made.chains);
  if (o.table) made.off_the_table = off_the(*o.table, made.chains);

  made.sequence.unit = o.unit;
  made.sequence.axes = o.axes;
  made.sequence.pen_up = o.pen_up, made.sequence.pen_down = o.pen_down;
  if (made.going == Going::arcs) made.sequence.tolerance = o.tolerance.value_or(0);
  drawing::Tool tool;
  tool.going = made.going, tool.tolerance = made.tolerance;
  tool.cutting = o.cutting, tool.travel = o.travel;
  for (std::size_t i = 0; i < catalog.outputs.size(); ++i)
    if (catalog.outputs[i].on_the_way) tool.contour_outputs.push_back(catalog.output_number(i));
  tool.contour_pieces = std::max(1, catalog.contour_size / entries_of_a_piece - 2);
  made.frame = made.sequence;
  drawing::draw_frame(made.box, tool, made.frame);
  made.begins = drawing::draw_chains(made.chains, tool, made.sequence);
  return made;
}

}  // namespace hw
