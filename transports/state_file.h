#pragma once
// The file of --state: the non-volatile memory of an emulated controller. A worker thread writes it, so that
// the wire does not wait for the disk. Texts are written in order. The destructor waits for the last text.
#include <boost/asio/thread_pool.hpp>
#include <functional>
#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/time/scheduler.h"

namespace hw {

/// Receives faults other than those of the wire, for a log or a status line. Io thread.
using Trouble = std::function<void(const Fault&)>;

class StateFile {
 public:
  StateFile(Scheduler& scheduler, std::string path, Trouble trouble);
  ~StateFile();
  /// Writes the text; returns at once. On failure `trouble` is called, and the file keeps its previous text.
  void keep(std::string text);

 private:
  Scheduler& scheduler_;
  std::string path_;
  std::shared_ptr<Trouble> trouble_;
  asio::thread_pool worker_{1};
};

}  // namespace hw
