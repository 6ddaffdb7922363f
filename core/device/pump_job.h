#pragma once
// What the parts of the pump share, and nobody else sees.
#include <exception>
#include <string>

#include <fmt/core.h>

#include "core/device/decision_log.h"
#include "core/device/pump.h"

namespace hw {

constexpr std::string_view stopped_first = "A stop came first. This was not sent.";

/// While a stop is owed, the wire is tried so often.
constexpr Duration retry_with_a_stop = Millis(250);

inline Fault failed_inside(const char* what, const std::exception& defect) {
  return Fault(FaultKind::internal, fmt::format("The {} failed inside: {}.", what, defect.what()),
               "What the controller did with it is not known.", "Look at its state before the next command.");
}

/// What a driver's procedure returns, or why it could not.
template <class T>
Task<Result<T>> guarded(const char* what, Task<Result<T>> procedure) {
  Result<T> result = fail(FaultKind::internal, std::string());
  try {
    result = co_await std::move(procedure);
  } catch (const std::exception& defect) {
    result = fail(failed_inside(what, defect));
  }
  co_return result;
}

/// The pump is not destroyed while somebody waits for an answer here.
class Pump::Asking {
 public:
  explicit Asking(Pump& pump) : pump_(pump) { ++pump_.asking_; }
  ~Asking() {
    --pump_.asking_;
    pump_.ended_.notify();
  }
  Asking(const Asking&) = delete;
  Asking& operator=(const Asking&) = delete;

 private:
  Pump& pump_;
};

}  // namespace hw
