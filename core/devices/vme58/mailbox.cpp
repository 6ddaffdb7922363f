#include "core/devices/vme58/mailbox.h"

#include <fmt/core.h>

#include "core/devices/vme58/codec.h"

namespace hw::vme58 {
namespace {

constexpr Duration mail_patience = Millis(50);
constexpr Duration mail_look = std::chrono::microseconds(500);

}  // namespace

/// Waits until the board has taken the previous mail (control register, bit 5). False: not in time.
Task<Result<bool>> Mailbox::is_free() {
  const Instant give_up = wire_.now() + mail_patience;
  for (;;) {
    std::vector<BusCycle>& cycles = wire_.burst();
    cycles.push_back(BusCycle::read(1, reg::control));
    auto looked = co_await wire_.run(cycles, Priority::stop);
    if (!looked) co_return fail(looked.error());
    if ((cycles.front().value & control::interrupt_board) == 0) co_return true;
    if (wire_.now() > give_up) co_return false;
    auto paused = co_await wire_.pause(mail_look);
    if (!paused) co_return fail(paused.error());
  }
}

// Reads the letters back, as mail lost by a silent bus would look taken once the bus answers again. Mail
// written over a word not yet taken may be lost, or replace that word. If the board never takes that word,
// the mail is written nevertheless, because it may be a stop.
Task<Result<>> Mailbox::mail(std::string_view letters) {
  const std::string word(letters);
  const auto free = co_await is_free();
  if (!free) co_return fail(free.error());
  std::vector<BusCycle>& cycles = wire_.burst();
  append_mail(cycles, word, wire_.enabled());
  const std::size_t letter = cycles.size();
  cycles.push_back(BusCycle::read(2, at::mailbox));
  cycles.push_back(BusCycle::read(2, at::mailbox + 2));
  auto sent = co_await wire_.run(cycles, Priority::stop);
  if (!sent) co_return sent;
  const std::string holds = reply_text(std::span(cycles).subspan(letter));
  wire_.record(Way::sent, Priority::stop, fmt::format("mailbox {}", word));
  const bool clears_all = word == "RS";  // including the letters
  if (holds != word && !clears_all)
    co_return fail(
        FaultKind::no_answer,
        fmt::format("{} was written into the board's mailbox, but the mailbox does not contain it.", word),
        "The bus may have lost it.", "Watch the machine. If it still moves, switch its power off.");
  const auto taken = co_await is_free();
  if (!taken) co_return fail(taken.error());
  if (*taken) co_return Result<>();
  co_return fail(FaultKind::no_answer, fmt::format("The board did not take {} out of its mailbox.", word),
                 "It was written there.", "Watch the machine. If it still moves, switch its power off.");
}

// Text taken by the board in between may have begun a motion, hence the second mail.
Task<Result<>> Mailbox::mail_past_ring(std::string_view letters) {
  const std::string word(letters);
  const bool known = conversation_.is_known();
  const bool overtakes = conversation_.is_under_way() || !known;
  auto mailed = co_await mail(word);
  if (!mailed && mailed.error().kind != FaultKind::no_answer) co_return mailed;
  if (!known) {
    const auto found = co_await conversation_.find_end(Priority::stop);
    if (!found) co_return mailed;  // there is no board, or it has not started yet
  }
  const auto taken = co_await conversation_.is_taken(Priority::stop);
  if (!taken) co_return fail(taken.error());
  if (*taken && !(mailed && overtakes)) co_return mailed;
  auto withdrawn = co_await conversation_.withdraw_all(Priority::stop);
  if (!withdrawn) co_return withdrawn;
  if (mailed) mailed = co_await mail(word);
  co_return mailed;
}

}  // namespace hw::vme58
