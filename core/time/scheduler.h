#pragma once
// Links, drivers, emulators and scripts wait on a Scheduler, whose time is real or virtual. One thread, the
// io thread, runs it and all of them.
#include <functional>
#include <vector>

#include "core/base/asio.h"
#include "core/time/clock.h"

namespace hw {

class Scheduler;

/// One alarm with a fixed callback. Arming and disarming do not allocate. Destroying it disarms it.
class Timer {
 public:
  Timer(Scheduler& scheduler, std::function<void()> fire);
  ~Timer();
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  void arm(Instant when);  ///< replaces an earlier alarm
  void disarm();
  [[nodiscard]] bool armed() const { return place_ != none; }
  [[nodiscard]] Instant when() const { return when_; }

 private:
  friend class Scheduler;
  static constexpr std::size_t none = ~std::size_t{0};
  Scheduler& scheduler_;
  std::function<void()> fire_;
  Instant when_{};
  std::uint64_t order_ = 0;   // first armed, first fired among equals
  std::size_t place_ = none;  // index in the scheduler's heap
};

class Scheduler {
 public:
  virtual ~Scheduler();
  [[nodiscard]] virtual Instant now() const = 0;
  [[nodiscard]] Executor executor() const { return io_.get_executor(); }
  [[nodiscard]] IoContext& io() const { return io_; }

  /// Io thread. Resumes no earlier than `when`.
  Task<> sleep_until(Instant when);
  Task<> sleep_for(Duration d);

 protected:
  explicit Scheduler(IoContext& io) : io_(io) {}

  [[nodiscard]] bool has_alarms() const { return !heap_.empty(); }
  [[nodiscard]] Instant first_alarm() const { return heap_.front()->when_; }
  /// Fires each alarm that is due at `now`, earliest first.
  void fire_due(Instant now);
  /// Called when an alarm is armed that is earlier than all others.
  virtual void first_alarm_moved() = 0;

 private:
  friend class Timer;
  void insert(Timer& timer);
  void remove(Timer& timer);
  void sift_up(std::size_t i);
  void sift_down(std::size_t i);
  void put(std::size_t i, Timer* t);

  IoContext& io_;
  std::vector<Timer*> heap_;
  std::uint64_t armed_count_ = 0;
};

/// A condition that coroutines wait for. Io thread only.
class Event {
 public:
  explicit Event(Scheduler& scheduler) : scheduler_(scheduler) {}
  ~Event();  ///< wakes all waiters; they must not touch the event again
  Event(const Event&) = delete;
  Event& operator=(const Event&) = delete;
  /// True: notify() came. False: the deadline passed first.
  Task<bool> wait_until(Instant deadline);
  Task<> wait();
  /// Wakes all present waiters. Not remembered if there is none.
  void notify();

 private:
  struct Waiter;
  Scheduler& scheduler_;
  std::vector<Waiter*> waiters_;
};

}  // namespace hw
