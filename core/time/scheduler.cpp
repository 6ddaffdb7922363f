#include "core/time/scheduler.h"

#include <algorithm>

namespace hw {

Timer::Timer(Scheduler& scheduler, std::function<void()> fire)
    : scheduler_(scheduler), fire_(std::move(fire)) {}
Timer::~Timer() { disarm(); }

void Timer::arm(Instant when) {
  disarm();
  when_ = when;
  scheduler_.insert(*this);
}
void Timer::disarm() {
  if (armed()) scheduler_.remove(*this);
}

Scheduler::~Scheduler() {
  for (Timer* t : heap_) t->place_ = Timer::none;
}

static bool earlier(Instant a, std::uint64_t a_order, Instant b, std::uint64_t b_order) {
  return a != b ? a < b : a_order < b_order;
}

void Scheduler::put(std::size_t i, Timer* t) {
  heap_[i] = t;
  t->place_ = i;
}
void Scheduler::sift_up(std::size_t i) {
  Timer* t = heap_[i];
  while (i > 0) {
    Timer* parent = heap_[(i - 1) / 2];
    if (!earlier(t->when_, t->order_, parent->when_, parent->order_)) break;
    put(i, parent);
    i = (i - 1) / 2;
  }
  put(i, t);
}
void Scheduler::sift_down(std::size_t i) {
  Timer* t = heap_[i];
  for (;;) {
    std::size_t child = 2 * i + 1;
    if (child >= heap_.size()) break;
    if (child + 1 < heap_.size() &&
        earlier(heap_[child + 1]->when_, heap_[child + 1]->order_, heap_[child]->when_, heap_[child]->order_))
      ++child;
    if (!earlier(heap_[child]->when_, heap_[child]->order_, t->when_, t->order_)) break;
    put(i, heap_[child]);
    i = child;
  }
  put(i, t);
}
void Scheduler::insert(Timer& timer) {
  timer.order_ = ++armed_count_;
  heap_.push_back(&timer);
  sift_up(heap_.size() - 1);
  if (timer.place_ == 0) first_alarm_moved();
}
void Scheduler::remove(Timer& timer) {
  const std::size_t i = timer.place_;
  timer.place_ = Timer::none;
  Timer* last = heap_.back();
  heap_.pop_back();
  if (last == &timer) return;
  put(i, last);
  sift_up(i);
  sift_down(last->place_);
}
void Scheduler::fire_due(Instant now) {
  while (!heap_.empty() && heap_.front()->when_ <= now) {
    Timer& timer = *heap_.front();
    remove(timer);
    timer.fire_();
  }
}

// One suspended coroutine. It lives in the coroutine's own frame, so waiting allocates nothing of ours.
struct Event::Waiter {
  Event* event;  // null once finished: the event may be gone before the coroutine runs again
  Suspended suspended;
  bool notified = false;
  Timer timer;

  explicit Waiter(Event& e) : event(&e), timer(e.scheduler_, [this] { finish(false); }) {
    event->waiters_.push_back(this);
  }
  ~Waiter() {
    if (event) std::erase(event->waiters_, this);
  }
  void finish(bool by_notify) {
    timer.disarm();
    notified = by_notify;
    Event* const was = std::exchange(event, nullptr);
    std::erase(was->waiters_, this);
    suspended.resume(was->scheduler_.executor());
  }
};

Event::~Event() { notify(); }

Task<bool> Event::wait_until(Instant deadline) {
  Waiter waiter(*this);
  if (deadline != Instant::max()) waiter.timer.arm(deadline);
  co_await waiter.suspended.here();
  co_return waiter.notified;
}
Task<> Event::wait() { co_await wait_until(Instant::max()); }

void Event::notify() {
  while (!waiters_.empty()) waiters_.front()->finish(true);
}

Task<> Scheduler::sleep_until(Instant when) {
  Suspended sleeper;
  Timer alarm(*this, [this, &sleeper] { sleeper.resume(executor()); });
  alarm.arm(when);
  co_await sleeper.here();
}
Task<> Scheduler::sleep_for(Duration d) { co_await sleep_until(now() + d); }

}  // namespace hw
