#pragma once
// The file behind --state: an emulated controller's non-volatile memory. A worker thread writes it, so that
// the wire does not wait for the disk; texts are written in their order, the last one before destruction
// ends.
#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/time/scheduler.h"

namespace hw {

/// What went wrong beside the wire, for a log or a status line. Io thread.
using Trouble = std::function<void(const Fault&)>;

class StateFile {
 public:
  StateFile(Scheduler& scheduler, std::string path, Trouble trouble);
  ~StateFile();
  /// Returns at once. A failure is told to `trouble`; the file then still holds the text before.
  void keep(std::string text);

 private:
  Scheduler& scheduler_;
  std::string path_;
  std::shared_ptr<Trouble> trouble_;
  asio::thread_pool worker_{1};
};

}  // namespace hw
