#include <cstdio>

#include <fmt/core.h>

#include "core/script/runner.h"
#include "core/session/text_file.h"
#include "gui/app/cli.h"
#include "gui/app/script_stage.h"
#include "gui/app/traffic_file.h"
#include "gui/app/watchdog.h"
#include "gui/app/wiring.h"

namespace hw::app {
namespace {

void print_result(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }
void print_log(std::string_view line) {
  std::fflush(stdout);  // so that both streams stay in order for a reader of both
  fmt::print(stderr, "{}\n", line);
}

}  // namespace

static int run_script(const Given& given) {
  const auto file = load_text(given.words[0]);
  if (!file) return complain(file.error());

  script::RunOptions options;
  options.path = given.words[0];
  options.args.assign(given.words.begin() + 1, given.words.end());
  options.opener = wire_opener();
  options.print = print_result;
  options.log = print_log;
  if (given.has("traffic")) {
    auto traffic = TrafficFile::create(given.one("traffic"));
    if (!traffic) return complain(traffic.error());
    options.opener = TrafficFile::tap(std::move(*traffic), std::move(options.opener));
  }

  IoContext io{1};
  HybridScheduler scheduler(io, given.has("realtime"));
  std::unique_ptr<ScriptStage> stage;
  if (given.has("gui")) stage = std::make_unique<ScriptStage>(scheduler, options.opener);
  options.stage = stage.get();
  script::Runner runner(scheduler, std::move(options));
  Watchdog watchdog(runner);
  runner.on_real_time = [&] {
    if (stage) stage->time_is_real();
    watchdog.take_signals();  // real motors are told to stop; virtual ones just end
  };
  if (scheduler.is_real()) runner.on_real_time();
  const auto outcome = runner.run(file->text);
  std::fflush(stdout);
  return outcome ? done : complain(outcome.error());
}

const Subcommand run_subcommand{
    "run",
    "run a Lua script without a window",
    {{"SCRIPT.lua", "the script", 1, 1}, {"ARGS", "its hw.args; -- ends the options", 0, -1}},
    {{"realtime", "", "wall-clock time (else virtual time while every controller is an emulator in process)"},
     {"gui", "", "with the panels, laid out and driven without a display"},
     {"traffic", "FILE", "write down every byte of every wire"}},
    run_script,
};

}  // namespace hw::app
