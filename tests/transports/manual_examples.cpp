#include "tests/transports/manual_examples.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "core/base/toml.h"

namespace hw::test {
namespace {

constexpr std::array known_keys = {"name",  "at",      "number",   "same_as", "why_not", "text",
                                   "file",  "slot",    "seconds",  "hands",   "keys",    "stands",
                                   "power", "outputs", "programs", "set",     "moved"};

tl::unexpected<Fault> fault_in(std::string_view model, const std::string& what) {
  return fail(FaultKind::text, fmt::format("{}.toml: {}", model, what));
}

std::string text_at(const toml::table& entry, std::string_view key) {
  return entry[key].value_or(std::string());
}

/// What is done on the controller before the program, in this order.
std::vector<IntentBody> done_before(const toml::table& entry) {
  std::vector<IntentBody> all;
  if (entry["power"].value_or(false)) all.emplace_back(intent::SetPower(-1, true));
  if (const toml::table* values = entry["set"].as_table())
    for (const auto& [mnemonic, value] : *values)
      all.emplace_back(intent::SetParam(std::string(mnemonic.str()), value.value_or(std::int64_t{0}), true));
  if (const toml::array* places = entry["moved"].as_array()) {
    std::vector<AxisTarget> targets;
    for (const toml::node& place : *places) {
      AxisTarget target;
      target.axis = AxisId{static_cast<std::uint8_t>(targets.size())};
      target.value = Steps(place.value_or(std::int64_t{0}));
      targets.push_back(target);
    }
    all.emplace_back(intent::MoveTo(std::move(targets)));
  }
  if (const toml::array* on = entry["outputs"].as_array())
    for (const toml::node& output : *on) all.emplace_back(intent::SetOutput(output.value_or(0), true));
  return all;
}

Result<ManualExample> read_example(const toml::table& entry) {
  for (const auto& [key, value] : entry)
    if (std::ranges::find(known_keys, key.str()) == known_keys.end())
      return fail(FaultKind::text, fmt::format("nobody knows the key {}", key.str()));
  ManualExample example;
  example.name = text_at(entry, "name"), example.at = text_at(entry, "at");
  example.number = entry["number"].value_or(0);
  example.same_as = text_at(entry, "same_as"), example.why_not = text_at(entry, "why_not");
  AgreementCase& run = example.run;
  run.name = example.name;
  run.text = entry.contains("file") ? "@" + text_at(entry, "file") : text_at(entry, "text");
  run.slot = entry["slot"].value_or(0);
  run.seconds = entry["seconds"].value_or(run.seconds);
  run.bench = text_at(entry, "hands"), run.stands = text_at(entry, "stands");
  run.keys = text_at(entry, "keys");
  run.before = done_before(entry);
  if (const toml::table* programs = entry["programs"].as_table())
    for (const auto& [slot, text] : *programs)
      run.programs.emplace_back(std::stoi(std::string(slot.str())), text.value_or(std::string()));
  return example;
}

}  // namespace

Result<Manual> read_manual(std::string_view model) {
  std::ifstream file(fmt::format("{}/transports/examples/{}.toml", HW_TEST_DIR, model));
  std::stringstream all;
  all << file.rdbuf();
  if (!file) return fault_in(model, "it cannot be read");
  const auto parsed = toml::parse(all.str());
  if (!parsed)
    return fault_in(
        model, fmt::format("line {}: {}", parsed.error().source().begin.line, parsed.error().description()));
  Manual manual;
  manual.numbered = parsed.table()["numbered"].value_or(0);
  const toml::array* entries = parsed.table()["example"].as_array();
  if (entries == nullptr) return fault_in(model, "it holds no example");
  for (const toml::node& node : *entries) {
    if (!node.is_table()) return fault_in(model, "an example is not a table");
    auto example = read_example(*node.as_table());
    if (!example)
      return fault_in(model, fmt::format("line {}: {}", node.source().begin.line, example.error().what));
    manual.examples.push_back(std::move(*example));
  }
  return manual;
}

std::vector<AgreementCase> cases_of_manual(std::string_view model) {
  std::vector<AgreementCase> all;
  const auto manual = read_manual(model);
  if (!manual) return all;
  for (const ManualExample& example : manual->examples)
    if (example.is_run()) all.push_back(example.run);
  return all;
}

}  // namespace hw::test
