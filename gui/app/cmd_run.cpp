#include "core/script/runner.h"
#include "core/session/text_file.h"
#include "gui/app/cli.h"
#include "gui/app/output.h"
#include "gui/app/script_stage.h"
#include "gui/app/traffic_file.h"
#include "gui/app/watchdog.h"
#include "gui/app/wiring.h"

namespace hw::app {

/// The units of the script's screen, or the units that the console keeps, if requested.
static script::AxisUnits::Kept kept_units(const Given& given, const ScriptStage* stage) {
  const auto kept = given.has("profile")
                        ? std::make_shared<KeptUnits>(UserFolders::standard(),
                                                      [](const Fault& why) { write_aside(why.sentence()); })
                        : nullptr;
  if (!stage && !kept) return {};
  return [stage, kept](const Session& session, int axis) {
    auto unit = stage ? stage->unit_of(session, axis) : std::nullopt;
    return unit || !kept ? unit : kept->unit_of(session, axis);
  };
}

static int run_script(const Given& given) {
  const auto file = load_text(given.words[0]);
  if (!file) return complain(file.error());

  script::RunOptions options;
  options.path = given.words[0];
  options.args.assign(given.words.begin() + 1, given.words.end());
  options.opener = wire_opener();
  options.print = print_of_script;
  options.log = write_aside;
  std::shared_ptr<TrafficFile> traffic;
  if (given.has("traffic")) {
    auto created = TrafficFile::create(given.one("traffic"));
    if (!created) return complain(created.error());
    traffic = std::move(*created);
    options.opener = TrafficFile::tap(traffic, std::move(options.opener));
  }

  IoContext io{1};
  HybridScheduler scheduler(io, given.has("realtime"));
  std::unique_ptr<ScriptStage> stage;
  if (given.has("gui")) stage = std::make_unique<ScriptStage>(scheduler, options.opener);
  options.stage = stage.get();
  options.kept_unit = kept_units(given, stage.get());
  script::Runner runner(scheduler, std::move(options));
  if (traffic) traffic->on_failure = [&runner](const Fault& why) { runner.give_up(why.sentence()); };
  Watchdog watchdog(runner);
  runner.on_real_time = [&] {
    if (stage) stage->time_is_real();
    watchdog.take_signals();  // only real motors must be stopped
  };
  if (scheduler.is_real()) runner.on_real_time();
  auto outcome = runner.run(file->text);
  script::Notes& notes = runner.notes();
  if (traffic) {
    auto kept = traffic->finish();
    if (kept) notes.written.note(given.one("traffic"), "traffic");
    if (outcome) outcome = std::move(kept);
  }
  if (const std::string written = notes.written.sentence(); !written.empty()) write_aside(written);
  if (outcome) return done;
  return complain(outcome.error().sentence(), notes.words_are_wrong ? usage : failed, LineEnds::kept);
}

const Subcommand run_subcommand{
    "run",
    "run a Lua script without a window",
    {{"SCRIPT.lua", "the script", 1, 1}, {"ARGS", "its hw.args; -- ends the options", 0, -1}},
    {{"realtime", "", "wall-clock time (else virtual time while every controller is an emulator in process)"},
     {"gui", "", "with the panels, without a display"},
     {"profile", "", "with the units that the console keeps for each controller (else with none)"},
     {"traffic", "FILE", "record every byte of every wire"}},
    run_script,
};

}  // namespace hw::app
