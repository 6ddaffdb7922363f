#include "core/session/conversion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/device/sequence_draft.h"
#include "core/drawing/dxf_reader.h"
#include "core/drawing/dxf_scan.h"
#include "core/session/user_files.h"

namespace hw {
namespace {

using drawing::CurveMode;

constexpr int entries_of_a_piece = 4;  // of a contour, at most

tl::unexpected<Fault> refuse(std::string what, std::string advice = {}) {
  return fail(FaultKind::text, std::move(what), "Nothing was converted.", std::move(advice));
}

Result<double> scale_of(const drawing::Drawing& drawing, const ConversionOptions& o) {
  const std::string& from = unit_of(drawing, o);
  if (from.empty()) return refuse("The drawing does not name its unit.", "Say which: mm, in, cm, m ...");
  const auto its = millimetres(from), ours = millimetres(o.unit);
  if (!its || !ours) return refuse(fmt::format("\"{}\" is not a unit of length.", its ? o.unit : from));
  return *its / *ours * o.times;
}

/// "CUT, HOLES and 12 more"
std::string layers_of(const drawing::Drawing& drawing) {
  constexpr std::size_t most = 8;
  std::string all;
  for (std::size_t i = 0; i < std::min(most, drawing.layers.size()); ++i)
    all += fmt::format("{}\"{}\"", i > 0 ? ", " : "", drawing.layers[i].name);
  if (drawing.layers.size() > most) all += fmt::format(" and {} more", drawing.layers.size() - most);
  return all;
}

/// Shows only the wanted layers; none wanted: unchanged.
Result<drawing::Drawing> choose_layers(const drawing::Drawing& whole,
                                       const std::vector<std::string>& wanted) {
  drawing::Drawing chosen = whole;
  if (wanted.empty()) return chosen;
  for (drawing::Layer& layer : chosen.layers)
    layer.shown = std::any_of(wanted.begin(), wanted.end(), [&](const std::string& name) {
      return drawing::is_same_name(layer.name, name);
    });
  for (const std::string& name : wanted)
    if (std::none_of(whole.layers.begin(), whole.layers.end(),
                     [&](const drawing::Layer& layer) { return drawing::is_same_name(layer.name, name); }))
      return refuse(fmt::format("The drawing has no layer \"{}\".", name),
                    whole.layers.empty() ? "" : fmt::format("It has {}.", layers_of(whole)));
  return chosen;
}

double length_of(const std::vector<drawing::Chain>& chains) {
  double all = 0;
  for (const drawing::Chain& chain : chains)
    for (const drawing::Curve& curve : chain.curves) all += curve.length();
  return all;
}

Result<double> tolerance_of(CurveMode curve_mode, const ConversionOptions& o) {
  if (o.tolerance) {
    if (!(*o.tolerance > 0)) return refuse("The tolerance has to be more than 0.");
    return *o.tolerance;
  }
  if (curve_mode == CurveMode::stairs)
    return refuse("This controller moves one axis at a time: a slanted line becomes a staircase.",
                  "Give a tolerance: how far its corners may lie from the line.");
  double finest = 0;
  for (const sequence::Axis& axis : o.axes) finest = std::max(finest, axis.per_unit);
  return 0.5 / finest;
}

std::vector<std::size_t> off_the(const drawing::Box& table, const std::vector<drawing::Chain>& chains) {
  constexpr double rounding = 1e-9;  // where a circle touches the edge
  std::vector<std::size_t> off;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const drawing::Box box = drawing::box_of({chains[i]});
    if (box.low.x < table.low.x - rounding || box.low.y < table.low.y - rounding ||
        box.high.x > table.high.x + rounding || box.high.y > table.high.y + rounding)
      off.push_back(i);
  }
  return off;
}

/// Names the entity that lies beyond the controller's range, before any step is made.
Result<> can_be_counted(const std::vector<drawing::Chain>& chains, const Catalog& catalog,
                        const ConversionOptions& o) {
  constexpr double furthest = 9007199254740992;  // steps, 2^53: a double cannot tell larger ones apart
  const bool has_range = catalog.position_max > catalog.position_min;
  const double low = has_range ? static_cast<double>(catalog.position_min.value) : -furthest;
  const double high = has_range ? static_cast<double>(catalog.position_max.value) : furthest;
  for (const drawing::Chain& chain : chains) {
    const drawing::Box box = drawing::box_of({chain});
    const std::array<std::array<double, 2>, 2> reach{{{box.low.x, box.high.x}, {box.low.y, box.high.y}}};
    for (const std::size_t axis : {0, 1})
      for (const double at : reach[axis]) {
        const double steps = std::round(at * o.axes[axis].per_unit);
        if (steps >= low && steps <= high) continue;
        return refuse(
            fmt::format("Entity {}, line {} of the file, reaches {:.6g} {} of {}: that is {:.15g} {}, and "
                        "the range of a {} is {:.0f} to {:.0f}.",
                        chain.entity, chain.line, at, o.unit, o.axes[axis].name, steps, catalog.step_word,
                        catalog.short_name, low, high));
      }
  }
  return {};
}

/// The chosen chains and their placement.
struct Put {
  std::vector<drawing::Chain> chains;
  drawing::Affine placed;
};
Result<Put> put_chains(const drawing::Drawing& whole, double scale, const ConversionOptions& o) {
  const auto chosen = choose_layers(whole, o.layers);
  if (!chosen) return fail(chosen.error());
  Put put{drawing::join(*chosen, o.touching / scale, o.without), {}};
  if (put.chains.empty())
    return refuse("The drawing has nothing that can be drawn.",
                  whole.paths.empty() ? "" : "Choose a layer with lines on it, or leave less out.");
  drawing::Placing placing = o.placing;
  placing.scale = scale;
  put.placed = drawing::place(put.chains, placing);
  return put;
}

/// Requires two drawing axes and perhaps others that lower the tool, each once.
Result<> are_axes_that_draw(const Catalog& catalog, const ConversionOptions& o) {
  if (o.axes.size() < 2)
    return refuse(fmt::format("A drawing needs two axes; {} {} given.", o.axes.size(),
                              o.axes.size() == 1 ? "is" : "are"),
                  catalog.axes.size() == 1 ? "Two controllers of one axis each on a bus draw together." : "");
  for (std::size_t i = 0; i < o.axes.size(); ++i)
    for (std::size_t before = 0; before < i; ++before)
      if (o.axes[i].name == o.axes[before].name)
        return refuse(i == 1 ? fmt::format("Axis {} would be both axes of the drawing.", o.axes[i].name)
                             : fmt::format("Axis {} draws, and so cannot lower the tool.", o.axes[i].name),
                      "Choose another axis.");
  return {};
}

/// Both speeds or neither: a controller would keep the only one for all of its moves. Contours have a speed
/// of their own.
Result<> has_its_speeds(CurveMode curve_mode, const Catalog& catalog, const ConversionOptions& o) {
  const bool cuts = o.cutting.high > 0, travels = o.travel.high > 0;
  if (curve_mode == CurveMode::contours && !cuts)
    return refuse(fmt::format("A {} draws contours at one speed, and none is given.", catalog.short_name),
                  fmt::format("Give {}.", o.cutting_name));
  if (curve_mode == CurveMode::contours || cuts == travels) return {};
  return refuse(fmt::format("Only {} is given, and the controller would keep it for all of its moves.",
                            cuts ? o.cutting_name : o.travel_name),
                fmt::format("Give {} too.", cuts ? o.travel_name : o.cutting_name));
}

/// Refuses a drawing smaller than a step or the tolerance: its shape would be lost.
Result<> keeps_its_shape(const Conversion& made, const Catalog& catalog, const ConversionOptions& o) {
  const double width = made.box.high.x - made.box.low.x, height = made.box.high.y - made.box.low.y;
  const double longer = std::max(width, height);
  if (!(longer > 0)) return {};  // dots
  if (width * o.axes[0].per_unit < 1 && height * o.axes[1].per_unit < 1)
    return refuse(
        fmt::format(
            "The whole drawing is smaller than one of the {}: {:g} x {:g} {}, with {:g} and {:g} {} per {}.",
            catalog.step_word, width, height, o.unit, o.axes[0].per_unit, o.axes[1].per_unit,
            catalog.step_word, o.unit),
        "Check the unit and the scale of the drawing.");
  if (made.tolerance <= longer) return {};
  return refuse(
      fmt::format("A tolerance of {:g} {} is larger than the whole drawing, which is {:g} x {:g} {}.",
                  made.tolerance, o.unit, width, height, o.unit),
      "Make the tolerance smaller.");
}

/// Refuses stairs with too many moves.
Result<> are_few_enough(const std::vector<drawing::Chain>& chains, const Conversion& made,
                        const ConversionOptions& o) {
  constexpr double most = 5e6;
  const double moves = made.curve_mode == CurveMode::stairs ? 2 * length_of(chains) / made.tolerance : 0;
  if (moves <= most) return {};
  return refuse(
      fmt::format("Stairs that lie within {:g} {} of the line would take some {:.0f} million moves.",
                  made.tolerance, o.unit, moves / 1e6),
      "Give a larger tolerance.");
}

}  // namespace

