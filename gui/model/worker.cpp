#include "gui/model/worker.h"

#include <utility>

namespace hw::gui {

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
  for (Task& task : waiting_) task();
}

void Worker::add(Task task) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(task));
  }
  if (!threaded_) {
    if (wake_) wake_();
    return;
  }
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
  changed_.notify_one();
}

void Worker::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    if (waiting_.empty()) return;  // waiting jobs run even at the end: they may hold the user's text
    Task task = std::move(waiting_.front());
    waiting_.pop_front();
    working_ = true;
    lock.unlock();
    Delivery delivery = task();
    lock.lock();
    working_ = false;
    finished_.push_back(std::move(delivery));
    changed_.notify_all();  // wakes finish()
    if (wake_ && !ending_) wake_();
  }
}

bool Worker::deliver() {
  if (!threaded_ && waiting_.empty()) return false;  // checked in each frame; even an empty deque allocates
  if (threaded_) {
    const std::lock_guard lock(mutex_);
    if (finished_.empty()) return false;
  }
  std::deque<Delivery> ready;
  if (!threaded_) {
    for (Task& task : std::exchange(waiting_, {})) ready.push_back(task());
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
  changed_.wait(lock, [this] { return waiting_.empty() && !working_; });
}

bool Worker::idle() {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && finished_.empty() && !working_;
}

}  // namespace hw::gui
