// Converts a drawing to a program, or a sequence, without a window.
#include <algorithm>
#include <cmath>
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
#include "gui/app/cmd_convert_options.h"
#include "gui/app/output.h"
#include "gui/app/program_file.h"
#include "gui/app/wiring.h"

namespace hw::app {
namespace {

/// --id 01-02 names controllers of one axis each that share a wire and draw together. They have no program
/// language.
Result<TargetController> read_target(const Given& given) {
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
    return fail(FaultKind::text, "Several controllers cannot share one program.", {},
                "Write the sequence: -o OUT.toml. A script runs it with bus:run_in_pieces(text).");
  return TargetController{nullptr, std::move(*together)};
}

/// Writes the program text if there is a language; otherwise only checks that the sequence can be drawn.
Result<SequenceText> write(const sequence::Sequence& sequence, const TargetController& meant) {
  if (meant.language) return meant.language->write(sequence, meant.catalog);
  const auto parts = pieces_together(sequence, meant.catalog, 0);
  if (!parts) return fail(parts.error());
  SequenceText none;
  auto tool = tool_remark(sequence, meant.catalog);
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
      return fail(FaultKind::port, fmt::format("--without {}: the file draws no such entity.", entity));
  }
  return {};
}

/// Time in seconds that the order saves on moves with the tool off; nullopt: their speed is not known.
std::optional<double> saved_seconds(const Conversion& c, const ConversionOptions& o) {
  if (!(o.travel.high > 0)) return std::nullopt;
  return (c.way_as_drawn - c.way) / o.travel.high;
}

struct Made {
  Conversion conversion;
  std::optional<double> saved_s;
  SequenceText written;
  const drawing::Drawing& drawing;
  std::string read_in;  ///< the unit assumed
  Rehearsal rehearsal;
  std::vector<drawing::HiddenLayer> hidden;  ///< not requested by the user
  std::vector<std::string> problems;         ///< why the program does not fit, such as too little memory
};

/// The layers left out. Empty when the user has named layers, because the others are then left out on
/// purpose.
std::vector<drawing::HiddenLayer> layers_left_out(const drawing::Drawing& drawing,
                                                  const ConversionOptions& o) {
  if (!o.layers.empty()) return {};
  return hidden_layers(drawing);
}

/// The entities of a box around all others, which may be a margin.
std::vector<int> box_around(const Made& m) {
  std::vector<int> entities;
  const Conversion& c = m.conversion;
  if (c.box_around < 0) return entities;
  for (const int path : c.chains[static_cast<std::size_t>(c.box_around)].paths)
    entities.push_back(m.drawing.paths[static_cast<std::size_t>(path)].entity);
  std::sort(entities.begin(), entities.end());
  entities.erase(std::unique(entities.begin(), entities.end()), entities.end());
  return entities;
}

void print_json(const Made& m, const Catalog& catalog) {
  nlohmann::ordered_json out;
  const Conversion& c = m.conversion;
  out["model"] = catalog.model;
  out["unit"] = c.sequence.unit;
  out["file"] = {{"version", m.drawing.version}, {"unit", m.drawing.unit}, {"read_in", m.read_in}};
  out["chains"] = c.chains.size();
  out["drawn"] = c.drawn;
  out["travel"] = {{"as_drawn", c.way_as_drawn},
                   {"ordered", c.way},
                   {"saved_s", m.saved_s ? nlohmann::ordered_json(*m.saved_s) : nullptr}};
  out["box"] = {c.box.low.x, c.box.low.y, c.box.high.x, c.box.high.y};
  out["tolerance"] = c.tolerance;
  out["box_around"] = box_around(m);
  out["steps"] = count_steps(c.sequence.steps);
  out["lines"] = m.written.step_of_line.size();
  out["duration_s"] = m.rehearsal.finished ? nlohmann::ordered_json(m.rehearsal.duration_s) : nullptr;
  out["off_the_table"] = c.off_the_table.size();
  out["remarks"] = m.written.remarks;
  out["tool"] = m.written.tool;
  out["problems"] = m.problems;
  const auto list = [&out](const char* name, const std::vector<drawing::LeftOut>& entities) {
    out[name] = nlohmann::ordered_json::array();
    for (const drawing::LeftOut& l : entities) {
      out[name].push_back({{"what", l.what}, {"why", l.why}, {"entity", l.entity}, {"line", l.line}});
      if (l.at) out[name].back()["at"] = {l.at->x, l.at->y};
    }
  };
  list("left_out", m.drawing.left_out), list("understood", m.drawing.understood);
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
  if (c.way_as_drawn - c.way >= 0.0005) {
    print_result("the order saves {:.3f} {}", c.way_as_drawn - c.way, c.sequence.unit);
    if (m.saved_s)
      print_result(", {:.1f} s", *m.saved_s);
    else
      print_result("; --cut-speed and --travel-speed add the time");
    print_result("\n");
  }
  const auto place = [](double v) { return std::fabs(v) < 0.0005 ? 0.0 : v; };  // no "-0.000"
  print_result("from {:.3f}, {:.3f} to {:.3f}, {:.3f} {}\n", place(c.box.low.x), place(c.box.low.y),
               place(c.box.high.x), place(c.box.high.y), c.sequence.unit);
  if (const std::vector<int> box = box_around(m); !box.empty()) {
    print_result("a box surrounds everything else, perhaps a margin: omit it with");
    for (const int entity : box) print_result(" --without {}", entity);
    print_result("\n");
  }
  print_result("{} steps, {} lines", count_steps(c.sequence.steps), m.written.step_of_line.size());
  if (m.rehearsal.finished) print_result(", {:.3f} s", m.rehearsal.duration_s);
  print_result("\n");
}

}  // namespace

