#include <algorithm>

#include <fmt/core.h>

#include "core/session/address.h"
#include "core/session/backup.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/wiring.h"

namespace hw::app {
namespace {

Task<int> take(Scheduler& scheduler, const Address& address, std::string file) {
  auto opened = co_await connect(scheduler, address, wire_opener());
  if (!opened) co_return complain(opened.error(), status_of(opened.error()));
  const std::shared_ptr<Session> session = *opened;
  auto taken = co_await take_backup(session);
  co_await session->close();
  if (!taken) co_return complain(taken.error());
  if (const auto saved = save_backup(file, *taken, session->catalog()); !saved)
    co_return complain(saved.error());
  const auto programs = std::count_if(taken->programs.begin(), taken->programs.end(),
                                      [](const auto& p) { return !p.second.empty(); });
  print_result("{}: {} parameters, {} program{}\n", file, taken->parameters.size(), programs,
               programs == 1 ? "" : "s");
  co_return done;
}

Task<int> put_back(Scheduler& scheduler, const Address& address, std::string file, Warned warned) {
  auto loaded = load_backup(file);
  if (!loaded) co_return complain(loaded.error());
  auto opened = co_await connect(scheduler, address, wire_opener());
  if (!opened) co_return complain(opened.error(), status_of(opened.error()));
  const std::shared_ptr<Session> session = *opened;
  auto report = co_await restore_backup(session, std::move(*loaded), file, warned);
  const bool in_ram_only = session->known().unsaved_setup || session->known().unsaved_programs;
  co_await session->close();
  if (!report) co_return complain(report.error());
  print_result("{}\n", report->sentence());
  if (in_ram_only)
    write_aside("The values are in force, and lost at power-off until you store them in the controller.\n");
  for (const std::string& sentence : report->warnings) write_aside(sentence);
  if (report->left_out.empty()) co_return done;
  for (const std::string& sentence : report->left_out) complain(sentence);
  co_return failed;
}

}  // namespace

static int backup(const Given& given) {
  const auto address = Address::parse(given.words[0]);
  if (!address) return complain(address.error(), usage);
  if (!given.has("output")) return complain("Add -o FILE.toml: no file is named.", usage);
  return run_here([&](Scheduler& scheduler) { return take(scheduler, *address, given.one("output")); });
}

static int restore(const Given& given) {
  const auto address = Address::parse(given.words[0]);
  if (!address) return complain(address.error(), usage);
  return run_here([&](Scheduler& scheduler) {
    return put_back(scheduler, *address, given.words[1],
                    given.has("leave-motor-types") ? Warned::leave_out : Warned::write);
  });
}

const Subcommand backup_subcommand{
    "backup",
    "set-up and programs of a controller into a file",
    {{"ADDRESS", "the controller", 1, 1}},
    {{"output", "FILE.toml", "the file", false, "o"}},
    backup,
};

const Subcommand restore_subcommand{
    "restore",
    "set-up and programs from a file into a controller",
    {{"ADDRESS", "the controller", 1, 1}, {"FILE.toml", "made by backup", 1, 1}},
    {{"leave-motor-types", "", "leave parameters that carry a warning (motor types) as they are"}},
    restore,
};

}  // namespace hw::app
