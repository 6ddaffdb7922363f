#pragma once
// The board's window as the driver uses it: bursts of bus cycles, the record of sent and received texts, and
// notices to the user.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/snapshot.h"
#include "core/link/station.h"

namespace hw::vme58 {

tl::unexpected<Fault> no_connection();
/// The fault of a procedure whose text was already put and may be carried out.
Fault when_put(Fault why);

class Wire {
 public:
  Wire(Scheduler& scheduler, std::function<void(Notice)> notify);
  void attach(Station& station);
  void detach() { station_ = nullptr; }
  [[nodiscard]] bool is_open() const { return station_ != nullptr; }
  [[nodiscard]] Instant now() const { return scheduler_.now(); }
  /// The interrupts enabled by the console, as bits of the control register.
  [[nodiscard]] std::uint8_t enabled() const { return enabled_; }

  /// An empty burst in reused memory; valid until the next call.
  std::vector<BusCycle>& burst();
  Task<Result<>> run(std::vector<BusCycle>& cycles, Priority priority);
  Task<Result<>> pause(Duration time);
  Task<Result<int>> read_index(std::uint16_t offset, Priority priority);
  /// Whether a text was put whose outcome a stop has left unknown.
  [[nodiscard]] bool perhaps_done(const Fault& why) const;

  void record(Way way, Priority priority, std::string_view text);
  void record_unsolicited(std::string_view text);
  void count_answer(Instant asked_at, bool poll);
  void count_miss();
  void report(Notice::Kind kind, std::string text);
  void report(Notice notice);

 private:
  Scheduler& scheduler_;
  std::function<void(Notice)> notify_;
  Station* station_ = nullptr;
  std::vector<BusCycle> cycles_;
  std::uint8_t enabled_ = 0;
};

}  // namespace hw::vme58
