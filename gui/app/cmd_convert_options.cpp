#include "gui/app/cmd_convert_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/session/tool_routine.h"

namespace hw::app {
namespace {

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find(at);
    parts.emplace_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

tl::unexpected<Fault> wrong(const char* option, const Given& given, const char* form) {
  return fail(FaultKind::text, fmt::format("--{} {} is not understood.", option, given.one(option)), {},
              fmt::format("Write --{} {}.", option, form));
}

Result<std::vector<double>> numbers(const Given& given, const char* option, char at, std::size_t least,
                                    std::size_t most, const char* form) {
  std::vector<double> all;
  for (const std::string& part : split(given.one(option), at)) {
    const auto number = number_in(part);
    if (!number) return wrong(option, given, form);
    all.push_back(*number);
  }
  if (all.size() < least || all.size() > most) return wrong(option, given, form);
  return all;
}

/// The option overrides the file.
Result<> read_unit(const Given& given, ConversionOptions& o) {
  const auto times = given.number("times", 1, 1e-9, 1e9);
  if (!times) return fail(times.error());
  o.times = *times;
  o.drawing_unit = given.one("unit");
  if (o.drawing_unit.empty() || millimetres(o.drawing_unit)) return {};
  return wrong("unit", given, "mm, in, cm, m, ft or another unit of length");
}

Result<> read_axes(const Given& given, const Catalog& catalog, ConversionOptions& o) {
  std::vector<double> per_unit{1};
  if (given.has("per-unit")) {
    auto read = numbers(given, "per-unit", ',', 1, 2, "STEPS or STEPS,STEPS");
    if (!read) return fail(read.error());
    per_unit = std::move(*read);
    if (*std::min_element(per_unit.begin(), per_unit.end()) <= 0)
      return wrong("per-unit", given, "more than 0");
  }
  std::vector<std::string> names;
  if (given.has("axes"))
    names = split(given.one("axes"), ',');
  else
    for (std::size_t i = 0; i < std::min<std::size_t>(2, catalog.axes.size()); ++i)
      names.push_back(catalog.axes[i].name);
  for (std::size_t i = 0; i < names.size(); ++i) o.axes.push_back({names[i], per_unit[i % per_unit.size()]});
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
      return fail(FaultKind::text, fmt::format("--{} is of the speeds that you give.", option), {},
                  "Add --cut-speed or --travel-speed.");
  return {};
}

Result<> read_pen_axis(const Given& given, double per_unit, ConversionOptions& o) {
  if (!given.has("pen-axis")) return {};
  const std::vector<std::string> parts = split(given.one("pen-axis"), ':');
  const auto down = parts.size() == 3 ? number_in(parts[1]) : std::nullopt;
  const auto up = parts.size() == 3 ? number_in(parts[2]) : std::nullopt;
  if (!down || !up) return wrong("pen-axis", given, "AXIS:DOWN:UP");
  const std::size_t place = o.axes.size();
  o.axes.push_back({parts[0], per_unit});
  for (auto [to, routine] : {std::pair{*down, &o.pen_down}, std::pair{*up, &o.pen_up}}) {
    sequence::Move move;
    move.to[place] = to;
    routine->push_back({move});
    routine->push_back({sequence::WaitMotion{static_cast<int>(place)}});
  }
  return {};
}

/// The tool's delays: separate ones for each direction, else the same.
Result<> read_pen_delays(const Given& given, ConversionOptions& o) {
  const auto both = given.number("pen-delay", 0, 0, 1e6);
  if (!both) return fail(both.error());
  for (auto [option, routine] :
       {std::pair{"pen-down-delay", &o.pen_down}, std::pair{"pen-up-delay", &o.pen_up}}) {
    const auto delay = given.number(option, *both, 0, 1e6);
    if (!delay) return fail(delay.error());
    if (*delay > 0) routine->push_back({sequence::Delay{*delay}});
  }
  return {};
}

Result<> read_routines(const Given& given, const Catalog& catalog, double per_unit, ConversionOptions& o) {
  for (const char* other : {"pen-output", "pen-axis", "pen-delay", "pen-down-delay", "pen-up-delay"})
    if (given.has(other))
      return fail(FaultKind::text, fmt::format("--{} and --pen-down or --pen-up say the same.", other), {},
                  "Write one of them.");
  for (auto [option, routine] : {std::pair{"pen-down", &o.pen_down}, std::pair{"pen-up", &o.pen_up}}) {
    auto read = read_routine(
        given.one(option), catalog, [=](const std::string&) { return per_unit; }, o.axes);
    if (!read) {
      read.error().what = fmt::format("--{}: {}", option, read.error().what);
      return fail(read.error());
    }
    *routine = std::move(*read);
  }
  return switches_back(o.pen_down, o.pen_up, catalog);
}

// An output, an axis, and a delay: down in this order, up likewise.
Result<> read_pen(const Given& given, const Catalog& catalog, ConversionOptions& o) {
  double per_unit = o.axes.front().per_unit;
  if (given.has("pen-per-unit")) {
    const auto read = given.number("pen-per-unit", per_unit, 1e-9, 1e12);
    if (!read) return fail(read.error());
    per_unit = *read;
  }
  if (given.has("pen-down") || given.has("pen-up")) return read_routines(given, catalog, per_unit, o);
  if (given.has("pen-output")) {
    const auto number = given.number("pen-output", 0, 0, 64);
    if (!number) return fail(number.error());
    o.pen_down.push_back({sequence::Output{static_cast<int>(*number), true}});
    o.pen_up.push_back({sequence::Output{static_cast<int>(*number), false}});
  }
  if (auto axis = read_pen_axis(given, per_unit, o); !axis) return axis;
  return read_pen_delays(given, o);
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
