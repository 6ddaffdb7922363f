#pragma once
// Runs one Lua script on the io thread. The script is a coroutine (a fiber): each call that waits suspends
// it, and everything else goes on until what it waits for has come.
#include <atomic>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/asio.h"
#include "core/script/notes.h"
#include "core/script/way_out.h"
#include "core/session/session_group.h"
#include "core/session/wire.h"
#include "core/time/hybrid_scheduler.h"

struct lua_State;
struct lua_Debug;

namespace hw::script {

class Stage;

struct Limits {
  std::size_t memory_bytes = std::size_t{256} << 20;
  // Without letting time go on:
  std::uint64_t instructions = 300'000'000;
  Duration computing = std::chrono::seconds(20);  ///< by the clock on the wall
};

struct RunOptions {
  std::string path;               ///< for messages; `require` looks in its folder
  std::vector<std::string> args;  ///< hw.args
  WireOpener opener;
  Limits limits;
  /// Results. A fault ends the script, which nobody hears any more.
  std::function<Result<>(std::string_view)> print;
  std::function<void(std::string_view)> log;  ///< hw.log and what controllers report
  Stage* stage = nullptr;                     ///< a screen: `ui`, frames
};

/// What a call that waited gives back: pushes values, answers how many.
using Answer = std::function<int(lua_State*)>;

/// A function of the script that runs beside the rest of it.
struct Spawned {
  lua_State* L = nullptr;  ///< its stack, with its results on top once it is over; see Runner::spawn()
  int results = 0;
  bool over = false;
};

class Runner {
 public:
  Runner(HybridScheduler& scheduler, RunOptions options);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Runs the script's text to its end, with frames of the stage in between. A fault tells FILE:LINE.
  Result<> run(std::string_view text);
  /// Called when time becomes real, because the script opens a controller outside of this process.
  std::function<void()> on_real_time;

  // ---- any thread, while run() is under way
  /// Somebody wants it to end now, whatever it is doing: all controllers are told to stop.
  void interrupt();
  /// The same for another reason: a sentence.
  void give_up(std::string why);
  /// Whether the script computes; then heartbeat() changes at least every 10,000 instructions.
  [[nodiscard]] bool at_work() const { return at_work_; }
  [[nodiscard]] std::uint64_t heartbeat() const { return heartbeat_; }
  /// How long that may take.
  [[nodiscard]] Duration patience() const { return options_.limits.computing; }
  /// Ends a script that stays in one call of Lua's library, if its heart still stands at `seen`. Asked again
  /// until at_work() is over: there are moments when that is not possible.
  void break_out(std::uint64_t seen) { way_out_.take(seen); }

  // ---- for bindings (io thread, while the script runs)
  static Runner& of(lua_State* L);
  [[nodiscard]] HybridScheduler& scheduler() { return scheduler_; }
  [[nodiscard]] const RunOptions& options() const { return options_; }
  [[nodiscard]] double seconds_since_start() const { return seconds(scheduler_.now() - began_); }
  [[nodiscard]] Instant began() const { return began_; }
  /// Whether the code on `L` may wait; else a sentence why not.
  [[nodiscard]] const char* why_cannot_wait(lua_State* L) const;
  /// The code on `L` is about to yield until `work` is over; its answer becomes the results of the call.
  void wait_for(lua_State* L, Task<Answer> work);
  /// Runs the function on top of `L`'s stack as a fiber of its own, at `when`. Pops it.
  void run_at(lua_State* L, Instant when);
  /// The same at once, with `arguments` that stand above the function. Leaves the coroutine in their place:
  /// whoever wants the results keeps it.
  std::shared_ptr<Spawned> spawn(lua_State* L, int arguments);
  /// It is resumed no more. False: it runs at this moment, so it is the one who asks.
  bool cancel(const Spawned& one);
  /// Notified when a spawned function is over, when bindings say so, and at the end of the script.
  [[nodiscard]] Event& happened() { return happened_; }
  [[nodiscard]] Notes& notes() { return notes_; }
  /// What C++ closes while Lua calls it.
  [[nodiscard]] WayOut& way_out() { return way_out_; }
  /// Ends the whole run with this sentence; no pcall of the script survives it.
  void end_run(lua_State* L, std::string sentence);
  /// The same for what stands behind the script's name: why that is wrong. Empty: it only asked for help.
  void end_for_words(lua_State* L, std::string wrong);
  /// The same for results that nobody gets: the script has lost what it is run for.
  void end_unread(lua_State* L, const Fault& why);
  void add(std::shared_ptr<SessionGroup> group);
  void remove(const std::shared_ptr<SessionGroup>& group);
  /// Suspends a waiting call; false: the script has ended meanwhile.
  Task<bool> sleep_until(Instant when);
  void go_real();

  // ---- for the stage
  /// Suspends the code on `L` like wait_for(); `act` runs between two turns of the run, so that it may let
  /// frames pass by itself.
  void act_between_turns(lua_State* L, std::function<Answer()> act);
  /// For such an act: everything goes on until the next frame, which is drawn.
  void run_one_frame();
  [[nodiscard]] bool over() const { return main_over_; }

 private:
  struct Fiber;
  struct Left;
  struct Leaving;
  friend int resume_with_answer(lua_State*, int, std::ptrdiff_t);

  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t new_size);
  static void count_hook(lua_State* L, lua_Debug*);
  static void ending_hook(lua_State* L, lua_Debug*);
  void count(lua_State* L, std::uint64_t instructions);
  void count_time(lua_State* L);
  void unwind(lua_State* L);
  void interrupt_now(std::string why = "Interrupted.");
  void broken_out();
  void prepare();
  bool load(std::string_view text);
  Fiber& add_fiber();
  Task<> carry(Fiber& fiber, Task<Answer> work);
  Task<> begin_at(Fiber& fiber, Instant when);
  void resume(Fiber& fiber, int arguments);
  void go_on(Fiber& fiber);
  void end_fiber(Fiber& fiber, int results);
  void fiber_failed(Fiber& fiber, int status);
  void take_turns();
  void act_now();
  void finish();
  void leave_all(const std::shared_ptr<Leaving>& leaving);
  static Task<> leave(std::shared_ptr<Leaving> leaving, std::size_t which);
  static Task<> see_stopped(Left& one);
  void tell_of_stops(const Leaving& leaving);
  void tell_notices();

  HybridScheduler& scheduler_;
  RunOptions options_;
  Instant began_{};
  Notes notes_;
  std::size_t memory_used_ = 0;
  lua_State* lua_ = nullptr;
  std::map<lua_State*, std::unique_ptr<Fiber>> fibers_;
  Fiber* main_ = nullptr;
  std::vector<std::shared_ptr<SessionGroup>> groups_;
  Event ended_, happened_;
  Instant next_frame_ = Instant::max();
  struct Act {
    Fiber* fiber;
    std::function<Answer()> act;
  };
  std::deque<Act> acts_;
  std::atomic<std::uint64_t> heartbeat_{0};
  std::atomic<bool> at_work_{false}, interrupt_asked_{false};
  WayOut way_out_{heartbeat_};
  std::chrono::steady_clock::time_point resumed_at_;
  std::uint64_t instructions_ = 0;
  Instant counted_since_{};
  bool main_over_ = false, ending_ = false;
  bool from_outside_ = false;  ///< the end came from outside of the script: what was done then is told
  bool broken_ = false;        ///< the Lua state was left by the way out
  std::shared_ptr<Leaving> leaving_;
  std::string failure_;  ///< why the run ended early; empty: it has not
};

}  // namespace hw::script
