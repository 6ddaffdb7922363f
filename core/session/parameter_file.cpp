#include "core/session/parameter_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/number_text.h"
#include "core/base/toml.h"
#include "core/session/user_files.h"

namespace hw {
namespace {

int source_line(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

tl::unexpected<Fault> bad_file(const std::string& name, int line, std::string_view what) {
  return fail(FaultKind::text, fmt::format("{}, line {}: {}.", name, line, what),
              "Nothing was loaded from the file.", "Correct that line, or choose another file.");
}

Result<> take_parameters(const toml::table& table, const std::string& name, Backup& out) {
  for (const auto& [key, node] : table) {
    const auto number = node.value_exact<std::int64_t>();
    if (!number)
      return bad_file(name, source_line(node), fmt::format("{} must be a whole number", key.str()));
    out.parameters.push_back({std::string(key.str()), *number, source_line(node)});
  }
  return {};
}

Result<> take_programs(const toml::table& table, const std::string& name, Backup& out) {
  for (const auto& [key, node] : table) {
    const int slot = whole_number<int>(key.str()).value_or(-1);
    const auto text = node.value_exact<std::string>();
    if (slot < 0 || !text)
      return bad_file(name, source_line(node),
                      fmt::format("{} must be the number of a program, with its text", key.str()));
    out.programs[slot] = *text;
  }
  return {};
}

Result<> take_variables(const toml::table& table, const std::string& name, Backup& out) {
  for (const auto& [key, node] : table) {
    const int number = whole_number<int>(key.str()).value_or(-1);
    const auto value = node.value_exact<std::int64_t>();
    if (number < 0 || !value)
      return bad_file(name, source_line(node),
                      fmt::format("{} must be the number of a variable, with a whole number", key.str()));
    out.variables[number] = *value;
  }
  return {};
}

}  // namespace

std::string range_of(const ParamInfo& p) {
  if (!p.choices.empty()) {
    std::vector<std::int64_t> values;
    for (const ParamChoice& c : p.choices) values.push_back(c.value);
    return fmt::format("{}", fmt::join(values, ", "));
  }
  return fmt::format("{}{} to {}", p.also_zero && p.minimum > 0 ? "0 or " : "", p.minimum, p.maximum);
}

static std::string in_parts_of_a_unit(int decimals) {
  switch (decimals) {
    case 0: return {};
    case 1: return ", in tenths";
    case 2: return ", in hundredths";
    case 3: return ", in thousandths";
    default: return fmt::format(", without its decimal point, {} decimals", decimals);
  }
}

/// Names both units, as a file does not know the loop's state: ", pulses/s (closed loop: counts/s)".
static std::string unit_behind(const ParamInfo& p, const Catalog& catalog) {
  if (p.unit.empty()) return {};
  std::string closed = p.unit;
  const std::size_t at = closed.find(catalog.step_word);
  if (!p.follows_loop || catalog.loop_word.empty() || at == closed.npos) return ", " + p.unit;
  closed.replace(at, catalog.step_word.size(), catalog.loop_word);
  return fmt::format(", {} (closed loop: {})", p.unit, closed);
}

std::string write_backup(const Backup& b, const Catalog& catalog) {
  std::string out = fmt::format("# {}{}{}\n", catalog.name, b.saved_at.empty() ? "" : ", saved ", b.saved_at);
  const auto line = [&](const char* key, const std::string& value) {
    if (!value.empty()) out += fmt::format("{} = {}\n", key, toml_quoted(value));
  };
  line("model", b.model);
  line("name", b.name);
  line("firmware", b.firmware);
  line("saved_at", b.saved_at);
  out += "\n[parameters]\n";
  std::string group;
  for (const ParameterEntry& entry : b.parameters) {
    const int i = catalog.find_param(entry.mnemonic);
    const std::string assignment = fmt::format("{} = {}", toml_key(entry.mnemonic), entry.value);
    if (i < 0) {
      out += assignment + "\n";
      continue;
    }
    const ParamInfo& p = catalog.params[static_cast<std::size_t>(i)];
    if (p.group != group) out += fmt::format("# {}\n", group = p.group);
    out += fmt::format("{:<16} # {}{}{}\n", assignment, p.label, unit_behind(p, catalog),
                       in_parts_of_a_unit(p.decimals));
  }
  if (!b.variables.empty()) out += "\n[variables]\n";
  for (const auto& [number, value] : b.variables) out += fmt::format("{} = {}\n", number, value);
  if (b.programs.empty()) return out;
  out += "\n[programs]\n";
  for (const auto& [slot, text] : b.programs) out += fmt::format("{} = {}\n", slot, toml_lines(text));
  return out;
}

Result<Backup> parse_backup(std::string_view text, const std::string& name) {
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const auto& error = parsed.error();
    return bad_file(name, static_cast<int>(error.source().begin.line), error.description());
  }
  const toml::table& root = parsed.table();
  Backup b;
  for (const auto& [key, node] : root) {
    const std::string_view k = key.str();
    const toml::table* table = node.as_table();
    Result<> taken;
    if (k == "parameters" && table)
      taken = take_parameters(*table, name, b);
    else if (k == "programs" && table)
      taken = take_programs(*table, name, b);
    else if (k == "variables" && table)
      taken = take_variables(*table, name, b);
    else if (const auto value = node.value_exact<std::string>(); value && k == "model")
      b.model = *value;
    else if (value && k == "name")
      b.name = *value;
    else if (value && k == "firmware")
      b.firmware = *value;
    else if (value && k == "saved_at")
      b.saved_at = *value;
    else
      return bad_file(name, source_line(node), fmt::format("{} is not known", k));
    if (!taken) return fail(taken.error());
  }
  if (b.model.empty())
    return fail(FaultKind::text,
                fmt::format("{} does not say for which controller it is (model = \"...\").", name),
                "Nothing was loaded from the file.", "Choose a file that was saved here.");
  // toml++ sorts by name; restore the order of the file, which the user knows.
  std::stable_sort(b.parameters.begin(), b.parameters.end(),
                   [](const ParameterEntry& x, const ParameterEntry& y) { return x.line < y.line; });
  return b;
}

Result<> save_backup(const std::filesystem::path& path, const Backup& backup, const Catalog& catalog) {
  auto written = write_file(path, write_backup(backup, catalog));
  if (written) return written;
  Fault fault = std::move(written.error());
  fault.done = "An older file of that name is unchanged.";
  return fail(std::move(fault));
}

Result<Backup> load_backup(const std::filesystem::path& path) {
  constexpr std::uintmax_t largest = 1'000'000;
  auto bytes = read_file(path, largest);
  if (!bytes) return fail(bytes.error());
  return parse_backup(*bytes, path.filename().string());
}

Result<CheckedBackup> check_backup(const Backup& backup, const Catalog& catalog, const std::string& name) {
  if (backup.model != catalog.model)
    return fail(
        FaultKind::text,
        fmt::format("{} is for a controller \"{}\", this one is \"{}\".", name, backup.model, catalog.model),
        "Nothing was loaded from the file.", "Choose a file of this model.");
  CheckedBackup checked;
  for (const ParameterEntry& entry : backup.parameters) {
    const int i = catalog.find_param(entry.mnemonic);
    const auto where = entry.line > 0 ? fmt::format("{}, line {}", name, entry.line) : name;
    if (i < 0) {
      checked.problems.push_back(fmt::format("{}: {} is not a parameter of this controller. It was left out.",
                                             where, entry.mnemonic));
      continue;
    }
    const ParamInfo& p = catalog.params[static_cast<std::size_t>(i)];
    if (!p.accepts(entry.value)) {
      checked.problems.push_back(fmt::format("{}: {} = {} is out of range, {} takes {}. It was left out.",
                                             where, entry.mnemonic, entry.value, entry.mnemonic,
                                             range_of(p)));
      continue;
    }
    checked.parameters.push_back(entry);
  }
  for (const auto& [number, value] : backup.variables) {
    const VariableFacts& facts = catalog.variables;
    if (number < facts.count && value >= facts.minimum && value <= facts.maximum)
      checked.variables[number] = value;
    else
      checked.problems.push_back(
          fmt::format("{}: {}{} = {} is not possible in this controller. It was left out.", name,
                      facts.prefix, number, value));
  }
  for (const auto& [slot, text] : backup.programs) {
    if (slot >= 0 && slot < catalog.program.slots)
      checked.programs[slot] = text;
    else
      checked.problems.push_back(
          fmt::format("{}: there is no {} {} in this controller. It was left out.", name,
                      catalog.program.slot_word.empty() ? "program" : catalog.program.slot_word, slot));
  }
  return checked;
}

}  // namespace hw
