#include "core/device/transfer_progress.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/device/decision_log.h"

namespace hw {

void TransferProgress::begin(int slot, Instant now) {
  shown_ = TransferState();
  shown_.slot = static_cast<std::int8_t>(slot);
  shown_.running = true;
  began_ = reported_at_ = logged_ = now;
  work_done_ = work_left_ = 0;
}

void TransferProgress::enter(Phase phase, int lines) {
  shown_.phase = phase;
  shown_.done = 0;
  shown_.total = lines;
  shown_.left = Duration{};
}

// The first few units of work may be slow or fast by chance.
void TransferProgress::worked(Instant now) {
  constexpr int enough_work = 8;
  constexpr Duration enough_time = Millis(500), between_log_lines = std::chrono::seconds(5);
  ++work_done_;
  work_left_ = std::max(work_left_ - 1, 0);
  const Duration so_far = now - began_;
  const bool known = work_left_ > 0 && work_done_ >= enough_work && so_far >= enough_time;
  shown_.left = known ? so_far / work_done_ * work_left_ : Duration{};
  if (now - logged_ < between_log_lines) return;
  logged_ = now;
  write_log();
}

void TransferProgress::write_log() const {
  constexpr std::string_view verbs[] = {"read", "written", "compared"};
  const std::string of = shown_.total > 0 ? fmt::format(" of {}", shown_.total) : std::string();
  const std::string left =
      shown_.left > Duration{} ? fmt::format(", {:.0f} s left", seconds(shown_.left)) : std::string();
  driver_log(catalog_).add(log::Level::info,
                           fmt::format("{}: {}{} lines {}{}", LogName{catalog_}, shown_.done, of,
                                       verbs[static_cast<std::size_t>(shown_.phase)], left));
}

bool TransferProgress::is_news(Instant now) {
  const bool is = now - reported_at_ >= Millis(100);
  if (is) reported_at_ = now;
  return is;
}

void TransferProgress::end() {
  shown_.running = false;
  shown_.left = Duration{};
}

std::string report_written(const TransferState& t) {
  const bool compares = t.phase == TransferState::Phase::comparing;
  if (compares && t.total > 0)
    return fmt::format("all of its lines are written, and {} of {} {} compared", t.done, t.total,
                       t.total == 1 ? "was" : "were");
  if (compares) return "all of its lines are written, and were not compared";
  if (t.phase != TransferState::Phase::writing || t.total == 0) return {};
  if (t.total == 1)
    return t.done == 0 ? "its line may be written" : "its line is written, and was not compared";
  if (t.done == 0) return fmt::format("at most the first of its {} lines is written", t.total);
  if (t.done == 1) return fmt::format("the first of its {} lines is written", t.total);
  if (t.done == t.total)
    return fmt::format("all of its {} lines are written, and were not compared", t.total);
  return fmt::format("the first {} of its {} lines are written", t.done, t.total);
}

}  // namespace hw
