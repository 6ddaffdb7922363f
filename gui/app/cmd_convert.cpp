// A drawing becomes a program, or a sequence, without a window.
#include <charconv>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "core/device/pieces_together.h"
#include "core/device/registry.h"
#include "core/device/sequence_draft.h"
#include "core/drawing/dxf_reader.h"
#include "core/sequence/sequence_file.h"
#include "core/session/address.h"
#include "core/session/conversion.h"
#include "core/session/rehearse_together.h"
#include "core/session/user_files.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/program_file.h"
#include "gui/app/wiring.h"

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
  return {};
}

// An output, an axis, and time for it to act: down in this order, up likewise.
Result<> read_pen(const Given& given, ConversionOptions& o) {
  if (given.has("pen-output")) {
    const auto number = given.number("pen-output", 0, 0, 64);
    if (!number) return fail(number.error());
    o.pen_down.push_back({sequence::Output{static_cast<int>(*number), true}});
    o.pen_up.push_back({sequence::Output{static_cast<int>(*number), false}});
  }
  if (given.has("pen-axis")) {
    const std::vector<std::string> parts = split(given.one("pen-axis"), ':');
    const auto down = parts.size() == 3 ? number_in(parts[1]) : std::nullopt;
    const auto up = parts.size() == 3 ? number_in(parts[2]) : std::nullopt;
    if (!down || !up) return wrong("pen-axis", given, "AXIS:DOWN:UP");
    const std::size_t place = o.axes.size();
    o.axes.push_back({parts[0], o.axes.front().per_unit});
    for (auto [to, routine] : {std::pair{*down, &o.pen_down}, std::pair{*up, &o.pen_up}}) {
      sequence::Move move;
      move.to[place] = to;
      routine->push_back({move});
      routine->push_back({sequence::WaitMotion{static_cast<int>(place)}});
    }
  }
  const auto delay = given.number("pen-delay", 0, 0, 1e6);
  if (!delay) return fail(delay.error());
  if (*delay > 0)
    for (sequence::StepList* routine : {&o.pen_down, &o.pen_up})
      routine->push_back({sequence::Delay{*delay}});
  return {};
}

Result<ConversionOptions> read_options(const Given& given, const Catalog& catalog) {
  ConversionOptions o;
  o.unit = given.has("inch") ? "in" : "mm";
  o.drawing_unit = given.one("unit");
  o.layers = given.all("layer");
  o.keep_order = given.has("keep-order");
  if (auto read = read_axes(given, catalog, o); !read) return fail(read.error());
  if (auto read = read_placing(given, o); !read) return fail(read.error());
  if (auto read = read_speeds(given, o); !read) return fail(read.error());
  if (auto read = read_pen(given, o); !read) return fail(read.error());
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

/// --id 01-02: controllers of one axis each that share a wire and draw together. No language is theirs.
Result<MeantFor> read_who_draws(const Given& given) {
  auto meant = read_for(given);
  if (!meant || !given.has("id")) return meant;
  const auto address = Address::parse(fmt::format("{}@emulator,id={}", given.one("for"), given.one("id")));
  if (!address) return fail(address.error());
  std::vector<Catalog> catalogs;
  for (const Address& device : address->devices()) {
    auto catalog = find_device_type(device.model)->make_catalog(device.options);
    if (!catalog) return fail(catalog.error());
    catalogs.push_back(std::move(*catalog));
  }
  std::vector<const Catalog*> all;
  for (const Catalog& catalog : catalogs) all.push_back(&catalog);
  auto together = catalog_together(all);
  if (!together)
    return fail(
        FaultKind::text,
        fmt::format("--id {}: only several controllers of one axis each draw together.", given.one("id")), {},
        "Write --for dmx-k-sa --id 01-02, for instance.");
  if (!given.one("output").ends_with(".toml"))
    return fail(FaultKind::text, "Several controllers have no one program.", {},
                "Write the sequence: -o OUT.toml. A script runs it with bus:run_in_pieces(text).");
  return MeantFor{nullptr, std::move(*together)};
}

/// The text of it where there is one; at least, that it can be done.
Result<SequenceText> write(const sequence::Sequence& sequence, const MeantFor& meant) {
  if (meant.language) return meant.language->write(sequence, meant.catalog);
  const auto parts = pieces_together(sequence, meant.catalog, 0);
  if (!parts) return fail(parts.error());
  SequenceText none;
  auto tool = said_of_tool(sequence, meant.catalog);
  if (!tool) return fail(tool.error());
  none.tool = std::move(*tool);
  none.remarks.push_back(parts->front().remark);
  return none;
}

Result<> leave_out(const drawing::Drawing& drawing, const Given& given, ConversionOptions& o) {
  for (const std::string& entity : given.all("without")) {
    const std::size_t before = o.without.size();
    for (std::size_t i = 0; i < drawing.paths.size(); ++i)
      if (std::to_string(drawing.paths[i].entity) == entity) o.without.push_back(static_cast<int>(i));
    if (o.without.size() == before)
      return fail(FaultKind::port,
                  fmt::format("--without {}: the file has no such entity that is drawn.", entity));
  }
  return {};
}

struct Made {
  Conversion conversion;
  SequenceText written;
  const drawing::Drawing& drawing;
  Rehearsal rehearsal;
  std::vector<drawing::HiddenLayer> hidden;  ///< that nobody has asked for
  std::vector<std::string> problems;         ///< of the program: it is too large for its memory
};

/// Whoever names layers knows that the others are left out.
std::vector<drawing::HiddenLayer> layers_left_out(const drawing::Drawing& drawing,
                                                  const ConversionOptions& o) {
  if (!o.layers.empty()) return {};
  return hidden_layers(drawing);
}

void print_json(const Made& m, const Catalog& catalog) {
  nlohmann::ordered_json out;
  const Conversion& c = m.conversion;
  out["model"] = catalog.model;
  out["unit"] = c.sequence.unit;
  out["chains"] = c.chains.size();
  out["drawn"] = c.drawn;
  out["travel"] = {{"as_drawn", c.way_as_drawn}, {"ordered", c.way}};
  out["box"] = {c.box.low.x, c.box.low.y, c.box.high.x, c.box.high.y};
  out["tolerance"] = c.tolerance;
  out["steps"] = count_steps(c.sequence.steps);
  out["lines"] = m.written.step_of_line.size();
  out["duration_s"] = m.rehearsal.finished ? nlohmann::ordered_json(m.rehearsal.duration_s) : nullptr;
  out["off_the_table"] = c.off_the_table.size();
  out["remarks"] = m.written.remarks;
  out["tool"] = m.written.tool;
  out["problems"] = m.problems;
  out["left_out"] = nlohmann::ordered_json::array();
  for (const drawing::LeftOut& l : m.drawing.left_out)
    out["left_out"].push_back({{"what", l.what}, {"why", l.why}, {"entity", l.entity}, {"line", l.line}});
  out["hidden_layers"] = nlohmann::ordered_json::array();
  for (const drawing::HiddenLayer& l : m.hidden)
    out["hidden_layers"].push_back({{"layer", l.name}, {"entities", l.entities}});
  print_result("{}\n", out.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace));
}

