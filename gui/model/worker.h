#pragma once
// Runs long pure jobs (a rehearsal, writing files) outside the frame: a job takes values and returns a value,
// which is delivered to the GUI thread in one of its next frames. Without a thread (headless runs in virtual
// time, tests) jobs run in deliver(), so that every run is the same.
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
  /// `wake`: called on any thread when a finished job needs a frame. `threaded` false: jobs run in deliver().
  explicit Worker(std::function<void()> wake = {}, bool threaded = false)
      : wake_(std::move(wake)), threaded_(threaded) {}
  /// Waits for the present job and for jobs that must not be lost (files); drops results.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// GUI thread. deliver() calls `done` with the result of `job`. `alive` guards a caller that may be gone by
  /// then: the job still runs, its result is dropped.
  template <class Job, class Done>
  void run(Job job, Done done, std::weak_ptr<void> alive) {
    add(long_, task_of(std::move(job), std::move(done), std::move(alive)));
  }
  /// The same for a short job that the user waits for, such as a picture: it does not wait for long ones.
  template <class Job, class Done>
  void run_short(Job job, Done done, std::weak_ptr<void> alive) {
    add(threaded_ ? short_ : long_, task_of(std::move(job), std::move(done), std::move(alive)));
  }
  /// GUI thread, once a frame. True: a result was delivered.
  bool deliver();
  /// GUI thread. Waits until no job is running or waiting; results stay for deliver(). For an exit without
  /// destructors.
  void finish();

 private:
  using Delivery = std::function<void()>;
  using Task = std::function<Delivery()>;
  struct Lane {
    std::deque<Task> waiting;
    bool working = false;
    std::thread thread;
    [[nodiscard]] bool busy() const { return working || !waiting.empty(); }
  };
  template <class Job, class Done>
  static Task task_of(Job job, Done done, std::weak_ptr<void> alive) {
    using Value = std::invoke_result_t<Job>;
    return [job = std::move(job), done = std::move(done), alive = std::move(alive)]() mutable -> Delivery {
      return [value = std::make_shared<Value>(job()), done = std::move(done),
              alive = std::move(alive)]() mutable {
        if (alive.lock()) done(std::move(*value));
      };
    };
  }
  void add(Lane& lane, Task task);
  void work(Lane& lane);

  std::function<void()> wake_;
  const bool threaded_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Delivery> finished_;
  bool ending_ = false;
  Lane long_, short_;  // last: their threads start after all members above exist
};

}  // namespace hw::gui
