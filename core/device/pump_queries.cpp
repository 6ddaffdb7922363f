// Questions: raw texts of scripts and `send` that return their reply.
#include <memory>
#include <string>

#include <fmt/core.h>

#include "core/device/pump_job.h"

namespace hw {

TextMeaning Pump::meaning_of(const std::string& text) const {
  return driver_->meaning_of(intent::SendText(text));
}

Task<Result<std::string>> Pump::query(std::string text, Duration patience) {
  const Asking asking(*this);
  const TextMeaning meaning = meaning_of(text);
  if (meaning.addressee == TextMeaning::For::another && callbacks_.line)
    if (Pump* other = callbacks_.line->at(meaning.address))
      co_return co_await other->query(std::move(text), patience);
  if (meaning.is_stop()) {
    if (meaning.addressee == TextMeaning::For::all && callbacks_.line)
      callbacks_.line->for_each_but(*this, [&](Pump& other) { other.note_broadcast(text, meaning); });
    co_return co_await query_stop(std::move(text), meaning, patience);
  }
  if (leaves()) co_return fail(FaultKind::refused, "The controller was closed.", "Nothing was sent.");
  const bool lost = snapshot_.link.state == LinkState::lost || snapshot_.link.state == LinkState::closed;
  if (lost) co_return fail(FaultKind::lost, "There is no connection to the controller.", "Nothing was sent.");
  auto owned = std::make_unique<Job>(Intent(0, intent::SendText(text)));
  Job* job = owned.get();
  job->is_query = true;
  job->meaning = meaning;
  job->text = std::move(text);
  job->patience = patience;
  enqueue(std::move(owned));
  const std::uint64_t epoch = desk_.epoch();
  while (!job->answered) co_await job->waiting_procedure.here();
  std::unique_ptr<Job> mine(job);
  if (!mine->reply || meaning.answered != TextMeaning::Answered::later) co_return std::move(mine->reply);
  co_return co_await add_late_replies(std::move(*mine->reply), mine->since, epoch, patience);
}

/// The first of several commands in one text may have been answered already.
Task<Result<std::string>> Pump::add_late_replies(std::string reply, std::uint64_t since, std::uint64_t epoch,
                                                 Duration patience) {
  auto text = co_await wait_for_text(since, epoch, patience);
  if (reply.empty()) co_return text;
  if (text) (reply += '\r') += *text;
  co_return std::move(reply);
}

/// Waits for the controller's message that the action of a text has ended.
Task<Result<std::string>> Pump::wait_for_text(std::uint64_t since, std::uint64_t epoch, Duration patience) {
  const Instant deadline = scheduler_.now() + patience;
  for (bool in_time = true;;) {
    if (desk_.epoch() != epoch)
      co_return fail(FaultKind::stopped, "A stop ended the wait for the reply.", "The command was sent.");
    if (auto text = texts_.answer_since(since)) co_return std::move(*text);
    if (!connected() || closes())
      co_return fail(FaultKind::lost, "The connection was lost before a reply came.");
    if (!in_time)
      co_return fail(FaultKind::no_answer, fmt::format("No reply came within {:g} s.", seconds(patience)));
    in_time = co_await published_.wait_until(deadline);
  }
}

}  // namespace hw
