#include "core/devices/arcus/stored_lines.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/base/index.h"

namespace hw::arcus {
namespace {

constexpr int empty_lines_end_it = 4;    // in a row
constexpr std::uint8_t stored_code = 1;  // one text for all programs: see Snapshot::slots_torn

constexpr const char* torn = "The stored code is now neither the old program nor the new one";
constexpr const char* mend_it = "Download the program again before it is run.";

// An unknown line is read before it is written: a question takes as little time as the reply to a write, and
// each write wears the flash; the manuals give no number of cycles. If this many lines in a row differ,
// another program is stored, and more questions would only cost time.
constexpr int other_lines_are_another_program = 4;

bool reads_first(int others_in_a_row) { return others_in_a_row < other_lines_are_another_program; }

}  // namespace

// ---- one line

Task<Result<std::string>> StoredLines::read_line(int line) {
  auto text = co_await conversation_.ask(fmt::format("SA{}", line), Priority::transfer);
  progress_.worked(console_.scheduler.now());
  if (text) code_.lines().was_read(line, *text);
  if (text && ix(line) < read_.size()) read_[ix(line)] = true;
  co_return text;
}

// An unused line is empty.
Task<Result<>> StoredLines::write_line(int line) {
  std::string sent = fmt::format("SA{}={}", line, wanted(line));
  read_[ix(line)] = false;
  const std::uint8_t before =
      std::exchange(console_.snapshot.slots_torn, stored_code);  // in case the console closes now
  auto written = co_await conversation_.command(std::move(sent), Priority::transfer, Millis(500));
  progress_.worked(console_.scheduler.now());
  // After an earlier stop or a refusal this line is not stored.
  if (!written && was_kept_back(written.error())) console_.snapshot.slots_torn = before;
  // Reading the line back shows whether the reply was lost or the line itself garbled.
  if (!written && worth_another_try(written.error())) co_return Result<>();
  co_return written;
}

const std::string& StoredLines::wanted(int line) const {
  static const std::string nothing;
  return ix(line) < wanted_.size() ? wanted_[ix(line)] : nothing;
}

bool StoredLines::is_there(int line) const {
  const std::string* held = code_.lines().known(line);
  return held && *held == wanted(line);
}

// ---- reading

Task<Result<std::vector<std::string>>> StoredLines::read() {
  doubt_stored();
  progress_.begin(0, console_.scheduler.now());
  auto lines = co_await read_all();
  progress_.end();
  known_at_ = faults_now();
  co_return lines;
}

Task<Result<std::vector<std::string>>> StoredLines::read_all() {
  const int used = std::max<int>(console_.snapshot.slot_bytes_used[0], 0);
  progress_.enter(TransferState::Phase::reading, used);
  if (used > 0) progress_.expect(used + empty_lines_end_it);
  std::vector<std::string> lines;
  int empty = 0;
  for (int n = 0; n < program_lines && empty < empty_lines_end_it; ++n) {
    auto text = co_await read_line(n);
    if (!text) co_return fail(text.error());
    empty = text->empty() ? empty + 1 : 0;
    lines.push_back(std::move(*text));
    if (used == 0 || n < used) progress_.line_done();
    co_await live_.read();
  }
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  co_return lines;
}

// ---- writing

Task<Result<int>> StoredLines::write(std::vector<std::string> lines) {
  wanted_ = std::move(lines);
  read_.assign(static_cast<std::size_t>(program_lines), false);
  differs_ = false;
  doubt_stored();
  progress_.begin(0, console_.scheduler.now());
  auto written = co_await write_all();
  progress_.end();
  if (written) console_.snapshot.slot_bytes_used[0] = static_cast<std::int16_t>(wanted_.size());
  known_at_ = faults_now();
  co_return written;
}

/// After a missed reply or unsolicited ones, other hosts may have written lines.
void StoredLines::doubt_stored() {
  if (known_at_ != faults_now()) code_.lines().forget();
}

void StoredLines::forget_stored() {
  code_.lines().forget();
  read_.assign(read_.size(), false);
}

Task<Result<int>> StoredLines::write_all() {
  constexpr int most_passes = 3;
  int count = 0;
  for (int pass = 1;; ++pass) {
    auto sent = co_await write_changed_lines();
    if (!sent) co_return fail(sent.error());
    count += written_;
    auto other = co_await compare_unread_lines();
    if (!other) co_return fail(other.error());
    if (!*other) co_return count;
    const OtherLine& found = **other;
    if (pass == most_passes)
      co_return fail(FaultKind::controller, fmt::format("Line {} reads back as \"{}\" instead of \"{}\".",
                                                        found.line, found.text, wanted(found.line)));
    if (written_ > 0) forget_stored();  // a garbled command may have written another line
  }
}

// Continues behind the end as far as a longer program may have left lines.
Task<Result<>> StoredLines::write_changed_lines() {
  const int total = static_cast<int>(wanted_.size());
  seen_ = written_ = 0;
  progress_.enter(TransferState::Phase::writing, total);
  progress_.expect(work_from(0, true));
  int others = 0, empty = 0;
  for (int n = 0; n < program_lines && (n < total || empty < empty_lines_end_it); ++n) {
    const bool behind = n >= total, asks = reads_first(others);
    if (!code_.lines().known(n) && (behind || asks)) {
      auto read = co_await read_line(n);
      if (!read) co_return fail(read.error());
      if (!is_there(n)) progress_.expect_more(2);
    }
    const bool there = is_there(n);
    if (behind) empty = there ? empty + 1 : 0;
    others = there ? 0 : others + 1;
    if (!there) {
      auto sent = co_await write_line(n);
      if (!sent) co_return sent;
      ++written_;
    }
    seen_ = n + 1;
    if (!behind || total == 0) progress_.line_done();
    if (!behind && reads_first(others) != asks) progress_.expect(not_read(n + 1) + work_from(n + 1, !asks));
    co_await live_.read();
  }
  co_return Result<>();
}

/// The number of lines not read, among the first `lines` lines.
int StoredLines::not_read(int lines) const {
  return static_cast<int>(std::count(read_.begin(), read_.begin() + lines, false));
}

/// The number of questions and commands from `line` to the end.
int StoredLines::work_from(int line, bool reads_unknown_first) const {
  int work = 0;
  for (int n = line; n < static_cast<int>(wanted_.size()); ++n) {
    const bool one_question = is_there(n) || (reads_unknown_first && !code_.lines().known(n));
    work += !one_question ? 2 : read_[ix(n)] ? 0 : 1;
  }
  return work;
}

/// The first line that differs from the wanted one.
Task<Result<std::optional<StoredLines::OtherLine>>> StoredLines::compare_unread_lines() {
  std::optional<OtherLine> other;
  progress_.enter(TransferState::Phase::comparing, not_read(seen_));
  progress_.expect(not_read(seen_));
  for (int n = 0; n < seen_; ++n) {
    if (read_[ix(n)]) continue;
    auto read = co_await read_line(n);
    if (!read) co_return fail(read.error());
    if (!other && *read != wanted(n)) other = OtherLine{n, std::move(*read)};
    differs_ = other.has_value();
    progress_.line_done();
    co_await live_.read();
  }
  co_return other;
}

// ---- remains of a broken transfer

std::string StoredLines::torn_code_words() const {
  const TransferState& t = console_.snapshot.transfer;
  const std::string written = report_written(t);
  if (written.empty() || differs_) return fmt::format("{}.", torn);
  if (t.phase == TransferState::Phase::comparing)
    return fmt::format("The stored code may not be the new program: {}.", written);
  return fmt::format("{}: {}, and the other lines are those of the old program.", torn, written);
}

tl::unexpected<Fault> StoredLines::broken_off(Fault why) {
  if (console_.snapshot.slots_torn == 0) return fail(std::move(why));
  console_.snapshot.slot_bytes_used[0] = -1;
  why.done = torn_code_words();
  why.advice = mend_it;
  return fail(std::move(why));
}

std::string StoredLines::leaves_behind() const {
  return console_.snapshot.slots_torn != 0 ? fmt::format("{} {}", torn_code_words(), mend_it) : std::string();
}

}  // namespace hw::arcus
