#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "core/base/shown_text.h"
#include "core/device/controller_state.h"
#include "core/emulation/bench_file.h"
#include "core/session/parameter_file.h"
#include "core/session/text_file.h"
#include "core/session/user_files.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/program_file.h"

namespace hw::app {
namespace {

// Sorted by number: 8, 9, 10.
std::vector<std::pair<std::string, int>> in_order(const std::map<std::string, int>& outputs) {
  std::vector<std::pair<std::string, int>> all(outputs.begin(), outputs.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first.size() < b.first.size(); });
  return all;
}

using Json = nlohmann::ordered_json;

// Adds findings beyond the contract, if there are any.
void add_findings(Json& out, const Rehearsal& r) {
  if (r.endless) out["endless"] = true;
  for (const RehearsedStop& stop : r.stops) {
    Json s;
    s["t"] = stop.t;
    s["line"] = stop.line < 0 ? Json(nullptr) : Json(stop.line + 1);
    if (stop.direction != 0) s["axis"] = stop.axis, s["direction"] = stop.direction;
    s["reason"] = stop.reason;
    out["stops"].push_back(std::move(s));
  }
  for (const RehearsedAssumption& a : r.assumptions) out["assumptions"][a.name] = a.value;
}

// Prints the object of the contract, with its keys in the contract's order.
void print_json(const Rehearsal& r, const Catalog& catalog) {
  Json out;
  out["model"] = catalog.model;
  out["duration_s"] = r.duration_s;
  out["finished"] = r.finished;
  out["error"] = r.error.empty() ? Json(nullptr) : Json(r.error);
  out["axes"] = Json::object();
  for (const RehearsedAxis& axis : r.axes) {
    Json& a = out["axes"][axis.name];
    a["position"] = axis.position;
    a["min"] = axis.minimum;
    a["max"] = axis.maximum;
    a["travel"] = axis.travel;
  }
  out["outputs"] = Json::object();
  for (const auto& [name, on] : in_order(r.outputs)) out["outputs"][name] = on;
  out["sent_to_host"] = r.sent_to_host;
  Json& size = out["program_" + catalog.program.capacity_unit] = Json::object();
  for (const auto& [slot, count] : r.program_size) size[slot] = count;
  out["events"] = Json::array();
  for (const RehearsedEvent& event : r.events) {
    Json e;
    e["t"] = event.t;
    e["what"] = event.what;
    out["events"].push_back(std::move(e));
  }
  add_findings(out, r);
  print_result("{}\n", out.dump(-1, ' ', true, Json::error_handler_t::replace));
}

/// The object that has the size: the whole text, if programs run in threads or none is stored.
std::string what_has_size(const ProgramFacts& facts, const std::string& slot) {
  const bool one_text = facts.threads > 0 || facts.slots <= 1;
  return one_text ? "whole text" : fmt::format("{} {}", facts.slot_word, slot);
}

/// "24 lines of 1275"
std::string memory_words(const ProgramFacts& facts, int size) {
  const std::string all = facts.capacity > 0 ? fmt::format(" of {}", facts.capacity) : "";
  return fmt::format("{} {}{}", size, facts.capacity_unit, all);
}

void print_words(const Rehearsal& r, const Catalog& catalog) {
  if (r.finished)
    print_result("ends after {:.3f} s\n", r.duration_s);
  else if (r.error.empty())
    print_result("still runs after {:.3f} s\n", r.duration_s);
  if (!r.error.empty()) print_result("stopped after {:.3f} s: {}\n", r.duration_s, shown_text(r.error, 1000));
  for (const RehearsedAxis& a : r.axes)
    print_result("axis {}: ends at {}, between {} and {}, travel {} {}\n", a.name, a.position, a.minimum,
                 a.maximum, a.travel, a.in_counts ? catalog.loop_word : catalog.step_word);
  if (r.assumptions.empty()) print_result("begins as after power-up, with factory settings\n");
  print_result("limits, beginning at 0: {}\n", r.limit_touched ? "touched" : "none touched");
  for (const RehearsedStop& stop : r.stops)
    if (stop.reason != r.error)
      print_result("{:.3f} s{}: {}\n", stop.t, stop.line < 0 ? "" : fmt::format(", line {}", stop.line + 1),
                   stop.reason);
  for (const RehearsedAssumption& a : r.assumptions) print_result("assumed: {} {}\n", a.name, a.value);
  for (const auto& [name, on] : in_order(r.outputs)) print_result("output {}: {}\n", name, on ? "on" : "off");
  for (const auto& [slot, size] : r.program_size)
    print_result("{}: {}\n", what_has_size(catalog.program, slot), memory_words(catalog.program, size));
  for (const RehearsedEvent& e : r.events) print_result("{:10.3f} s  {}\n", e.t, e.what);
}

// Reads a bench file. Its errors are reported under its name, before the program runs.
Result<std::string> read_bench(const std::string& path, const Catalog& catalog) {
  auto text = read_file(path, largest_program_text);
  if (!text) return text;
  if (auto parsed = parse_bench_file(*text, catalog, path); !parsed) return fail(parsed.error());
  return text;
}

// Reads a backup, which contains neither positions nor lines.
Result<std::shared_ptr<const ControllerState>> read_like(const std::string& path, const Catalog& catalog) {
  const auto backup = load_backup(path);
  if (!backup) return fail(backup.error());
  const auto checked = check_backup(*backup, catalog, path);
  if (!checked) return fail(checked.error());
  if (!checked->problems.empty())
    return fail(FaultKind::text, checked->problems.front(), "Nothing was rehearsed.");
  auto state = std::make_shared<ControllerState>();
  state->now.axis_count = static_cast<int>(catalog.axes.size());
  for (const ParameterEntry& entry : checked->parameters) {
    ParamState& param = state->now.params[static_cast<std::size_t>(catalog.find_param(entry.mnemonic))];
    param.value = entry.value, param.known = true;
  }
  for (const auto& [number, value] : checked->variables) {
    state->now.variables[static_cast<std::size_t>(number)] = static_cast<std::int32_t>(value);
    state->now.variables_known.set(static_cast<std::size_t>(number));
  }
  state->programs = checked->programs;
  return state;
}

// The result for a text that cannot be run, with the reason. Axes and outputs are in their state before any
// action.
Rehearsal nothing_rehearsed(const ProgramFile& program, const Fault& why) {
  Rehearsal r;
  RehearseOptions options;
  options.device = program.catalog.made_from;
  if (auto idle = program.language->rehearse("", options)) r.axes = idle->axes, r.outputs = idle->outputs;
  r.error = why.sentence();
  for (const auto& [slot, cost] : program.language->analyse(program.text, 0).cost)
    r.program_size[std::to_string(slot)] = cost;
  return r;
}

/// Why the exit status reports a failure; empty: the program works to its end.
std::string why_not_good(const Rehearsal& r, bool strict) {
  if (!r.error.empty()) return r.error;
  if (!r.finished) return fmt::format("The program still runs after {:.3f} s.", r.duration_s);
  if (!strict) return {};
  for (const RehearsedStop& stop : r.stops)
    if (stop.direction != 0) return stop.reason;
  return r.limit_touched ? "A limit switch is hit." : "";
}

}  // namespace