std::optional<double> millimetres(const std::string& unit) {
  constexpr double survey_foot = 1200.0 / 3937 * 1000;
  static constexpr std::pair<std::string_view, double> units[] = {{"mm", 1},
                                                                  {"in", 25.4},
                                                                  {"inch", 25.4},
                                                                  {"cm", 10},
                                                                  {"m", 1000},
                                                                  {"um", 1e-3},
                                                                  {"ft", 304.8},
                                                                  {"mil", 0.0254},
                                                                  {"uin", 0.0000254},
                                                                  {"yd", 914.4},
                                                                  {"mi", 1'609'344},
                                                                  {"dm", 100},
                                                                  {"dam", 1e4},
                                                                  {"hm", 1e5},
                                                                  {"km", 1e6},
                                                                  {"nm", 1e-6},
                                                                  {"angstrom", 1e-7},
                                                                  {"us-in", survey_foot / 12},
                                                                  {"us-ft", survey_foot},
                                                                  {"us-yd", survey_foot * 3},
                                                                  {"us-mi", survey_foot * 5280},
                                                                  {"Gm", 1e12},
                                                                  {"au", 1.495978707e14},
                                                                  {"ly", 9.4607304725808e18},
                                                                  {"pc", 3.0856775814913673e19}};
  for (const auto& [name, length] : units)
    if (name == unit) return length;
  return std::nullopt;
}

