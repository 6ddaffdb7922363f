#pragma once
// Long pure jobs (a rehearsal, writing files) beside the frame: a job gets values and returns a value, which
// is handed to the GUI thread in one of its next frames. Without a thread (headless runs in virtual time,
// tests) the job is done when the values are handed over, so that every run is the same.
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>

namespace hw::gui {

class Worker {
 public:
  /// `wake`: any thread; a frame is wanted because a job is done. `threaded` false: jobs run in deliver().
  explicit Worker(std::function<void()> wake = {}, bool threaded = false)
      : wake_(std::move(wake)), threaded_(threaded) {}
  /// Waits for the job that is under way and for those that must not be lost (files); drops results.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// GUI thread. `done` is called from deliver() with what `job` returned; who may be gone by then guards
  /// himself with `alive`: a job of somebody gone still runs, its result is dropped.
  template <class Job, class Done>
  void run(Job job, Done done, std::weak_ptr<void> alive) {
    using Value = std::invoke_result_t<Job>;
    add([job = std::move(job), done = std::move(done), alive = std::move(alive)]() mutable -> Delivery {
      return [value = std::make_shared<Value>(job()), done = std::move(done),
              alive = std::move(alive)]() mutable {
        if (alive.lock()) done(std::move(*value));
      };
    });
  }
  /// GUI thread, once a frame. True: something was handed over.
  bool deliver();
  [[nodiscard]] bool idle();
  /// GUI thread. Waits until nothing is under way or waits; results stay for deliver(). For an end without
  /// destructors.
  void finish();

 private:
  using Delivery = std::function<void()>;
  using Task = std::function<Delivery()>;
  void add(Task task);
  void work();

  std::function<void()> wake_;
  const bool threaded_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> waiting_;
  std::deque<Delivery> finished_;
  bool working_ = false, ending_ = false;
  std::thread thread_;  // last: starts when everything above stands
};

}  // namespace hw::gui