static int simulate(const Given& given) {
  const auto for_seconds = given.number("for-seconds", 3600, 0.001, 1e7);
  if (!for_seconds) return complain(for_seconds.error(), usage);
  const auto program = read_program(given);
  if (!program) return complain(program.error(), status_of(program.error()));

  const ProgramFacts& facts = program->catalog.program;
  const int programs = facts.threads > 0 ? facts.threads : facts.slots;
  const auto number = given.number("program", 0, 0, std::max(programs - 1, 0));
  if (!number) return complain(number.error(), usage);

  RehearseOptions options;
  options.for_seconds = *for_seconds;
  options.slot = static_cast<int>(*number);
  options.device = program->catalog.made_from;
  if (given.has("bench")) {
    auto bench = read_bench(given.one("bench"), program->catalog);
    if (!bench) return complain(bench.error());
    options.bench_toml = std::move(*bench);
  }
  if (given.has("like")) {
    auto like = read_like(given.one("like"), program->catalog);
    if (!like) return complain(like.error());
    options.from = std::move(*like);
  }
  const auto rehearsed = program->language->rehearse(program->text, options);
  if (!rehearsed) {
    if (given.has("json")) print_json(nothing_rehearsed(*program, rehearsed.error()), program->catalog);
    return complain(rehearsed.error());
  }
  if (given.has("json"))
    print_json(*rehearsed, program->catalog);
  else
    print_words(*rehearsed, program->catalog);
  const std::string why = why_not_good(*rehearsed, given.has("strict"));
  return why.empty() ? done : complain(why);
}

const Subcommand simulate_subcommand{
    "simulate",
    "dry run of a program, in virtual time",
    {{"FILE", "the program", 1, 1}},
    {model_option,
     variant_option,
     jumpers_option,
     json_option,
     {"program", "N", "the one that is started (default 0); it may start others"},
     bench_option,
     {"like", "FILE.toml", "begin with the parameters, variables and other programs of this backup"},
     {"strict", "", "end with status 1 when a limit is hit as well"},
     {"for-seconds", "N", "stop a program that does not end by then (default 3600, simulated)"}},
    simulate,
};

}  // namespace hw::app
