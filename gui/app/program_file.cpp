#include "gui/app/program_file.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/shown_text.h"
#include "core/device/registry.h"
#include "core/sequence/sequence_file.h"
#include "core/session/address.h"
#include "core/session/text_file.h"
#include "gui/app/output.h"

namespace hw::app {

Result<Catalog> catalog_for(const DeviceType& type, const Given& given) {
  DeviceOptions keys;
  for (const char* key : {"variant", "jumpers", "motors"})
    if (given.has(key)) keys[key] = given.one(key);
  auto catalog = type.make_catalog(keys);
  if (!catalog || catalog->made_from.size() == keys.size()) return catalog;
  for (const auto& [key, value] : keys)
    if (catalog->made_from.find(key) == catalog->made_from.end())
      return fail(FaultKind::text, fmt::format("A {} has no --{}.", type.model, key));
  return catalog;
}

Result<TargetController> read_for(const Given& given) {
  if (!given.has("for"))
    return fail(FaultKind::text, "Nothing names the controller that the program is for.", {},
                fmt::format("Add --for MODEL ({}).", known_models()));
  const DeviceType* type = find_device_type(given.one("for"));
  if (!type) return fail(unknown_model(given.one("for")));
  if (!type->language)
    return fail(FaultKind::port, fmt::format("Programs for the {} are not understood yet.", type->model));
  auto catalog = catalog_for(*type, given);
  if (!catalog) return fail(catalog.error());
  return TargetController{&type->language(), std::move(*catalog)};
}

// A file that is not a program is a failed job, not wrong usage.
static Fault of_the_file(Fault fault) {
  fault.kind = FaultKind::port;
  return fault;
}

Result<ProgramFile> read_program(const Given& given) {
  auto meant = read_for(given);
  if (!meant) return fail(meant.error());
  auto file = load_text(given.words[0]);
  if (!file) return fail(of_the_file(file.error()));
  ProgramFile program;
  program.path = given.words[0];
  program.text = std::move(file->text);
  program.language = meant->language;
  program.catalog = std::move(meant->catalog);
  if (!sequence::looks_like_sequence(program.text)) return program;
  const auto sequence = sequence::read_sequence(program.text, program.path);
  if (!sequence) return fail(of_the_file(sequence.error()));
  auto written = program.language->write(*sequence, program.catalog);
  if (!written) return fail(of_the_file(written.error()));
  for (const std::string& remark : written->remarks)
    write_aside(fmt::format("{}: {}", shown_path(program.path), remark));
  if (!written->tool.empty()) write_aside(fmt::format("{}: {}", shown_path(program.path), written->tool));
  program.text = std::move(written->text);
  return program;
}

std::vector<std::string> problem_lines(const ProgramFile& program, const ProgramReport& report) {
  constexpr std::size_t most_lines = 100, longest_sentence = 500;
  std::vector<const Problem*> shown;
  for (const Problem& p : report.problems) shown.push_back(&p);
  if (shown.size() > most_lines) {
    std::stable_partition(shown.begin(), shown.end(), [](const Problem* p) { return p->error; });
    shown.resize(most_lines);
  }
  const std::string path = shown_path(program.path);
  std::vector<std::string> lines;
  for (const Problem* p : shown)
    lines.push_back(fmt::format("{}:{}:{}: {}: {}", path, p->line + 1, p->column + 1,
                                p->error ? "error" : "warning", shown_text(p->sentence, longest_sentence)));
  if (const std::size_t more = report.problems.size() - shown.size(); more > 0)
    lines.push_back(fmt::format("{}: and {} more. Correct these first.", path, more));
  return lines;
}

}  // namespace hw::app
