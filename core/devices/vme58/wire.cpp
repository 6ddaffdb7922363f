#include "core/devices/vme58/wire.h"

#include <fmt/core.h>

#include "core/device/driver_faults.h"
#include "core/devices/vme58/codec.h"

namespace hw::vme58 {
namespace {

constexpr int index_attempts = 3;

TrafficKind kind_of(Priority priority) {
  switch (priority) {
    case Priority::stop: return TrafficKind::stop;
    case Priority::intent: return TrafficKind::intent;
    case Priority::transfer: return TrafficKind::transfer;
    case Priority::poll: return TrafficKind::poll;
  }
  return TrafficKind::intent;
}

}  // namespace

Fault when_put(Fault why) {
  if (why.kind != FaultKind::stopped) return why;
  return Fault(FaultKind::no_answer, "A stop came while this command was under way.",
               "Whether the board has carried it out is unknown.");
}

tl::unexpected<Fault> no_connection() { return not_connected("board"); }

Wire::Wire(Scheduler& scheduler, std::function<void(Notice)> notify)
    : scheduler_(scheduler), notify_(std::move(notify)) {}

void Wire::attach(Station& station) {
  station_ = &station;
  enabled_ = station.reports_interrupts() ? control::interrupts | control::done_interrupt |
                                                control::limit_interrupt | control::slip_interrupt
                                          : 0;
}

std::vector<BusCycle>& Wire::burst() {
  cycles_.clear();
  return cycles_;
}

Task<Result<>> Wire::run(std::vector<BusCycle>& cycles, Priority priority) {
  if (!station_) co_return no_connection();
  if (!station_->is_window())
    co_return fail(FaultKind::refused, "A VME58 is a board in a memory window, not a device on a line.",
                   "Nothing was sent.", "Open it through vme or bus.");
  co_return co_await station_->bus(cycles, priority);
}

Task<Result<>> Wire::pause(Duration time) {
  if (!station_) co_return no_connection();
  co_return co_await station_->pause(time);
}

// Reads the index twice: if the values differ, the board is changing it, or a byte was garbled.
Task<Result<int>> Wire::read_index(std::uint16_t offset, Priority priority) {
  std::vector<BusCycle>& cycles = burst();
  for (int attempt = 0; attempt < index_attempts; ++attempt) {
    cycles.assign(2, BusCycle::read(2, offset));
    auto done = co_await run(cycles, priority);
    if (!done) co_return fail(done.error());
    if (cycles[0].value == cycles[1].value && is_index(cycles[0].value))
      co_return static_cast<int>(cycles[0].value);
  }
  co_return fail(
      FaultKind::garbled,
      fmt::format("An index of the rings reads {:04X}, which is not a valid index.", cycles[1].value),
      "It was read several times.", "Check the bus, and whether another program resets the board.");
}

bool Wire::perhaps_done(const Fault& why) const {
  return why.kind == FaultKind::no_answer && station_ && station_->preempted();
}

void Wire::record(Way way, Priority priority, std::string_view text) {
  if (!station_) return;
  while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
  station_->record(now(), way, kind_of(priority), text);
}

void Wire::record_unsolicited(std::string_view text) {
  if (station_) station_->record(now(), Way::received, TrafficKind::unsolicited, text);
}

void Wire::count_answer(Instant asked_at, bool poll) {
  if (station_) station_->count_answer(now() - asked_at, poll, now());
}

void Wire::count_miss() {
  if (station_) station_->count_miss();
}

void Wire::report(Notice::Kind kind, std::string text) { report(Notice(kind, now(), std::move(text))); }

void Wire::report(Notice notice) {
  if (notify_) notify_(std::move(notice));
}

}  // namespace hw::vme58