/// Works out the duration in pieces, after power-up and on a wire of usual speed.
static void rehearse(const Pieces& pieces, const Catalog& catalog, Made& made) {
  constexpr Duration at_most = std::chrono::hours(1);
  std::string address = fmt::format("{}@emulator,wire=real", catalog.model);
  for (const auto& [option, value] : catalog.made_from) address += fmt::format(",{}={}", option, value);
  const auto alone = Address::parse(address);
  if (!alone) return;
  const auto done =
      rehearse_pieces(std::make_shared<const Pieces>(pieces), *alone, {}, wire_opener(), at_most);
  if (!done || !done->finished) return;
  made.rehearsal.finished = true, made.rehearsal.duration_s = done->duration_s;
}

/// Says where a drawing that the controller cannot hold can be drawn instead.
static std::string elsewhere(Made& made, const TargetController& meant) {
  const auto pieces = meant.language->in_pieces(made.conversion.sequence, meant.catalog);
  if (!pieces) return "It cannot be drawn in pieces either: " + pieces.error().sentence();
  rehearse(*pieces, meant.catalog, made);
  return fmt::format(
      "It can be drawn in {} piece{}: from the console (Drawing, Cut), or as a sequence (-o OUT.toml) by a "
      "script with c:run_in_pieces(text).",
      pieces->all.size(), pieces->all.size() == 1 ? "" : "s");
}

static void try_it(Made& made, const TargetController& meant) {
  for (const Problem& p : meant.language->analyse(made.written.text, 0).problems) {
    if (!p.error) continue;
    made.problems.push_back(p.sentence);
  }
  if (!made.problems.empty()) {
    made.problems.push_back(elsewhere(made, meant));
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
  if (done && done->finished) {
    made.rehearsal.finished = true;
    made.rehearsal.duration_s = done->duration_s;
    return;
  }
  made.written.remarks.push_back(done ? "It takes more than ten hours."
                                      : "It was not rehearsed: " + done.error().sentence());
  write_aside(made.written.remarks.back());
}

/// Reports parts left out without the user's request.
static void report_left_out(const std::string& path, const drawing::Drawing& drawing,
                            const std::vector<drawing::HiddenLayer>& hidden) {
  for (const drawing::LeftOut& l : drawing.left_out)
    write_aside(fmt::format("{}:{}: {} {}{} was left out: {}", path, l.line, l.what, l.entity,
                            l.at ? fmt::format(" at {:.6g}, {:.6g}", l.at->x, l.at->y) : std::string(),
                            l.why));
  for (const drawing::LeftOut& l : drawing.understood)
    write_aside(fmt::format("{}:{}: {} {}: {}", path, l.line, l.what, l.entity, l.why));
  for (const drawing::HiddenLayer& l : hidden)
    write_aside(
        fmt::format("{}: layer \"{}\" was left out with {} entit{}: it is frozen or off in the file. --layer "
                    "\"{}\" draws it.",
                    path, l.name, l.entities, l.entities == 1 ? "y" : "ies", l.name));
}

/// Prints some of the remarks, because each chain may have one; the report has the rest.
static void print_remarks(const std::vector<std::string>& remarks) {
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(most, remarks.size()); ++i) write_aside(remarks[i]);
  if (const std::size_t more = remarks.size() - std::min(most, remarks.size()); more > 0)
    write_aside(fmt::format("And {} more remark{}; --json lists all.", more, more == 1 ? "" : "s"));
}

