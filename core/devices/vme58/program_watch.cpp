#include "core/devices/vme58/program_watch.h"

#include <algorithm>

#include <fmt/format.h>

namespace hw::vme58 {

static constexpr std::size_t most_stops = 200;

std::string ProgramWatch::line_words(int source) const {
  const int line = line_of(source);
  return line < 0 ? "the text" : fmt::format("line {}", line + 1);
}

void ProgramWatch::stopped(Instant at, int source, std::string reason, int axis, int direction) {
  if (stops_.size() == most_stops) return;
  const std::string name = axis < 0 ? std::string() : std::string(axis_letters.substr(ix(axis), 1));
  stops_.push_back({seconds(at.time_since_epoch()), line_of(source), name, direction, std::move(reason)});
}

void ProgramWatch::observe(const Note& note) {
  if (note.what == Note::What::moves) sent_by_[ix(note.number)] = note.source;
  if (note.what != Note::What::limit) return;
  stopped(note.at, sent_by_[ix(note.number)],
          fmt::format("Axis {} runs into its {} limit switch.", axis_letters[ix(note.number)],
                      note.on ? "plus" : "minus"),
          note.number, note.on ? 1 : -1);
}

bool ProgramWatch::is_repeated(const Note& look) {
  if (look.source < 0) return false;
  if (ix(look.source) >= last_look_.size()) last_look_.resize(ix(look.source) + 1, -1);
  const auto now = static_cast<signed char>(look.on);
  return std::exchange(last_look_[ix(look.source)], now) == now;
}

ProgramWatch::Unfinished ProgramWatch::of_queue(const CommandQueue& queue) const {
  const Command& now = *queue.current();
  if (const Command* head = queue.block_head()) {
    const std::string loop = fmt::format("the loop that begins in {}", line_words(head->source));
    if (head->op() == Op::WH) return {now.source, loop + " (WH) has no end", true};
    if (head->op() == Op::WS)
      return {now.source,
              fmt::format("{} goes on while line {} is low", loop, static_cast<int>(head->first())), false};
    return {now.source, loop + " had not ended", false};
  }
  if (now.op() == Op::SW)
    return {now.source,
            fmt::format("{} waits until line {} is high, and nothing switches it", line_words(now.source),
                        static_cast<int>(now.first())),
            false};
  return {now.source, line_words(now.source) + " was not finished", false};
}

int ProgramWatch::at_work() const {
  int earliest = -1;
  for (int context = 0; context < contexts; ++context)
    if (const Command* now = board_.task(context).queue.current(); now && now->source >= 0)
      earliest = earliest < 0 ? now->source : std::min(earliest, now->source);
  return earliest;
}

ProgramWatch::Unfinished ProgramWatch::unfinished() const {
  for (int context = 0; context < contexts; ++context)
    if (const CommandQueue& queue = board_.task(context).queue; queue.current() != nullptr)
      return of_queue(queue);
  for (int a = 0; a < board_.variant().axes(); ++a)
    if (board_.motion().moving(a)) {
      const int by = sent_by_[ix(a)];
      return {by, fmt::format("axis {} is still moving, started by {}", axis_letters[ix(a)], line_words(by)),
              !board_.motion().occupied(a)};
    }
  return {};
}

}  // namespace hw::vme58
