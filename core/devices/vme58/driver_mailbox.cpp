// Urgent commands go through the mailbox (decision M29): past the ring, past full queues.
#include <fmt/core.h>

#include "core/devices/vme58/driver.h"

namespace hw::vme58 {
namespace {

constexpr Duration mail_patience = Millis(50);
constexpr Duration mail_look = std::chrono::microseconds(500);

}  // namespace

/// The mailbox is free: the board has taken what stood in it (control register, bit 5). False: not in time.
Task<Result<bool>> Vme58Driver::mail_is_taken() {
  const Instant give_up = scheduler_.now() + mail_patience;
  for (;;) {
    std::vector<BusCycle>& cycles = burst();
    cycles.push_back(BusCycle::read(1, reg::control));
    auto looked = co_await run(cycles, Priority::stop);
    if (!looked) co_return fail(looked.error());
    if ((cycles.front().value & control::interrupt_board) == 0) co_return true;
    if (scheduler_.now() > give_up) co_return false;
    auto paused = co_await pause(mail_look);
    if (!paused) co_return fail(paused.error());
  }
}

// A word put over one that the board has not taken would be lost with its request, or instead of it. Behind
// a request that the board never takes back it is put there all the same: it may be a stop.
Task<Result<>> Vme58Driver::mail(std::string_view letters) {
  const std::string word(letters);
  const auto free = co_await mail_is_taken();
  if (!free) co_return fail(free.error());
  std::vector<BusCycle>& cycles = burst();
  append_mail(cycles, word, control_);
  auto sent = co_await run(cycles, Priority::stop);
  if (!sent) co_return sent;
  record(Way::sent, Priority::stop, fmt::format("mailbox {}", word));
  const auto taken = co_await mail_is_taken();
  if (!taken) co_return fail(taken.error());
  if (*taken) co_return Result<>();
  co_return fail(FaultKind::no_answer, fmt::format("The board did not take {} out of its mailbox.", word),
                 "It was put there.", "Watch the machine. If it still moves, switch its power off.");
}

/// What stands in the ring behind the word is taken back, whoever has put it there: taken from there a moment
/// later it would act behind it. What the board took in between may have begun something, hence the second.
Task<Result<>> Vme58Driver::mail_past_ring(std::string_view letters) {
  const std::string word(letters);
  const bool overtakes = on_its_way_ || !rings_known_;
  auto mailed = co_await mail(word);
  if (!mailed && mailed.error().kind != FaultKind::no_answer) co_return mailed;
  if (!rings_known_) {
    const auto put = co_await read_index(at::output_put_index, Priority::stop);
    if (!put) co_return mailed;  // what is there is no board, or one that has yet to start
    put_ = *put;
  }
  const auto taken = co_await is_taken(Priority::stop);
  if (!taken) co_return fail(taken.error());
  if (*taken && !(mailed && overtakes)) co_return mailed;
  const int everything = advanced(put_, 1 - ring_cells);
  auto withdrawn = co_await withdraw_text(Priority::stop, everything);
  if (!withdrawn) co_return withdrawn;
  if (mailed) mailed = co_await mail(word);
  co_return mailed;
}

}  // namespace hw::vme58