/// Reports values that were assumed or that differ from the file.
static void report_assumed(const Given& given, const drawing::Drawing& drawing, const Catalog& catalog) {
  if (!given.has("per-unit") && !given.has("step-length") && !given.has("profile"))
    write_aside(fmt::format("--per-unit was not given: 1 is assumed ({} per {}).", catalog.step_word,
                            given.has("inch") ? "in" : "mm"));
  if (given.has("unit") && !drawing.unit.empty() && drawing.unit != given.one("unit"))
    write_aside(fmt::format("The file is in {}. It is read in {}, because of --unit.", drawing.unit,
                            given.one("unit")));
}

/// Writes the program, unless the controller cannot hold it.
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
  const auto meant = read_target(given);
  if (!meant) return complain(meant.error(), status_of(meant.error()));
  auto options = read_conversion(given, meant->catalog);
  if (!options) return complain(options.error(), usage);
  if (!given.has("output")) return complain("Add -o OUT: no output file is named.", usage);
  const std::string& path = given.words[0];
  const auto drawing = read_drawing(path, meant->catalog, *options);
  if (!drawing) return complain(drawing.error());
  const auto hidden = layers_left_out(*drawing, *options);
  report_left_out(path, *drawing, hidden);
  report_assumed(given, *drawing, meant->catalog);
  if (auto found = leave_out(*drawing, given, *options); !found) return complain(found.error());
  auto converted = convert(*drawing, meant->catalog, *options);
  if (!converted) return complain(converted.error());
  if (given.has("frame")) converted->sequence = converted->frame;
  auto written = write(converted->sequence, *meant);
  if (!written) return complain(written.error());
  print_remarks(written->remarks);
  if (!written->tool.empty()) write_aside(written->tool);
  if (!converted->off_the_table.empty())
    write_aside(fmt::format("{} of {} chains leave the table.", converted->off_the_table.size(),
                            converted->chains.size()));
  const auto saved = saved_seconds(*converted, *options);
  Made made{std::move(*converted),
            saved,
            std::move(*written),
            *drawing,
            unit_of(*drawing, *options),
            {},
            hidden,
            {}};
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
    "turn a drawing into a program",
    {{"IN.dxf", "the drawing", 1, 1}},
    {model_option,
     {"output", "OUT", "the program; OUT.toml: the sequence", false, "o"},
     {"unit", "UNIT", "of the drawing, instead of its own: mm, in, cm ..."},
     {"times", "N", "scale relative to the file (1)"},
     {"inch", "", "lengths of these options are inches, not mm"},
     {"layer", "NAME", "only this layer, also where it is frozen or off", true},
     {"without", "N", "not entity N of the file (1, 2 ...), as a margin", true},
     {"axes", "X,Y", "the axes that draw"},
     {"per-unit", "N[,N]", "steps of an axis in a mm (1)"},
     {"step-length", "D[,D]", "instead: length of a step in mm"},
     {"profile", "ADDRESS", "instead: the units that the console keeps for this controller"},
     {"origin", "WHERE", "as-drawn, lower-left, or X,Y of the drawing"},
     {"swap", "", "the drawing's X goes along the second axis"},
     {"mirror", "x|y|xy", "axes to be mirrored"},
     {"table", "X0,Y0,X1,Y1", "reach of the tool, to be checked"},
     {"frame", "", "only once around it, with the tool up"},
     {"join", "D", "ends closer than this are joined"},
     {"tolerance", "D", "of chords and staircases"},
     {"keep-order", "", "draw in the order of the file"},
     {"cut-speed", "V", "per second, with the tool down"},
     {"travel-speed", "V", "per second, with the tool up"},
     {"low-speed", "V", "speed at which ramps begin"},
     {"ramp", "MS", "duration of a ramp"},
     {"pen-output", "N", "is on while the tool is down"},
     {"pen-axis", "A:DOWN:UP", "moves the tool down and up"},
     {"pen-per-unit", "N", "steps of that axis in a mm, where it has others"},
     {"pen-delay", "MS", "wait until the tool has acted"},
     {"pen-down-delay", "MS", "the same, only down"},
     {"pen-up-delay", "MS", "the same, only up"},
     {"pen-down", "STEPS", "instead: \"Z to -2, DO1 on, wait 250\""},
     {"pen-up", "STEPS", "and the same to lift it"},
     {"variant", "V", "of the controller"},
     {"motors", "N", "of a VXM: 3 or 4 with a Slave"},
     {"id", "IDS", "01-02: these draw together, an axis each"},
     {"json", "", "a report as JSON"}},
    convert_drawing,
};

}  // namespace hw::app