void print_words(const Made& m) {
  const Conversion& c = m.conversion;
  print_result("{} chain{}, {:.3f} {} drawn, {:.3f} {} between them ({:.3f} as drawn)\n", c.chains.size(),
               c.chains.size() == 1 ? "" : "s", c.drawn, c.sequence.unit, c.way, c.sequence.unit,
               c.way_as_drawn);
  print_result("from {:.3f}, {:.3f} to {:.3f}, {:.3f} {}\n", c.box.low.x, c.box.low.y, c.box.high.x,
               c.box.high.y, c.sequence.unit);
  print_result("{} steps, {} lines", count_steps(c.sequence.steps), m.written.step_of_line.size());
  if (m.rehearsal.finished) print_result(", {:.3f} s", m.rehearsal.duration_s);
  print_result("\n");
}

}  // namespace

/// Of what the controller cannot hold: where it can be drawn all the same.
static std::string elsewhere(const sequence::Sequence& sequence, const MeantFor& meant) {
  const auto pieces = meant.language->in_pieces(sequence, meant.catalog);
  if (!pieces) return "It cannot be drawn in pieces either: " + pieces.error().sentence();
  return fmt::format(
      "It can be drawn in {} piece{}: from the console (Drawing, Cut), or as a sequence (-o OUT.toml) by a "
      "script with c:run_in_pieces(text).",
      pieces->all.size(), pieces->all.size() == 1 ? "" : "s");
}

static void try_it(Made& made, const MeantFor& meant) {
  for (const Problem& p : meant.language->analyse(made.written.text, 0).problems) {
    if (!p.error) continue;
    made.problems.push_back(p.sentence);
  }
  if (!made.problems.empty()) {
    made.problems.push_back(elsewhere(made.conversion.sequence, meant));
    return;
  }
  RehearseOptions rehearse;
  rehearse.device = meant.catalog.made_from;
  if (auto done = meant.language->rehearse(made.written.text, rehearse)) made.rehearsal = std::move(*done);
}

static void try_together(Made& made, const Given& given) {
  constexpr Duration at_most = std::chrono::hours(10);
  const auto bus =
      Address::parse(fmt::format("{}@emulator,id={},wire=real", given.one("for"), given.one("id")));
  if (!bus) return;
  const auto done = rehearse_together(made.conversion.sequence, *bus, {}, wire_opener(), at_most);
  if (done) {
    made.rehearsal.finished = true;
    made.rehearsal.duration_s = done->duration_s;
    return;
  }
  made.written.remarks.push_back("It was not rehearsed: " + done.error().sentence());
  write_aside(made.written.remarks.back());
}

