#include "core/session/backup.h"

#include <fmt/core.h>

namespace hw {
namespace {

Task<Result<>> read_parameters(std::shared_ptr<Session> session) {
  if (session->catalog().params.empty()) co_return Result<>();
  IntentBody read = intent::ReadParams();
  co_return co_await session->perform(std::move(read));
}

}  // namespace

Task<Result<Backup>> take_backup(std::shared_ptr<Session> session) {
  const Catalog& catalog = session->catalog();
  Backup backup;
  backup.model = catalog.model;
  auto read = co_await read_parameters(session);
  if (!read) co_return fail(read.error());
  const Snapshot& known = session->known();
  backup.firmware = std::string(known.identity.firmware.view());
  for (std::size_t i = 0; i < catalog.params.size() && i < known.params.size(); ++i)
    if (known.params[i].known)
      backup.parameters.push_back({catalog.params[i].mnemonic, known.params[i].value, 0});
  for (int n = catalog.variables.stored_from; n < catalog.variables.count; ++n)
    if (known.variables_known[static_cast<std::size_t>(n)])
      backup.variables[n] = known.variables[static_cast<std::size_t>(n)];
  for (int slot = 0; slot < catalog.program.slots; ++slot) {
    auto listing = co_await session->listing(slot);
    if (!listing) co_return fail(listing.error());
    backup.programs[slot] = std::move(*listing);  // empty ones too: restoring empties the slot
  }
  co_return backup;
}

std::string RestoreReport::sentence() const {
  std::string all = fmt::format("Parameters: {} written, {} were equal already. Programs: {} written.",
                                parameters_written, parameters_equal, programs_written);
  if (programs_emptied > 0) all += fmt::format(" Emptied as in the backup: {}.", programs_emptied);
  if (variables_written > 0) all += fmt::format(" Variables: {} written.", variables_written);
  return all;
}

namespace {

Task<Result<>> restore_parameters(std::shared_ptr<Session> session, std::vector<ParameterEntry> entries,
                                  Warned warned, RestoreReport& report) {
  const Catalog& catalog = session->catalog();
  auto read = co_await read_parameters(session);
  if (!read) co_return read;
  for (const ParameterEntry& entry : entries) {
    const auto i = static_cast<std::size_t>(catalog.find_param(entry.mnemonic));
    const ParamInfo& info = catalog.params[i];
    const ParamState state = session->known().params[i];
    if (state.known && state.value == entry.value) {
      ++report.parameters_equal;
      continue;
    }
    if (!info.warning.empty()) {
      const bool write = warned == Warned::write;
      report.warnings.push_back(fmt::format("{} = {} {}. {}", entry.mnemonic, entry.value,
                                            write ? "was written" : "was left out", info.warning));
      if (!write) continue;
    }
    IntentBody set = intent::SetParam(entry.mnemonic, entry.value, true);
    auto done = co_await session->perform(std::move(set));
    if (!done) co_return done;
    ++report.parameters_written;
  }
  co_return Result<>();
}

Task<Result<>> restore_variables(std::shared_ptr<Session> session, std::map<int, std::int64_t> variables,
                                 RestoreReport& report) {
  for (const auto& [number, value] : variables) {
    const auto n = static_cast<std::size_t>(number);
    if (session->known().variables_known[n] && session->known().variables[n] == value) continue;
    IntentBody set = intent::SetVariable(number, value);
    auto done = co_await session->perform(std::move(set));
    if (!done) co_return done;
    ++report.variables_written;
  }
  co_return Result<>();
}

Task<Result<>> restore_programs(std::shared_ptr<Session> session, std::map<int, std::string> programs,
                                RestoreReport& report) {
  for (const auto& [slot, text] : programs) {
    const bool is_empty = session->known().slot_bytes_used[static_cast<std::size_t>(slot)] == 0;
    if (text.empty() && is_empty) continue;
    IntentBody load = intent::LoadProgram(slot, text);
    auto done = co_await session->perform(std::move(load));
    if (!done) co_return done;
    ++(text.empty() ? report.programs_emptied : report.programs_written);
  }
  co_return Result<>();
}

}  // namespace

Task<Result<RestoreReport>> restore_backup(std::shared_ptr<Session> session, Backup backup,
                                           std::string file_name, Warned warned) {
  auto checked = check_backup(backup, session->catalog(), file_name);
  if (!checked) co_return fail(checked.error());
  RestoreReport report;
  report.left_out = std::move(checked->problems);
  auto parameters = co_await restore_parameters(session, std::move(checked->parameters), warned, report);
  if (!parameters) co_return fail(parameters.error());
  auto variables = co_await restore_variables(session, std::move(checked->variables), report);
  if (!variables) co_return fail(variables.error());
  auto programs = co_await restore_programs(session, std::move(checked->programs), report);
  if (!programs) co_return fail(programs.error());
  co_return report;
}

}  // namespace hw
