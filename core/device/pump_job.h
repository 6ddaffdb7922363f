#pragma once
// Internal to the pump: shared by its source files.
#include <exception>
#include <string>

#include <fmt/core.h>

#include "core/device/decision_log.h"
#include "core/device/pump.h"

namespace hw {

constexpr std::string_view was_closed = "The controller was closed. Nothing was sent.";
constexpr std::string_view queue_is_full = "Too many commands are queued already. This command was not sent.";
constexpr std::string_view does_not_answer = "The controller does not answer. Nothing was sent.";
constexpr std::string_view stopped_first = "A stop came first. The command was not sent.";

/// How often to reconnect while a stop is unconfirmed.
constexpr Duration retry_with_a_stop = Millis(250);

inline Fault failed_inside(const char* what, const std::exception& defect) {
  return Fault(FaultKind::internal, fmt::format("An internal error ended the {}: {}.", what, defect.what()),
               "Whether the controller carried it out is unknown.",
               "Check its state before the next command.");
}

/// Runs a driver's procedure; an exception becomes a fault.
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

/// Keeps the pump alive while a coroutine waits for an answer from it.
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

/// The job moves nothing and sets no count.
inline bool only_looks(const Job& job) {
  const IntentBody& body = job.intent.body;
  return job.meaning.only_asks || std::holds_alternative<intent::ReadParams>(body) ||
         std::holds_alternative<intent::ReadAnalog>(body) || std::holds_alternative<intent::Watch>(body) ||
         std::holds_alternative<intent::SetOutput>(body);
}

/// The places where the axes rest remain as they were seen.
inline bool only_handles_programs(const Job& job) {
  return std::holds_alternative<intent::LoadProgram>(job.intent.body) ||
         std::holds_alternative<intent::UploadProgram>(job.intent.body) ||
         std::holds_alternative<intent::RunProgram>(job.intent.body);
}

}  // namespace hw