/// What the user did not ask to be left out.
static void tell_left_out(const std::string& path, const drawing::Drawing& drawing,
                          const std::vector<drawing::HiddenLayer>& hidden) {
  for (const drawing::LeftOut& l : drawing.left_out)
    write_aside(fmt::format("{}:{}: {} {} was left out: {}", path, l.line, l.what, l.entity, l.why));
  for (const drawing::HiddenLayer& l : hidden)
    write_aside(
        fmt::format("{}: layer \"{}\" was left out with {} entit{}: it is frozen or off in the file. --layer "
                    "\"{}\" draws it.",
                    path, l.name, l.entities, l.entities == 1 ? "y" : "ies", l.name));
}

/// What would not run is not written: a program that the controller cannot hold.
static int keep(const Made& made, const std::string& out) {
  const bool as_sequence = out.ends_with(".toml");
  for (const std::string& problem : made.problems) write_aside(problem);
  if (!made.problems.empty() && !as_sequence)
    return complain(fmt::format("{} was not written: the controller would not run it.", out));
  const auto kept =
      write_file(out, as_sequence ? write_sequence(made.conversion.sequence) : made.written.text);
  return kept ? done : complain(kept.error());
}

static int convert_drawing(const Given& given) {
  const auto meant = read_who_draws(given);
  if (!meant) return complain(meant.error(), status_of(meant.error()));
  auto options = read_options(given, meant->catalog);
  if (!options) return complain(options.error(), usage);
  if (!given.has("output")) return complain("It is not said where to write it. Add -o OUT.", usage);
  const std::string& path = given.words[0];
  const auto drawing = read_drawing(path, meant->catalog, *options);
  if (!drawing) return complain(drawing.error());
  const auto hidden = layers_left_out(*drawing, *options);
  tell_left_out(path, *drawing, hidden);
  if (auto found = leave_out(*drawing, given, *options); !found) return complain(found.error());
  auto converted = convert(*drawing, meant->catalog, *options);
  if (!converted) return complain(converted.error());
  if (given.has("frame")) converted->sequence = converted->frame;
  auto written = write(converted->sequence, *meant);
  if (!written) return complain(written.error());
  for (const std::string& remark : written->remarks) write_aside(remark);
  if (!written->tool.empty()) write_aside(written->tool);
  if (!converted->off_the_table.empty())
    write_aside(fmt::format("{} of {} chains leave the table.", converted->off_the_table.size(),
                            converted->chains.size()));
  Made made{std::move(*converted), std::move(*written), *drawing, {}, hidden, {}};
  if (meant->language)
    try_it(made, *meant);
  else
    try_together(made, given);
  const int status = keep(made, given.one("output"));
  if (given.has("json"))
    print_json(made, meant->catalog);
  else
    print_words(made);
  return status;
}

const Subcommand convert_subcommand{
    "convert",
    "make a program of a drawing",
    {{"IN.dxf", "the drawing", 1, 1}},
    {model_option,
     {"output", "OUT", "the program; OUT.toml: the sequence", false, "o"},
     {"unit", "UNIT", "of the drawing, where it does not say: mm, in, cm ..."},
     {"inch", "", "lengths of these options are inches, not mm"},
     {"layer", "NAME", "only this layer", true},
     {"without", "N", "not entity N of the file (1, 2 ...), as a margin", true},
     {"axes", "X,Y", "the axes that draw"},
     {"per-unit", "N[,N]", "steps of them in a mm"},
     {"origin", "WHERE", "as-drawn, lower-left, or X,Y of the drawing"},
     {"swap", "", "the drawing's X goes along the second axis"},
     {"mirror", "x|y|xy", "which ways it is turned round"},
     {"table", "X0,Y0,X1,Y1", "where the tool gets, to be checked"},
     {"frame", "", "only once around it, with the tool up"},
     {"join", "D", "ends so near are joined"},
     {"tolerance", "D", "of chords and staircases"},
     {"keep-order", "", "draw in the order of the file"},
     {"cut-speed", "V", "with the tool down, a second"},
     {"travel-speed", "V", "with the tool up"},
     {"low-speed", "V", "at which ramps begin"},
     {"ramp", "MS", "how long a ramp takes"},
     {"pen-output", "N", "is on while the tool is down"},
     {"pen-axis", "A:DOWN:UP", "moves the tool down and up"},
     {"pen-delay", "MS", "until the tool has acted"},
     {"variant", "V", "of the controller"},
     {"id", "IDS", "01-02: these draw together, an axis each"},
     {"json", "", "a report as JSON"}},
    convert_drawing,
};

}  // namespace hw::app