double finest_chord(const Catalog& catalog, const ConversionOptions& o) {
  if (o.tolerance) return drawing::chord_within(*o.tolerance, curve_mode_of(catalog, o));
  double finest = 1;
  for (const sequence::Axis& axis : o.axes) finest = std::min(finest, 0.5 / axis.per_unit);
  return finest;
}

// Splines and ellipses are flattened while reading, so the file is read again if its unit needs another
// tolerance.
Result<drawing::Drawing> read_drawing(const std::filesystem::path& path, const Catalog& catalog,
                                      const ConversionOptions& o) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(path, unknown);
  if (!unknown)
    if (auto small = drawing::may_be_read(size, path.string()); !small) return fail(small.error());
  const auto file = read_file(path, drawing::largest_dxf);
  if (!file) return fail(file.error());
  const double finest = finest_chord(catalog, o);
  drawing::Tolerance tolerance{finest};
  auto drawing = drawing::read_dxf(*file, path.string(), tolerance);
  if (!drawing) return drawing;
  const auto its = millimetres(unit_of(*drawing, o));
  tolerance.chord = finest * millimetres(o.unit).value_or(1) / its.value_or(1) / o.times;
  return tolerance.chord != finest ? drawing::read_dxf(*file, path.string(), tolerance) : drawing;
}

const std::string& unit_of(const drawing::Drawing& drawing, const ConversionOptions& o) {
  return o.drawing_unit.empty() ? drawing.unit : o.drawing_unit;
}

