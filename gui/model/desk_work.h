#pragma once
// Long jobs of one controller's desk: run by the console's worker, their results dropped once the desk is
// gone. GUI thread.
#include <memory>

#include "gui/model/worker.h"

namespace hw::gui {

class DeskWork {
 public:
  /// The worker for all jobs from now on; without one they run within the frame.
  void use(Worker* worker) { worker_ = worker; }
  [[nodiscard]] Worker& worker() { return worker_ ? *worker_ : own_worker_; }
  /// For Worker::run: expires with this object.
  [[nodiscard]] std::weak_ptr<void> alive() const { return alive_; }
  /// Once a frame: the results of jobs that ran within it.
  void deliver() {
    if (!worker_) own_worker_.deliver();
  }

 private:
  Worker own_worker_;
  Worker* worker_ = nullptr;
  std::shared_ptr<int> alive_ = std::make_shared<int>(0);
};

}  // namespace hw::gui
