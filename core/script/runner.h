#pragma once
// Runs one Lua script on the io thread. The script is a coroutine (a fiber): a call that waits suspends it,
// and everything else continues.
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
  // Without letting time advance:
  std::uint64_t instructions = 300'000'000;
  Duration computing = std::chrono::seconds(20);  ///< wall-clock time
};

struct RunOptions {
  std::string path;               ///< for messages; `require` looks in its folder
  std::vector<std::string> args;  ///< hw.args
  WireOpener opener;
  Limits limits;
  /// Results. A fault ends the script, as its results are no longer read.
  std::function<Result<>(std::string_view)> print;
  std::function<void(std::string_view)> log;  ///< hw.log, and the controllers' notices
  Stage* stage = nullptr;                     ///< a screen: `ui`, frames
  AxisUnits::Kept kept_unit;                  ///< units of the console; null: none kept
};

/// The result of a call that waited: pushes values, returns their number.
using Answer = std::function<int(lua_State*)>;

/// A function of the script that runs concurrently with the rest.
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

  /// Runs the script's text to its end, with frames of the stage in between. A fault gives FILE:LINE.
  Result<> run(std::string_view text);
  /// Called when time becomes real because the script opens a controller outside this process.
  std::function<void()> on_real_time;

  // ---- any thread, while run() is under way
  /// Ends the run now, whatever the script does, and sends a stop to all controllers.
  void interrupt();
  /// The same with another reason, a sentence.
  void give_up(std::string why);
  /// Whether the script computes. While it does, heartbeat() changes at least every 10,000 instructions.
  [[nodiscard]] bool at_work() const { return at_work_; }
  [[nodiscard]] std::uint64_t heartbeat() const { return heartbeat_; }
  /// Longest time for computing.
  [[nodiscard]] Duration patience() const { return options_.limits.computing; }
  /// Ends a script that hangs in one call of Lua's library, if heartbeat() still is `seen`. Repeat until
  /// at_work() is false: at some moments it cannot act.
  void break_out(std::uint64_t seen) { way_out_.take(seen); }

  // ---- for bindings (io thread, while the script runs)
  static Runner& of(lua_State* L);
  [[nodiscard]] HybridScheduler& scheduler() { return scheduler_; }
  [[nodiscard]] const RunOptions& options() const { return options_; }
  [[nodiscard]] double seconds_since_start() const { return seconds(scheduler_.now() - began_); }
  [[nodiscard]] Instant began() const { return began_; }
  /// Why the code on `L` cannot wait; null: it can.
  [[nodiscard]] const char* why_cannot_wait(lua_State* L) const;
  /// Starts `work`, for which the code on `L` is about to yield; its answer becomes the results of the call.
  void wait_for(lua_State* L, Task<Answer> work);
  /// Pops the function on top of `L`'s stack and runs it as a fiber of its own at `when`.
  void run_at(lua_State* L, Instant when);
  /// The same at once, with `arguments` that lie above the function. Leaves the coroutine in their place;
  /// keep it to get the results.
  std::shared_ptr<Spawned> spawn(lua_State* L, int arguments);
  /// Never resumes the function again. False: it is the caller itself, which runs now.
  bool cancel(const Spawned& one);
  /// Notified when a spawned function ends, by bindings, and at the end of the script.
  [[nodiscard]] Event& happened() { return happened_; }
  [[nodiscard]] Notes& notes() { return notes_; }
  /// Closed by C++ code while Lua calls it.
  [[nodiscard]] WayOut& way_out() { return way_out_; }
  /// Ends the whole run with this sentence; no pcall of the script catches it.
  void end_run(lua_State* L, std::string sentence);
  /// The same for wrong arguments of the script; `wrong` empty: only help was requested.
  void end_for_words(lua_State* L, std::string wrong);
  /// The same when results can no longer be delivered.
  void end_unread(lua_State* L, const Fault& why);
  void add(std::shared_ptr<SessionGroup> group);
  void remove(const std::shared_ptr<SessionGroup>& group);
  /// Suspends a waiting call; false: the script has ended.
  Task<bool> sleep_until(Instant when);
  void go_real();

  // ---- for the stage
  /// Suspends the code on `L` like wait_for(). `act` runs between two turns of the run, so that it may run
  /// frames itself.
  void act_between_turns(lua_State* L, std::function<Answer()> act);
  /// For such an act: runs all work up to the next frame, and draws that frame.
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
  void report_stops(const Leaving& leaving);
  void log_notices();

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
  bool main_over_ = false, ending_ = false;
  bool from_outside_ = false;  ///< ended from outside of the script: the message then reports the stops
  bool broken_ = false;        ///< the Lua state was left by the way out
  std::shared_ptr<Leaving> leaving_;
  std::string failure_;  ///< why the run ended early; empty: it did not
};

}  // namespace hw::script