Result<Outline> outline_of(const drawing::Drawing& whole, const ConversionOptions& o) {
  constexpr double chord_of_size = 2e-4;
  Outline outline;
  outline.unit_is_given = !unit_of(whole, o).empty();
  const auto scale = outline.unit_is_given ? scale_of(whole, o) : o.times;
  if (!scale) return fail(scale.error());
  auto put = put_chains(whole, *scale, o);
  if (!put) return fail(put.error());
  outline.placed = put->placed;
  const drawing::Box box = drawing::box_of(put->chains);
  const double chord = std::max(box.high.x - box.low.x, box.high.y - box.low.y) * chord_of_size;
  for (std::size_t i = 0; i < put->chains.size(); ++i)
    for (const drawing::Curve& curve : put->chains[i].curves) {
      drawing::Point at = curve.from;
      drawing::chords(curve, chord, [&](drawing::Point to) {
        outline.path.go({at.x, at.y}, {to.x, to.y}, true, static_cast<int>(i));
        at = to;
      });
    }
  return outline;
}

Result<std::string> tool_remark(const sequence::Sequence& sequence, const Catalog& together) {
  SequenceDraft draft(sequence, together);  // with the note of the program writers
  if (auto done = draft.tool_line({}); !done) return fail(done.error());
  return std::move(draft).finish().tool;
}

CurveMode curve_mode_of(const Catalog& catalog) {
  if (catalog.can.contours) return CurveMode::contours;
  if (catalog.can.arcs) return CurveMode::arcs;
  return catalog.can.interpolates ? CurveMode::lines : CurveMode::stairs;
}

// Arcs need the first two axes. With different steps per unit a circle is not a circle for the controller.
CurveMode curve_mode_of(const Catalog& catalog, const ConversionOptions& o) {
  const CurveMode curve_mode = curve_mode_of(catalog);
  if (o.axes.size() < 2) return curve_mode;
  const bool first_two = catalog.axes.size() > 1 && o.axes[0].name == catalog.axes[0].name &&
                         o.axes[1].name == catalog.axes[1].name;
  const bool no_arcs =
      o.axes[0].per_unit != o.axes[1].per_unit || (curve_mode == CurveMode::arcs && !first_two);
  if (!no_arcs) return curve_mode;
  return catalog.can.interpolates ? CurveMode::lines : CurveMode::stairs;
}

Result<Conversion> convert(const drawing::Drawing& whole, const Catalog& catalog, const ConversionOptions& o,
                           const drawing::Progress& progress) {
  if (auto axes = are_axes_that_draw(catalog, o); !axes) return fail(axes.error());
  Conversion made;
  made.curve_mode = curve_mode_of(catalog, o);
  if (auto speeds = has_its_speeds(made.curve_mode, catalog, o); !speeds) return fail(speeds.error());
  const auto scale = scale_of(whole, o);
  if (!scale) return fail(scale.error());
  const auto tolerance = tolerance_of(made.curve_mode, o);
  if (!tolerance) return fail(tolerance.error());
  auto put = put_chains(whole, *scale, o);
  if (!put) return fail(put.error());

  made.tolerance = *tolerance;
  made.chains = std::move(put->chains), made.placed = put->placed;
  if (auto counted = can_be_counted(made.chains, catalog, o); !counted) return fail(counted.error());
  if (auto few = are_few_enough(made.chains, made, o); !few) return fail(few.error());
  made.box = drawing::box_of(made.chains);
  if (auto seen = keeps_its_shape(made, catalog, o); !seen) return fail(seen.error());
  const bool in_turn = made.curve_mode == CurveMode::stairs;
  made.way_as_drawn = made.way = drawing::way_between(made.chains, {}, in_turn);
  if (!o.keep_order) {
    drawing::order(made.chains, {}, progress);
    made.way = drawing::way_between(made.chains, {}, in_turn);
  }
  made.box_around = drawing::box_around(made.chains);
  made.drawn = length_of(made.chains);
  if (o.table) made.off_the_table = off_the(*o.table, made.chains);

  made.sequence.unit = o.unit;
  made.sequence.axes = o.axes;
  made.sequence.pen_up = o.pen_up, made.sequence.pen_down = o.pen_down;
  if (made.curve_mode == CurveMode::arcs) made.sequence.tolerance = o.tolerance.value_or(0);
  drawing::Tool tool;
  tool.curve_mode = made.curve_mode, tool.tolerance = made.tolerance;
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
