#include "core/devices/vme58/queues.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::vme58 {

Task<Result<>> Queues::read(Priority priority) {
  const bool were_empty = std::exchange(empty_, false);
  std::string text;
  for (const AxisInfo& axis : catalog_.axes) text += fmt::format("A{} RQ ", axis.name);
  text += fmt::format("AA RQ AM RQ {}\n", selection_.selector());
  const ReplyForm numbers{ReplyForm::Of::numbers};
  auto replies = co_await conversation_.ask_several(std::move(text), ix(axes()) + 2, priority, numbers);
  if (!replies && replies.error().kind == FaultKind::no_answer) {
    snapshot_.queue_known = 0;
    co_return Result<>();
  }
  if (!replies) co_return fail(replies.error());
  co_return take(*replies, were_empty);
}

Result<> Queues::take(const std::vector<std::string>& replies, bool were_empty) {
  Room room;
  room.were_empty = were_empty;
  for (std::size_t i = 0; i < replies.size(); ++i) {
    const auto numbers = decode_numbers(replies[i]);
    if (!numbers)
      return fail(FaultKind::garbled,
                  fmt::format("The board answered \"{}\" to RQ, which is not a valid reply.", replies[i]),
                  "It is asked again.");
    const auto free = [](std::int64_t entries) { return entries >= queue_entries; };
    if (std::all_of(numbers->begin(), numbers->end(), free)) room.all_free |= 1u << i;
    if (i >= ix(axes()) || numbers->size() != 1) continue;
    snapshot_.queue_free[i] = static_cast<std::int16_t>(numbers->front());
    snapshot_.queue_known |= 1u << i;
  }
  room.empty = empty_ = room.all_free == (1u << replies.size()) - 1;
  if (were_read) were_read(room);
  return {};
}

void Queues::show_full() {
  snapshot_.queue_known = 0;
  Context context = selection_.context();
  if (conversation_.waits_in_wq()) return;
  for (const TextCommand& command : read_commands(conversation_.last_sent(), context)) {
    if (!command.fact || command.fact->when != When::queued || command.context.mode != where::single)
      continue;
    snapshot_.queue_known = 1u << command.context.axis;
    snapshot_.queue_free[ix(command.context.axis)] = 0;
  }
}

void Queues::forget() {
  empty_ = false;
  snapshot_.queue_known = 0;
}

}  // namespace hw::vme58
