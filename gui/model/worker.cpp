#include "gui/model/worker.h"

#include <utility>

namespace hw::gui {

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  for (Lane* lane : {&long_, &short_})
    if (lane->thread.joinable()) lane->thread.join();
  for (Task& task : long_.waiting) task();  // without a thread
}

void Worker::add(Lane& lane, Task task) {
  {
    const std::lock_guard lock(mutex_);
    lane.waiting.push_back(std::move(task));
  }
  if (!threaded_) {
    if (wake_) wake_();
    return;
  }
  if (!lane.thread.joinable()) lane.thread = std::thread([this, &lane] { work(lane); });
  changed_.notify_all();
}

void Worker::work(Lane& lane) {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return ending_ || !lane.waiting.empty(); });
    if (lane.waiting.empty()) return;  // waiting jobs run even at the end: they may hold the user's text
    Task task = std::move(lane.waiting.front());
    lane.waiting.pop_front();
    lane.working = true;
    lock.unlock();
    Delivery delivery = task();
    lock.lock();
    lane.working = false;
    finished_.push_back(std::move(delivery));
    changed_.notify_all();  // wakes finish()
    if (wake_ && !ending_) wake_();
  }
}

bool Worker::deliver() {
  if (!threaded_ && long_.waiting.empty())
    return false;  // checked in each frame; even an empty deque allocates
  if (threaded_) {
    const std::lock_guard lock(mutex_);
    if (finished_.empty()) return false;
  }
  std::deque<Delivery> ready;
  if (!threaded_) {
    for (Task& task : std::exchange(long_.waiting, {})) ready.push_back(task());
  } else {
    const std::lock_guard lock(mutex_);
    ready.swap(finished_);
  }
  for (Delivery& delivery : ready) delivery();
  return !ready.empty();
}

void Worker::finish() {
  if (!threaded_) {
    deliver();
    return;
  }
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !long_.busy() && !short_.busy(); });
}

}  // namespace hw::gui
