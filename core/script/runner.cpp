#include "core/script/runner.h"

#include <algorithm>
#include <cstdlib>
#include <lua.hpp>

#include <fmt/core.h>

#include "core/base/shown_text.h"
#include "core/script/bind.h"
#include "core/script/lua_places.h"
#include "core/script/module.h"
#include "core/script/sandbox.h"

namespace hw::script {
namespace {

constexpr int hook_every = 10'000;              // instructions
constexpr std::uint64_t cost_of_a_wait = 1000;  // so that a loop of sleep(0) ends too

// The file name only: Lua shortens long paths, and the user knows where the script is.
std::string chunk_name(const std::string& path) { return "@" + shown_path(path.substr(path.rfind('/') + 1)); }

std::string too_long(Duration limit) {
  return fmt::format(
      "The script computed for {:g} s without letting time pass, so it was ended. "
      "Put a hw.sleep() into a loop that waits.",
      seconds(limit));
}

}  // namespace

struct Runner::Fiber {
  lua_State* L = nullptr;
  int kept = LUA_NOREF;  ///< in the registry, so that it is not collected
  bool waits = false;
  bool cancelled = false;  ///< ends when its present wait has ended
  int arguments = 0;       ///< of its function, when it starts
  std::shared_ptr<Spawned> spawned;
  Answer answer;
  Timer starts;
  Fiber(Scheduler& scheduler, std::function<void()> start) : starts(scheduler, std::move(start)) {}
};

// ---- the state and its limits

Runner::Runner(HybridScheduler& scheduler, RunOptions options)
    : scheduler_(scheduler),
      options_(std::move(options)),
      began_(scheduler.now()),
      ended_(scheduler),
      happened_(scheduler) {
  notes_.units.kept = options_.kept_unit;
  lua_ = lua_newstate(&Runner::allocate, this);
  *static_cast<Runner**>(lua_getextraspace(lua_)) = this;
}

Runner::~Runner() {
  static auto& left_alone = *new std::vector<lua_State*>();  // keeps leak checkers silent
  if (broken_)
    left_alone.push_back(lua_);
  else if (lua_)
    lua_close(lua_);
}

Runner& Runner::of(lua_State* L) { return **static_cast<Runner**>(lua_getextraspace(L)); }

void* Runner::allocate(void* self, void* block, std::size_t old_size, std::size_t new_size) {
  auto& runner = *static_cast<Runner*>(self);
  const WayOut::Closed closed(runner.way_out_);
  if (!block) old_size = 0;  // `old_size` is then a type, not a size
  if (new_size == 0) {
    std::free(block);
    runner.memory_used_ -= old_size;
    return nullptr;
  }
  if (new_size > old_size &&
      runner.memory_used_ + (new_size - old_size) > runner.options_.limits.memory_bytes)
    return nullptr;
  void* moved = std::realloc(block, new_size);
  if (moved) runner.memory_used_ += new_size - old_size;
  return moved;
}

void Runner::count_hook(lua_State* L, lua_Debug*) {
  Runner& runner = of(L);
  runner.way_out_.open();
  const WayOut::Closed closed(runner.way_out_);
  runner.heartbeat_.fetch_add(1, std::memory_order_relaxed);
  if (runner.interrupt_asked_) runner.interrupt_now();
  if (runner.ending_) return runner.unwind(L);  // for the script's own coroutines
  runner.count(L, hook_every);
  runner.count_time(L);
}

// Raises the error again at every further instruction, within any pcall too.
void Runner::ending_hook(lua_State* L, lua_Debug*) {
  lua_pushstring(L, of(L).failure_.c_str());
  lua_error(L);
}

// Instructions are counted until time advances; wall-clock time, until the script waits.
void Runner::count(lua_State* L, std::uint64_t instructions) {
  instructions_ += instructions;
  if (instructions_ < options_.limits.instructions || ending_) return;
  end_run(L, fmt::format("The script ran {} million instructions without letting time pass, so it was ended. "
                         "Put a hw.sleep() into a loop that waits.",
                         options_.limits.instructions / 1'000'000));
}

// Also catches long calls of Lua's library, which are few instructions.
void Runner::count_time(lua_State* L) {
  const auto limit = options_.limits.computing;
  if (ending_ || std::chrono::steady_clock::now() - resumed_at_ < limit) return;
  end_run(L, too_long(limit));
}

void Runner::end_run(lua_State* L, std::string sentence) {
  if (ending_) return;
  ending_ = true;
  failure_ = running_line(L) + sentence;
  unwind(L);
}

void Runner::end_for_words(lua_State* L, std::string wrong) {
  if (ending_) return;
  ending_ = true;
  notes_.words_are_wrong = !wrong.empty();
  failure_ = std::move(wrong);
  unwind(L);
}

void Runner::end_unread(lua_State* L, const Fault& why) {
  from_outside_ = true;
  end_run(L, why.sentence());
}

void Runner::unwind(lua_State* L) {
  lua_sethook(L, ending_hook, LUA_MASKCOUNT, 1);
  for (auto& [state, fiber] : fibers_) lua_sethook(state, ending_hook, LUA_MASKCOUNT, 1);
}

// ---- fibers

Runner::Fiber& Runner::add_fiber() {
  lua_State* L = lua_newthread(lua_);
  auto fiber = std::make_unique<Fiber>(scheduler_, [this, L] {
    if (!main_over_) resume(*fibers_.at(L), fibers_.at(L)->arguments);
  });
  fiber->L = L;
  fiber->kept = luaL_ref(lua_, LUA_REGISTRYINDEX);
  lua_sethook(L, count_hook, LUA_MASKCOUNT, hook_every);
  return *(fibers_[L] = std::move(fiber));
}

const char* Runner::why_cannot_wait(lua_State* L) const {
  if (!fibers_.contains(L)) return "this waits, and a coroutine of the script's own cannot wait";
  if (!lua_isyieldable(L)) return "this waits, and a function called by sort, gsub or the like cannot wait";
  return nullptr;
}

void Runner::wait_for(lua_State* L, Task<Answer> work) {
  count(L, cost_of_a_wait);
  Fiber& fiber = *fibers_.at(L);
  fiber.waits = true;
  asio::co_spawn(scheduler_.executor(), carry(fiber, std::move(work)), asio::detached);
}

Task<> Runner::carry(Fiber& fiber, Task<Answer> work) {
  const Instant asked_at = scheduler_.now();
  fiber.answer = co_await std::move(work);
  if (scheduler_.now() > asked_at) instructions_ = 0;
  fiber.waits = false;
  go_on(fiber);
}

void Runner::go_on(Fiber& fiber) {
  if (main_over_) return;
  if (fiber.cancelled)
    end_fiber(fiber, 0);
  else
    resume(fiber, 0);
}

// Continues a call that waited, with the results of its answer.
int resume_with_answer(lua_State* L, int, lua_KContext) {
  const auto fiber = Runner::of(L).fibers_.find(L);
  if (fiber == Runner::of(L).fibers_.end() || !fiber->second->answer)
    return luaL_error(L, "only the call that it waits for can resume it");
  int results = 0;
  {
    const WayOut::Closed closed(Runner::of(L).way_out());
    results = fiber->second->answer(L);
    fiber->second->answer = nullptr;
  }
  forget_mended_refusal(L, results);
  return results == Call::misused ? lua_error(L) : results;
}

void Runner::run_at(lua_State* L, Instant when) {
  Fiber& fiber = add_fiber();
  lua_xmove(L, fiber.L, 1);
  fiber.starts.arm(std::max(when, scheduler_.now()));
}

std::shared_ptr<Spawned> Runner::spawn(lua_State* L, int arguments) {
  Fiber& fiber = add_fiber();
  lua_checkstack(fiber.L, arguments + 2);
  lua_xmove(L, fiber.L, arguments + 1);
  lua_pushthread(fiber.L);
  lua_xmove(fiber.L, L, 1);
  fiber.arguments = arguments;
  fiber.spawned = std::make_shared<Spawned>();
  fiber.spawned->L = fiber.L;
  fiber.starts.arm(scheduler_.now());
  return fiber.spawned;
}

bool Runner::cancel(const Spawned& one) {
  const auto found = one.over ? fibers_.end() : fibers_.find(one.L);
  if (found == fibers_.end()) return true;
  Fiber& fiber = *found->second;
  if (!fiber.waits && !fiber.starts.armed()) return false;
  fiber.cancelled = true;
  fiber.spawned->over = true;
  happened_.notify();
  if (!fiber.waits) end_fiber(fiber, 0);  // not begun yet
  return true;
}

void Runner::resume(Fiber& fiber, int arguments) {
  int results = 0, status = LUA_OK;
  heartbeat_.fetch_add(1, std::memory_order_relaxed);
  resumed_at_ = std::chrono::steady_clock::now();
  at_work_ = true;
  const bool came_back =
      way_out_.through([&] { status = lua_resume(fiber.L, nullptr, arguments, &results); });
  at_work_ = false;
  if (!came_back) return broken_out();
  if (status == LUA_YIELD && fiber.waits) return;
  if (status == LUA_YIELD) {
    lua_pushliteral(fiber.L, "coroutine.yield outside of a coroutine");
    fiber_failed(fiber, LUA_ERRRUN);
  } else if (status != LUA_OK) {
    fiber_failed(fiber, status);
  }
  if (&fiber == main_)
    main_over_ = true;
  else
    end_fiber(fiber, status == LUA_OK ? results : 0);
}

void Runner::end_fiber(Fiber& fiber, int results) {
  if (fiber.spawned) {
    fiber.spawned->results = results;
    fiber.spawned->over = true;
    happened_.notify();
  }
  luaL_unref(lua_, LUA_REGISTRYINDEX, fiber.kept);
  fibers_.erase(fiber.L);
}

// From here on the Lua state must not be used.
void Runner::broken_out() {
  broken_ = ending_ = main_over_ = true;
  if (interrupt_asked_)
    interrupt_now();
  else if (failure_.empty())
    failure_ = too_long(options_.limits.computing);
}

void Runner::fiber_failed(Fiber& fiber, int status) {
  main_over_ = true;
  if (!failure_.empty() || ending_) return;
  if (status == LUA_ERRMEM) {
    failure_ = fmt::format("{}The script needed more than {} MB of memory, so it was ended.",
                           running_line(fiber.L), options_.limits.memory_bytes >> 20);
    return;
  }
  const char* message = lua_tostring(fiber.L, -1);
  failure_ =
      (message ? message + notes_.advice.on(message)
               : fmt::format("{}an error that is a {}", running_line(fiber.L), luaL_typename(fiber.L, -1))) +
      calling_lines(fiber.L);
}

// ---- the run

void Runner::prepare() {
  lua_pushcfunction(lua_, [](lua_State* L) {
    Runner& runner = of(L);
    open_sandbox(L, folder_of(runner.options_.path));
    bind_hw(L);
    bind_controller(L);
    bind_bench(L);
    bind_tasks(L);
    if (runner.options_.stage) runner.options_.stage->bind(L);
    runner.notes_.advice.learn(L);
    return 0;
  });
  if (lua_pcall(lua_, 0, 0, 0) != LUA_OK) failure_ = lua_tostring(lua_, -1);
}

bool Runner::load(std::string_view text) {
  main_ = &add_fiber();
  if (text.substr(0, 1) == "#") text.remove_prefix(std::min(text.find('\n'), text.size()));  // #! of a script
  if (luaL_loadbufferx(main_->L, text.data(), text.size(), chunk_name(options_.path).c_str(), "t") == LUA_OK)
    return true;
  failure_ = lua_tostring(main_->L, -1);
  return false;
}

Result<> Runner::run(std::string_view text) {
  prepare();
  if (failure_.empty() && load(text)) {
    resume(*main_, 0);
    take_turns();
  }
  finish();
  if (failure_.empty()) return {};
  return fail(FaultKind::text, failure_);
}

// Time, bytes and the script take turns on this thread, with a frame 60 times a second.
void Runner::take_turns() {
  const auto turn_over = [this] { return main_over_ || !acts_.empty(); };
  if (options_.stage) next_frame_ = scheduler_.now() + frame_period;
  while (!main_over_) {
    const auto turn = scheduler_.run_until(next_frame_, turn_over);
    log_notices();
    if (turn == HybridScheduler::Turn::stuck) {
      failure_ = "The script waits for an event that can no longer come.";
      return;
    }
    if (!acts_.empty())
      act_now();
    else if (scheduler_.now() >= next_frame_)
      run_one_frame();
  }
}

void Runner::act_between_turns(lua_State* L, std::function<Answer()> act) {
  Fiber& fiber = *fibers_.at(L);
  fiber.waits = true;
  acts_.push_back(Act{&fiber, std::move(act)});
}

void Runner::act_now() {
  const Act next = std::move(acts_.front());
  acts_.pop_front();
  if (next.fiber->cancelled) return go_on(*next.fiber);
  const Instant began = scheduler_.now();
  next.fiber->answer = next.act();
  next.fiber->waits = false;
  if (scheduler_.now() > began) instructions_ = 0;
  go_on(*next.fiber);
}

// A late frame is drawn once; missed frames are skipped.
void Runner::run_one_frame() {
  scheduler_.run_until(next_frame_, [this] { return main_over_; });
  options_.stage->frame(scheduler_.now());
  next_frame_ = std::max(next_frame_ + frame_period, scheduler_.now());
}

void Runner::add(std::shared_ptr<SessionGroup> group) { groups_.push_back(std::move(group)); }
void Runner::remove(const std::shared_ptr<SessionGroup>& group) { std::erase(groups_, group); }

Task<bool> Runner::sleep_until(Instant when) {
  co_await ended_.wait_until(when);
  co_return !main_over_;
}

void Runner::go_real() {
  if (scheduler_.is_real()) return;
  scheduler_.go_real();
  if (on_real_time) on_real_time();
}

// Without a stage only: a stage's panels read the notices.
void Runner::log_notices() {
  if (options_.stage) return;
  for (const auto& group : groups_)
    for (const auto& session : group->members())
      session->notices().drain([&](const Notice& notice) {
        if (notice.kind == Notice::Kind::warning || notice.kind == Notice::Kind::error)
          options_.log(fmt::format("{}: {}", session->address().text(), notice.text));
      });
}

}  // namespace hw::script
