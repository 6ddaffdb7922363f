#include "core/devices/arcus/stored_lines.h"

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {
namespace {

constexpr int empty_lines_end_it = 4;    // in a row
constexpr std::uint8_t stored_code = 1;  // one text for all programs: see Snapshot::slots_torn

constexpr const char* torn = "What is stored now is neither the old program nor the new one.";
constexpr const char* mend_it = "Download it again before anything runs it.";

}  // namespace

// ---- one line

Task<Result<std::string>> StoredLines::read_line(int line, Priority priority) {
  co_return co_await talk_.ask(fmt::format("SA{}", line), priority);
}

// An unused line is empty.
Task<Result<>> StoredLines::write_line(int line, std::string text) {
  std::string sent = fmt::format("SA{}={}", line, text);
  const std::uint8_t before =
      std::exchange(console_.draft.slots_torn, stored_code);  // should the console be closed now
  auto written = co_await talk_.command(std::move(sent), Priority::transfer, Millis(500));
  // A stop that came first, or a refusal: this line is not stored.
  if (!written && was_kept_back(written.error())) console_.draft.slots_torn = before;
  co_return written;
}

// A line may be written twice: whether an answer was lost, or the line itself garbled on its way or back,
// reading it tells. `there` is what it was when it was read last.
Task<Result<>> StoredLines::store_line(int line, std::string text, std::string there) {
  constexpr int most_writes = 3;
  for (int writes = 0; there != text; ++writes) {
    if (writes == most_writes)
      co_return fail(FaultKind::controller,
                     fmt::format("Line {} reads back as \"{}\" instead of \"{}\".", line, there, text));
    auto written = co_await write_line(line, text);
    if (!written && !worth_another_try(written.error())) co_return written;
    auto back = co_await read_line(line, Priority::transfer);
    if (!back) co_return fail(back.error());
    there = std::move(*back);
  }
  co_return Result<>();
}

// ---- all of them

void StoredLines::show_transfer(int done, int total) {
  console_.draft.transfer.running = done < total;
  console_.draft.transfer.done = done;
  console_.draft.transfer.total = total;
}

Task<Result<std::vector<std::string>>> StoredLines::read() {
  std::vector<std::string> lines;
  int empty = 0;
  for (int n = 0; n < program_lines && empty < empty_lines_end_it; ++n) {
    auto text = co_await read_line(n, Priority::transfer);
    if (!text) co_return fail(text.error());
    empty = text->empty() ? empty + 1 : 0;
    lines.push_back(std::move(*text));
    show_transfer(n, program_lines);
    co_await live_.read();
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  co_return lines;
}

// Each line is read back at once; a line that is equal already is not written.
Task<Result<>> StoredLines::write(std::vector<std::string> lines) {
  const int total = static_cast<int>(lines.size());
  for (int n = 0; n < total; ++n) {
    auto there = co_await read_line(n, Priority::transfer);
    if (!there) co_return fail(there.error());
    auto stored = co_await store_line(n, lines[ix(n)], std::move(*there));
    if (!stored) co_return stored;
    show_transfer(n + 1, total);
    co_await live_.read();
  }
  co_return co_await clear_from(total);
}

// What a longer program has left behind.
Task<Result<>> StoredLines::clear_from(int line) {
  int empty = 0;
  code_.forget();
  for (int n = line; n < program_lines && empty < empty_lines_end_it; ++n) {
    auto there = co_await read_line(n, Priority::transfer);
    if (!there) co_return fail(there.error());
    if (there->empty()) {
      ++empty;
      continue;
    }
    empty = 0;
    auto cleared = co_await store_line(n, {}, std::move(*there));
    if (!cleared) co_return cleared;
    co_await live_.read();
  }
  console_.draft.slot_bytes_used[0] = static_cast<std::int16_t>(line);
  co_return Result<>();
}

tl::unexpected<Fault> StoredLines::broken_off(Fault why) {
  if (console_.draft.slots_torn == 0) return fail(std::move(why));
  console_.draft.slot_bytes_used[0] = -1;
  why.done = torn;
  why.advice = mend_it;
  return fail(std::move(why));
}

std::string StoredLines::leaves_behind() const {
  return console_.draft.slots_torn != 0 ? fmt::format("{} {}", torn, mend_it) : std::string();
}

}  // namespace hw::arcus
