#pragma once
// The board's window as the driver uses it: bursts of bus cycles, the record of what they said and heard, and
// what is told to whoever watches.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/device/snapshot.h"
#include "core/link/station.h"

namespace hw::vme58 {

tl::unexpected<Fault> no_connection();
/// Why a procedure has ended, where its text was put already and may be carried out.
Fault when_put(Fault why);

class Wire {
 public:
  Wire(Scheduler& scheduler, std::function<void(Notice)> notify);
  void attach(Station& station);
  void detach() { station_ = nullptr; }
  [[nodiscard]] bool is_open() const { return station_ != nullptr; }
  [[nodiscard]] Instant now() const { return scheduler_.now(); }
  /// The interrupts that the console has enabled, as they stand in the control register.
  [[nodiscard]] std::uint8_t enabled() const { return enabled_; }

  /// Empty, in memory that earlier ones have left. It is used up when the next one is begun.
  std::vector<BusCycle>& burst();
  Task<Result<>> run(std::vector<BusCycle>& cycles, Priority priority);
  Task<Result<>> pause(Duration time);
  Task<Result<int>> read_index(std::uint16_t offset, Priority priority);
  /// Something was put, and a stop came before more was known.
  [[nodiscard]] bool perhaps_done(const Fault& why) const;

  void record(Way way, Priority priority, std::string_view text);
  void record_unasked(std::string_view text);
  void count_answer(Instant asked_at, bool poll);
  void count_miss();
  void tell(Notice::Kind kind, std::string text);
  void tell(Notice notice);

 private:
  Scheduler& scheduler_;
  std::function<void(Notice)> notify_;
  Station* station_ = nullptr;
  std::vector<BusCycle> cycles_;
  std::uint8_t enabled_ = 0;
};

}  // namespace hw::vme58
