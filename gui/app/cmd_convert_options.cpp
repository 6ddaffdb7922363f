#include "gui/app/cmd_convert_options.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "core/base/number_text.h"
#include "core/base/split.h"
#include "core/session/tool_routine.h"
#include "gui/app/cmd_convert_scale.h"
#include "gui/app/option_numbers.h"

namespace hw::app {
namespace {

/// The unit of the option overrides the unit of the file.
Result<> read_unit(const Given& given, ConversionOptions& o) {
  const auto times = given.number("times", 1, 1e-9, 1e9);
  if (!times) return fail(times.error());
  o.times = *times;
  o.drawing_unit = given.one("unit");
  if (o.drawing_unit.empty() || millimetres(o.drawing_unit)) return {};
  return wrong("unit", given, "mm, in, cm, m, ft or another unit of length");
}

Result<> read_axes(const Given& given, const Catalog& catalog, ConversionOptions& o) {
  std::vector<std::string> names;
  const std::string listed = given.one("axes");
  if (given.has("axes"))
    for (const std::string_view name : split(listed, ',')) names.emplace_back(name);
  else
    for (std::size_t i = 0; i < std::min<std::size_t>(2, catalog.axes.size()); ++i)
      names.push_back(catalog.axes[i].name);
  const auto scales = read_scales(given, catalog, names);
  if (!scales) return fail(scales.error());
  for (std::size_t i = 0; i < names.size(); ++i) o.axes.push_back({names[i], (*scales)[i]});
  return {};
}

Result<> read_placing(const Given& given, ConversionOptions& o) {
  const std::string origin = given.one("origin", "as-drawn");
  if (origin == "lower-left") {
    o.placing.origin = drawing::Placing::Origin::lower_left;
  } else if (origin != "as-drawn") {
    const auto at = numbers(given, "origin", ',', 2, 2, "as-drawn, lower-left or X,Y");
    if (!at) return fail(at.error());
    o.placing.origin = drawing::Placing::Origin::point, o.placing.point = {(*at)[0], (*at)[1]};
  }
  o.placing.swapped = given.has("swap");
  const std::string mirror = given.one("mirror");
  if (mirror.find_first_not_of("xy") != mirror.npos) return wrong("mirror", given, "x, y or xy");
  o.placing.mirrored_x = mirror.find('x') != mirror.npos,
  o.placing.mirrored_y = mirror.find('y') != mirror.npos;
  if (given.has("table")) {
    const auto table = numbers(given, "table", ',', 4, 4, "X0,Y0,X1,Y1");
    if (!table) return fail(table.error());
    if ((*table)[0] == (*table)[2] || (*table)[1] == (*table)[3])
      return wrong("table", given, "X0,Y0,X1,Y1 of two corners that lie across from each other");
    drawing::Box box;
    box.add({(*table)[0], (*table)[1]});
    box.add({(*table)[2], (*table)[3]});
    o.table = box;
  }
  return {};
}

Result<> read_speeds(const Given& given, ConversionOptions& o) {
  struct Field {
    const char* option;
    double* value;
  };
  o.cutting_name = "--cut-speed", o.travel_name = "--travel-speed";
  double low = 0, ramp = 0;
  for (const Field& f : {Field{"cut-speed", &o.cutting.high}, Field{"travel-speed", &o.travel.high},
                         Field{"low-speed", &low}, Field{"ramp", &ramp}}) {
    const auto read = given.number(f.option, 0, 0, 1e9);
    if (!read) return fail(read.error());
    *f.value = *read;
  }
  for (sequence::Speeds* s : {&o.cutting, &o.travel})
    if (s->high != 0) s->low = low, s->ramp_ms = ramp;
  for (const char* option : {"low-speed", "ramp"})
    if (given.has(option) && o.cutting.high == 0 && o.travel.high == 0)
      return fail(FaultKind::text, fmt::format("--{} applies to the speeds that you give.", option), {},
                  "Add --cut-speed and --travel-speed.");
  return {};
}

Result<> read_pen_axis(const Given& given, PlainTool& tool) {
  if (!given.has("pen-axis")) return {};
  const std::string text = given.one("pen-axis");
  const std::vector<std::string_view> parts = split(text, ':');
  const auto down = parts.size() == 3 ? finite_number(parts[1]) : std::nullopt;
  const auto up = parts.size() == 3 ? finite_number(parts[2]) : std::nullopt;
  if (!down || !up) return wrong("pen-axis", given, "AXIS:DOWN:UP");
  tool.axis = parts[0], tool.down = *down, tool.up = *up;
  return {};
}

/// Reads the tool's delays: one for each direction, or one for both.
Result<> read_pen_delays(const Given& given, PlainTool& tool) {
  const auto both = given.number("pen-delay", 0, 0, 1e6);
  if (!both) return fail(both.error());
  for (auto [option, ms] :
       {std::pair{"pen-down-delay", &tool.down_delay_ms}, std::pair{"pen-up-delay", &tool.up_delay_ms}}) {
    const auto delay = given.number(option, *both, 0, 1e6);
    if (!delay) return fail(delay.error());
    *ms = *delay;
  }
  return {};
}

Result<> read_routines(const Given& given, const Catalog& catalog, ConversionOptions& o) {
  Result<> scaled;
  const auto per_unit = [&, otherwise = o.axes.front().per_unit](const std::string& axis) {
    const auto scale = read_pen_scale(given, catalog, axis, otherwise);
    if (!scale) scaled = fail(scale.error());
    return scale.value_or(otherwise);
  };
  for (const char* other : {"pen-output", "pen-axis", "pen-delay", "pen-down-delay", "pen-up-delay"})
    if (given.has(other))
      return fail(FaultKind::text, fmt::format("--{} and --pen-down or --pen-up mean the same.", other), {},
                  "Write one of them.");
  for (auto [option, routine] : {std::pair{"pen-down", &o.pen_down}, std::pair{"pen-up", &o.pen_up}}) {
    auto read = read_routine(given.one(option), catalog, per_unit, o.axes);
    if (!scaled) return scaled;
    if (!read) {
      read.error().what = fmt::format("--{}: {}", option, read.error().what);
      return fail(read.error());
    }
    *routine = std::move(*read);
  }
  return switches_back(o.pen_down, o.pen_up, catalog);
}

Result<> read_pen(const Given& given, const Catalog& catalog, ConversionOptions& o) {
  if (given.has("pen-down") || given.has("pen-up")) return read_routines(given, catalog, o);
  PlainTool tool;
  if (given.has("pen-output")) {
    const auto number = given.number("pen-output", 0, 0, 64);
    if (!number) return fail(number.error());
    tool.output = static_cast<int>(*number);
  }
  if (auto axis = read_pen_axis(given, tool); !axis) return axis;
  if (!tool.axis.empty()) {
    const auto scale = read_pen_scale(given, catalog, tool.axis, o.axes.front().per_unit);
    if (!scale) return fail(scale.error());
    tool.per_unit = *scale;
  }
  if (auto delays = read_pen_delays(given, tool); !delays) return delays;
  put_tool(tool, o.axes, o.pen_down, o.pen_up);
  return {};
}

}  // namespace

Result<ConversionOptions> read_conversion(const Given& given, const Catalog& catalog) {
  ConversionOptions o;
  o.unit = given.has("inch") ? "in" : "mm";
  if (auto read = read_unit(given, o); !read) return fail(read.error());
  o.layers = given.all("layer");
  o.keep_order = given.has("keep-order");
  if (auto read = read_axes(given, catalog, o); !read) return fail(read.error());
  if (auto read = read_placing(given, o); !read) return fail(read.error());
  if (auto read = read_speeds(given, o); !read) return fail(read.error());
  if (auto read = read_pen(given, catalog, o); !read) return fail(read.error());
  const auto touching = given.number("join", o.touching, 0, 1e6);
  if (!touching) return fail(touching.error());
  o.touching = *touching;
  if (given.has("tolerance")) {
    const auto tolerance = given.number("tolerance", 0, 1e-9, 1e6);
    if (!tolerance) return fail(tolerance.error());
    o.tolerance = *tolerance;
  }
  return o;
}

}  // namespace hw::app
