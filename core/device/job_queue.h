#pragma once
// Commands and queries that wait for an open controller, and the one that is being performed. Io thread.
#include <algorithm>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "core/base/asio.h"
#include "core/device/intent.h"
#include "core/device/text_meaning.h"
#include "core/time/scheduler.h"

namespace hw {

/// An intent, or a query with its waiting coroutine.
struct Job {
  Intent intent;
  TextMeaning meaning;                ///< meaning of a text
  std::uint64_t line_epoch = 0;       ///< of a broadcast: Line::epoch() when it was queued
  std::uint32_t restarts_before = 0;  ///< restarts of the controller when it was queued
  std::uint64_t first_round = 0;      ///< the status round it waits for; see Pump::tool_is_seen_first()
  bool is_query = false;
  std::string text;
  Duration patience{};
  Result<std::string> reply{std::string()};
  std::uint64_t since = 0;  ///< unsolicited texts from this number on may answer it
  Suspended waiting_procedure;
  bool answered = false;
  explicit Job(Intent i) : intent(std::move(i)) {}
};

class JobQueue {
 public:
  [[nodiscard]] bool empty() const { return waiting_.empty(); }
  [[nodiscard]] bool full() const {
    constexpr std::size_t most = 64;
    return waiting_.size() >= most;
  }
  void push(std::unique_ptr<Job> job) { waiting_.push_back(std::move(job)); }
  [[nodiscard]] bool has(IntentId id) const {
    return std::any_of(waiting_.begin(), waiting_.end(),
                       [id](const auto& job) { return job->intent.id == id; });
  }
  /// Null: no such job waits.
  std::unique_ptr<Job> withdraw(IntentId id) {
    const auto found = std::find_if(waiting_.begin(), waiting_.end(),
                                    [id](const auto& job) { return job->intent.id == id; });
    if (found == waiting_.end()) return nullptr;
    auto job = std::move(*found);
    waiting_.erase(found);
    return job;
  }
  /// Removes and returns all waiting jobs.
  [[nodiscard]] std::deque<std::unique_ptr<Job>> take_all() { return std::exchange(waiting_, {}); }

  /// The queue must not be empty.
  [[nodiscard]] const Job& next() const { return *waiting_.front(); }
  /// Begins the next job, which is performed until end().
  std::unique_ptr<Job> begin() {
    auto job = std::move(waiting_.front());
    waiting_.pop_front();
    performed_ = job.get();
    return job;
  }
  void end() { performed_ = nullptr; }
  /// A restart was requested: the jobs that wait were meant for the controller after it.
  void restart_was_asked(std::uint32_t restarts) {
    for (const auto& job : waiting_) job->restarts_before = restarts;
  }
  [[nodiscard]] bool performs() const { return performed_ != nullptr; }
  [[nodiscard]] bool performs_for_all_on_the_wire() const {
    return performed_ != nullptr && performed_->meaning.addressee == TextMeaning::For::all;
  }

 private:
  std::deque<std::unique_ptr<Job>> waiting_;
  const Job* performed_ = nullptr;
};

}  // namespace hw
