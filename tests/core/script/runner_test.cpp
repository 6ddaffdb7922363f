// A script without any controller: what it is told, what it may not, and how it ends.
#include "core/script/runner.h"

#include <thread>

#include <gmock/gmock.h>

#include "core/script/module.h"

namespace hw::script {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

struct FinishedRun {
  Result<> result;
  std::string printed, logged;
  Instant ended;
  std::size_t room = std::string::npos;  ///< for what is printed
  [[nodiscard]] std::string fault() const { return result ? "none" : result.error().what; }
  Result<> print(std::string_view line) {
    if (printed.size() + line.size() > room) return fail(FaultKind::port, "The output cannot be written.");
    printed += line;
    return {};
  }
};

void run_into(FinishedRun& ran, std::string_view text, Limits limits = {}, Stage* stage = nullptr,
              std::vector<std::string> args = {}) {
  IoContext io{1};
  HybridScheduler time(io, false);
  RunOptions options;
  options.path = "some/folder/test.lua";
  options.args = std::move(args);
  options.limits = limits;
  options.stage = stage;
  options.print = [&](std::string_view line) { return ran.print(line); };
  options.log = [&](std::string_view line) { ran.logged += line; };
  Runner runner(time, std::move(options));
  ran.result = runner.run(text);
  ran.ended = time.now();
}

FinishedRun run(std::string_view text, Limits limits = {}, Stage* stage = nullptr,
                std::vector<std::string> args = {}) {
  FinishedRun ran;
  run_into(ran, text, limits, stage, std::move(args));
  return ran;
}

// The script has lost what it is run for: no pcall keeps it going.
TEST(Runner, UnusedResultsEndTheRun) {
  FinishedRun ran;
  ran.room = 4;
  run_into(ran, "print('a')\nfor i = 1, 9 do pcall(print, 'b') end\nhw.log('c')");
  EXPECT_EQ(ran.fault(), "test.lua:2: The output cannot be written.");
  EXPECT_EQ(ran.printed, "a\nb\n");
  EXPECT_EQ(ran.logged, "");
}

TEST(Runner, RunsToTheEndOfTheScript) {
  const FinishedRun ran = run("print(1, 'two', hw.args[1], hw.args[0])", {}, nullptr, {"arg"});
  EXPECT_TRUE(ran.result) << ran.fault();
  EXPECT_EQ(ran.printed, "1\ttwo\targ\tsome/folder/test.lua\n");
}

TEST(Runner, SleepsInVirtualTime) {
  const FinishedRun ran = run("hw.sleep(1.5) print(hw.now()) hw.sleep(0.25)");
  EXPECT_EQ(ran.printed, "1.5\n");
  EXPECT_EQ(ran.ended, Instant(Millis(1750)));
}

TEST(Runner, SkipsAShebang) {
  EXPECT_EQ(run("#!/usr/bin/env handwheel\nerror('x')").fault(), "test.lua:2: x");
}

TEST(Runner, NamesTheLinesThatLedToAnError) {
  const std::string fault = run("local function f()\n  error('boom')\nend\nf()\n").fault();
  EXPECT_THAT(fault, StartsWith("test.lua:2: boom"));
  EXPECT_THAT(fault, HasSubstr("called from test.lua:4"));
}

TEST(Runner, LuasOwnMessageAboutNilIsCompleted) {
  const std::pair<const char*, const char*> cases[] = {
      {"hw.slep(1)", "Did you mean \"sleep\"?"},
      {"sleep(1)", "Did you mean \"hw.sleep\"?"},
      {"wait_any({})", "Did you mean \"hw.wait_any\"?"},
      {"local t = hw.spawn(print) t:wiat()", "Did you mean \"wait\"?"},
      {"local t = hw.spawn(print) t:collect()", "There is no such method: the manual lists them"},
      {"local t = hw.spawn(print) t:movee(1)", "(method 'movee'). There is move_by, move_to."},
      {"hw.arguments{name='count'}",
       "hw.arguments: there is no \"name\": it takes a list of arguments, each a table"},
      {"move_to(1)", "A method is called on a controller, with a colon: c:move_to(...)"},
      {"local c = hw.open('vxm')\nprint(c:axes())",
       "A call at test.lua:1 returned nil: \"vxm\" is not an address"},
      {"local c = hw.open('vxm')\nprint(1 + c)", "A call at test.lua:1 returned nil: \"vxm\""},
      {"local c = hw.open('vxm')\nprint(1 < c)", "A call at test.lua:1 returned nil: \"vxm\""},
      {"local c = hw.open('vxm')\nprint('a' .. c)", "A call at test.lua:1 returned nil: \"vxm\""},
      {"local c = {} print(c.bench.place)", "each device has: c.devices[\"01\"].bench"},
      {"local c = {} print(c.devices['01'])", "Only a bus has devices"},
  };
  for (const auto& [text, words] : cases) {
    const std::string fault = run(text).fault();
    EXPECT_THAT(fault, StartsWith("test.lua:"));

    EXPECT_THAT(fault, HasSubstr(words)) << text;
  }
  EXPECT_EQ(run("local c = hw.open('vxm')\nerror('boom')").fault(), "test.lua:2: boom")
      << "its own words stay";
  EXPECT_EQ(run("local t\nprint(t.x)").fault(), "test.lua:2: attempt to index a nil value (local 't')");
  EXPECT_EQ(run("for _, s in ipairs{5, 0.1} do\nhw.wait_any({function() hw.sleep(s) end}, 1)\nend\n"
                "local t\nprint(t.x)")
                .fault(),
            "test.lua:5: attempt to index a nil value (local 't')")
      << "a call that was made again with success is not the reason";
}

TEST(Runner, AFailedCheckSurvivesNoPcall) {
  const FinishedRun ran = run("pcall(function() hw.check(false, 'no') end) print('never')");
  EXPECT_EQ(ran.fault(), "test.lua:1: hw.check failed: no");
  EXPECT_EQ(ran.printed, "");
}

TEST(Runner, ACheckGivesBackWhatItWasGiven) { EXPECT_EQ(run("print(hw.check(5, 'x'))").printed, "5\tx\n"); }

TEST(Runner, EndsALoopWithoutEnd) {
  Limits limits;
  limits.instructions = 1'000'000;
  EXPECT_THAT(run("\nwhile true do end", limits).fault(), StartsWith("test.lua:2: The script ran 1 million"));
  EXPECT_THAT(run("while true do hw.sleep(0) end", limits).fault(), HasSubstr("without letting time pass"));
  EXPECT_EQ(run("for i = 1, 300 do for j = 1, 10000 do end hw.sleep(0.01) end", limits).fault(), "none");
}

TEST(Runner, EndsALoopOfLongCalls) {
  Limits limits;
  limits.computing = Millis(50);
  EXPECT_THAT(
      run("local t = {} for i = 1, 1000 do t[i] = i end\nwhile true do table.concat(t) end", limits).fault(),
      StartsWith("test.lua:2: The script computed for 0.05 s"));
}

TEST(Runner, EndsNestedCoroutinesThatCatchEverything) {
  Limits limits;
  limits.instructions = 1'000'000;
  EXPECT_THAT(run("local function f() while true do end end\n"
                  "coroutine.wrap(function() while true do coroutine.resume(coroutine.create(f)) end end)()",
                  limits)
                  .fault(),
              StartsWith("test.lua:1: The script ran 1 million"));
}

// Runs a script that computes for ever, and does something to it from another thread once it does.
FinishedRun run_beside(std::string_view text, const std::function<void(Runner&)>& act) {
  IoContext io{1};
  HybridScheduler time(io, true);
  FinishedRun ran;
  RunOptions options;
  options.path = "test.lua";
  options.print = [&](std::string_view line) { return ran.print(line); };
  options.log = [&](std::string_view line) { ran.logged += line; };
  Runner runner(time, std::move(options));
  std::thread beside([&] {
    while (!runner.at_work()) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    act(runner);
  });
  ran.result = runner.run(text);
  beside.join();
  return ran;
}

TEST(Runner, AnInterruptEndsAScriptThatComputes) {
  const FinishedRun ran = run_beside("pcall(function() while true do end end) print('never')",
                                     [](Runner& runner) { runner.interrupt(); });
  EXPECT_EQ(ran.fault(), "Interrupted.");
  EXPECT_EQ(ran.printed, "");
}

#ifndef __SANITIZE_THREAD__  // keeps signals back until the call comes back
void expect_left(const std::string& text) {
  for (const bool interrupted : {false, true}) {
    const auto get_out = [&](Runner& runner) {
      if (interrupted) runner.interrupt();
      while (runner.at_work()) {
        runner.break_out(runner.heartbeat());
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    };
    const FinishedRun ran = run_beside(
        "local function hang() return string.find(('a'):rep(60), ('a-'):rep(30) .. 'b') end\n" + text,
        get_out);
    EXPECT_THAT(ran.fault(), StartsWith(interrupted ? "Interrupted." : "The script computed for 20 s"));
    EXPECT_EQ(ran.printed, "");
  }
}

TEST(Runner, ACallThatDoesNotComeBackIsLeft) { expect_left("pcall(hang) print('never')"); }

TEST(Runner, ATextOfTheScriptsOwnThatDoesNotComeBackIsLeft) {
  expect_left("pcall(print, setmetatable({}, {__tostring = hang})) print('never')");
}

TEST(Runner, AnErrorInATextOfTheScriptsOwnKeepsNoCallIn) {
  expect_left("pcall(print, setmetatable({}, {__tostring = function() error('x') end})) hang()");
}
#endif

TEST(Runner, LimitsMemory) {
  Limits limits;
  limits.memory_bytes = 4 << 20;
  EXPECT_THAT(run("local t = {} while true do t[#t + 1] = ('x'):rep(1000) .. #t end", limits).fault(),
              HasSubstr("needed more than 4 MB"));
}

TEST(Runner, AModuleReportsItsOwnLine) {
  EXPECT_EQ(run("require('none')").fault(),
            "test.lua:1: require \"none\": there is no none.lua in the script's folder");
}

// A stage that only counts.
struct Counter final : Stage {
  int frames = 0;
  bool over = false;
  void bind(lua_State*) override {}
  void opened(const std::shared_ptr<SessionGroup>&) override {}
  void frame(Instant) override { ++frames; }
  void script_over() override { over = true; }
};

TEST(Runner, DrawsSixtyFramesASecondOfScriptTime) {
  Counter stage;
  EXPECT_TRUE(run("hw.sleep(2)", {}, &stage).result);
  EXPECT_NEAR(stage.frames, 120, 1);
  EXPECT_TRUE(stage.over);
}

}  // namespace
}  // namespace hw::script
