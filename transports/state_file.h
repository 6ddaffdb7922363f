#pragma once
// The file of --state: an emulated controller's non-volatile memory. A worker thread writes it, so that the
// wire does not wait for the disk. Texts are written in order; the destructor waits for the last one.
#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/time/scheduler.h"

namespace hw {

/// Reports faults that are not the wire's, for a log or a status line. Io thread.
using Trouble = std::function<void(const Fault&)>;

class StateFile {
 public:
  StateFile(Scheduler& scheduler, std::string path, Trouble trouble);
  ~StateFile();
  /// Returns at once. On failure `trouble` is called, and the file keeps its previous text.
  void keep(std::string text);

 private:
  Scheduler& scheduler_;
  std::string path_;
  std::shared_ptr<Trouble> trouble_;
  asio::thread_pool worker_{1};
};

}  // namespace hw
