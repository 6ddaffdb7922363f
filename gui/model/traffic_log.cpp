#include "gui/model/traffic_log.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <ctime>

#include <fmt/core.h>

#include "gui/model/lower_case.h"

namespace hw::gui {
namespace {

constexpr std::size_t cached_lines = 512;  // more than any screen shows

/// "12 345": a thin space between groups from five figures on.
std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  if (digits.size() < 5) return digits;
  for (std::size_t i = digits.size() - 3; i > 0 && i < digits.size(); i -= std::min<std::size_t>(i, 3))
    digits.insert(i, "\u2009");
  return digits;
}

std::string_view without_end(std::string_view command) {
  while (!command.empty() && (command.back() == '\r' || command.back() == '\n')) command.remove_suffix(1);
  return command;
}

}  // namespace

DayClock DayClock::local(Instant now) {
  const auto wall = std::chrono::system_clock::now();
  const std::time_t whole = std::chrono::system_clock::to_time_t(wall);
  std::tm parts{};
  ::localtime_r(&whole, &parts);
  const auto fraction = wall - std::chrono::system_clock::from_time_t(whole);
  const Duration of_day = std::chrono::hours(parts.tm_hour) + std::chrono::minutes(parts.tm_min) +
                          std::chrono::seconds(parts.tm_sec) + fraction;
  return DayClock{of_day - now.time_since_epoch()};
}

std::string_view format_time_of_day(Duration t, bool millis, char (&out)[16]) {
  const auto ms = std::chrono::duration_cast<Millis>(t).count();
  const auto put = [&](int at, long long value, int digits) {
    for (int i = digits - 1; i >= 0; --i, value /= 10) out[at + i] = static_cast<char>('0' + value % 10);
  };
  put(0, ms / 3'600'000 % 24, 2);
  put(3, ms / 60'000 % 60, 2);
  put(6, ms / 1000 % 60, 2);
  put(9, ms % 1000, 3);
  out[2] = out[5] = ':';
  out[8] = '.';
  return {out, millis ? 12u : 8u};
}

void append_shown(std::string& out, std::string_view bytes, std::string_view open, std::string_view close) {
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7F) {
      out += c;
      continue;
    }
    out += open;
    switch (c) {
      case '\r': out += "cr"; break;
      case '\n': out += "lf"; break;
      case '\t': out += "tab"; break;
      case '\0': out += "nul"; break;
      default: {
        constexpr char digits[] = "0123456789ABCDEF";
        out += digits[byte >> 4];
        out += digits[byte & 15];
      }
    }
    out += close;
  }
}

void append_hex(std::string& out, std::string_view bytes) {
  constexpr char digits[] = "0123456789ABCDEF";
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (i > 0) out += ' ';
    out += digits[byte >> 4];
    out += digits[byte & 15];
  }
}

TrafficLog::TrafficLog(Explain explain, DayClock clock, Limits limits)
    : explain_(explain), clock_(clock), limits_(limits), cache_(cached_lines) {
  limits_.bytes = std::bit_ceil(limits.bytes);
  limits_.records = std::bit_ceil(limits.records);
  bytes_ = std::make_unique_for_overwrite<char[]>(limits_.bytes);
  records_.reserve(limits_.records);
}

// ---- incoming records

void TrafficLog::drain(TrafficRing& ring) {
  ring.drain([this](TrafficEntry& entry) { append(entry); });
  if (const std::uint64_t lost = ring.lost(); lost - lost_before_clear_ != lost_) {
    lost_ = lost - lost_before_clear_;
    ++version_;
  }
}

// A listing comes as one long reply, but is read line by line.
void TrafficLog::append(const TrafficEntry& entry) {
  constexpr std::size_t long_line = 80;
  std::string_view rest = entry.bytes;
  if (entry.way == Way::received && rest.size() > long_line)
    for (auto end = rest.find('\r'); end != rest.npos && end + 1 < rest.size(); end = rest.find('\r')) {
      keep(entry.at, entry.way, entry.kind, rest.substr(0, end + 1));
      rest.remove_prefix(end + 1);
    }
  for (const std::size_t piece = limits_.bytes / 8; rest.size() > piece; rest.remove_prefix(piece))
    keep(entry.at, entry.way, entry.kind, rest.substr(0, piece));
  if (!rest.empty()) keep(entry.at, entry.way, entry.kind, rest);
}

void TrafficLog::keep(Instant at, Way way, TrafficKind kind, std::string_view bytes) {
  const std::size_t mask = limits_.bytes - 1;
  std::uint64_t begin = next_byte_;
  if ((begin & mask) + bytes.size() > limits_.bytes) begin = (begin | mask) + 1;  // never across its end
  next_byte_ = begin + bytes.size();
  if (next_ - first_ == limits_.records) ++first_;
  while (first_ < next_ && record(first_).begin + limits_.bytes < next_byte_) ++first_;
  std::memcpy(bytes_.get() + (begin & mask), bytes.data(), bytes.size());
  if (records_.size() < limits_.records) records_.emplace_back();
  Record& r = records_[next_ & (limits_.records - 1)];
  r.at = at;
  r.begin = begin;
  r.size = static_cast<std::uint32_t>(bytes.size());
  r.way = way;
  r.kind = kind;
  ++next_;
  ++version_;
}

std::string_view TrafficLog::bytes_of(const Record& r) const {
  return {bytes_.get() + (r.begin & (limits_.bytes - 1)), r.size};
}

void TrafficLog::clear() {
  first_ = next_;
  lost_before_clear_ += lost_;
  lost_ = 0;
  open_folds_.clear();
  restart_rows();
}

// ---- rows

void TrafficLog::set_view(View view) {
  if (view == view_) return;
  const bool same_rows = view.fold_polls == view_.fold_polls && view.filter == view_.filter &&
                         (view.filter.empty() || (view.decoded == view_.decoded && view.hex == view_.hex));
  view_ = std::move(view);
  filter_ = lower_case(view_.filter);
  for (Cached& c : cache_) c.valid = false;
  ++version_;
  if (!same_rows) restart_rows();
}

void TrafficLog::restart_rows() {
  rows_.clear();
  fold_ = no_fold;
  rows_up_to_ = first_;
  looking_back_ = !filter_.empty();
  ++version_;
}

void TrafficLog::toggle(const Row& fold) {
  if (!open_folds_.erase(fold.first)) open_folds_.insert(fold.first);
  restart_rows();
}

void TrafficLog::drop_old_rows() {
  while (!rows_.empty() && rows_.front().last < first_) {
    rows_.pop_front();
    if (fold_ != no_fold) fold_ = fold_ == 0 ? no_fold : fold_ - 1;
  }
  rows_up_to_ = std::max(rows_up_to_, first_);
}

bool TrafficLog::update_rows() {
  drop_old_rows();
  std::size_t looked_at = 0;
  version_ += rows_up_to_ < next_;
  for (; rows_up_to_ < next_; ++rows_up_to_) {
    if (filter_.empty()) {
      add_row(rows_up_to_);
      continue;
    }
    // Old records are searched in slices; new ones are never delayed, so in a flood they are judged by their
    // bytes alone.
    const bool may_explain = looked_at++ < limits_.explained_per_frame;
    if (!may_explain && looking_back_) return true;
    if (passes(rows_up_to_, may_explain))
      rows_.push_back({rows_up_to_, rows_up_to_, 0, RowKind::record, false});
  }
  looking_back_ = false;
  return false;
}

void TrafficLog::add_row(std::uint64_t n) {
  const TrafficKind kind = record(n).kind;
  if (view_.fold_polls && kind == TrafficKind::poll) return add_poll(n);
  if (view_.fold_polls && kind == TrafficKind::transfer) return add_transfer(n);
  fold_ = no_fold;
  rows_.push_back({n, n, 0, RowKind::record, false});
}

void TrafficLog::extend(Row& fold, std::uint64_t n) {
  fold.last = n;
  fold.sent += record(n).way == Way::sent;
}

void TrafficLog::add_poll(std::uint64_t n) {
  if (fold_ == no_fold || rows_[fold_].kind != RowKind::folded_polls) {
    fold_ = rows_.size();
    rows_.push_back({n, n, 0, RowKind::folded_polls, open_now(n)});
  }
  extend(rows_[fold_], n);
  if (rows_[fold_].open) rows_.push_back({n, n, 0, RowKind::record, false});
}

// The first two lines and the last one of a program transfer stay visible.
void TrafficLog::add_transfer(std::uint64_t n) {
  const Row row{n, n, 0, RowKind::record, false};
  const auto single = [&](std::size_t back, std::uint64_t wanted) {
    const Row& r = rows_[rows_.size() - back];
    return r.kind == RowKind::record && r.first == wanted && record(wanted).kind == TrafficKind::transfer;
  };
  const bool joins =
      fold_ != no_fold && rows_[fold_].kind == RowKind::folded_transfer && rows_[fold_].last + 2 == n;
  if (!joins) {
    fold_ = no_fold;
    const bool third =
        rows_.size() >= 3 && n >= 3 && single(1, n - 1) && single(2, n - 2) && single(3, n - 3);
    if (!third) return rows_.push_back(row);
    fold_ = rows_.size() - 1;
    rows_.insert(rows_.end() - 1, {n - 1, n - 1, 0, RowKind::folded_transfer, open_now(n - 1)});
  }
  extend(rows_[fold_], n - 1);
  if (!rows_[fold_].open) rows_.pop_back();
  rows_.push_back(row);
}

bool TrafficLog::passes(std::uint64_t n, bool by_meaning) const {
  std::string text;
  append_shown(text, bytes_of(record(n)), "<", ">");
  if (view_.hex) append_hex(text += '\n', bytes_of(record(n)));
  if (view_.decoded && by_meaning) (text += '\n') += meaning_of(n);
  return lower_case(text).find(filter_) != std::string::npos;
}

// ---- words

std::string_view TrafficLog::asked_before(std::uint64_t n) const {
  constexpr std::uint64_t far_enough = 64;  // a long reply is kept in pieces
  for (std::uint64_t back = 1; back <= far_enough && n >= first_ + back; ++back)
    if (const Record& r = record(n - back); r.way == Way::sent) return bytes_of(r);
  return {};
}

std::string TrafficLog::meaning_of(std::uint64_t n) const {
  if (!explain_) return {};
  const Record& r = record(n);
  const bool answer = r.way == Way::received && r.kind != TrafficKind::unsolicited;
  return explain_(bytes_of(r), r.way, r.kind, answer ? asked_before(n) : std::string_view());
}

// The sentence of a visible fold is rebuilt at each poll: in place, without heap allocations.
void TrafficLog::append_fold_sentence(std::string& out, const Row& row) const {
  const auto end = std::back_inserter(out);
  if (row.kind == RowKind::folded_transfer) {
    fmt::format_to(end, "{} more lines of the transfer folded.",
                   grouped(std::max<std::uint64_t>(row.sent, 1)));
    return;
  }
  if (row.sent == 0) {
    out += "The rest of a poll folded.";
    return;
  }
  fmt::format_to(end, "{} poll{}", grouped(row.sent), row.sent == 1 ? "" : "s");
  constexpr std::uint64_t enough = 64;
  std::array<std::string_view, 4> names;
  std::size_t known = 0;
  const std::uint64_t begin = std::max(row.first, first_);
  for (std::uint64_t n = begin; n <= std::min(row.last, begin + enough) && known < names.size(); ++n) {
    if (record(n).way != Way::sent) continue;
    const std::string_view name = without_end(bytes_of(record(n)));
    if (std::find(names.begin(), names.begin() + known, name) != names.begin() + known) continue;
    out += known == 0 ? " of " : ", ";
    append_shown(out, name);
    names[known++] = name;
  }
  out += " folded.";
}

const TrafficLog::Line& TrafficLog::line(const Row& row) {
  Cached& c = cache_[row.first % cached_lines];
  const bool same = c.valid && c.row.first == row.first && c.row.last == row.last && c.row.kind == row.kind &&
                    c.row.sent == row.sent;
  if (same) return c.line;
  c.row = row;
  c.valid = true;
  Line& line = c.line;
  line.raw.clear();
  line.meaning.clear();
  if (row.kind != RowKind::record) {
    line.time.clear();
    append_fold_sentence(line.raw, row);
    return line;
  }
  const Record& r = record(row.first);
  line.way = r.way;
  line.kind = r.kind;
  char time[16];
  line.time = format_time_of_day(clock_.of(r.at), true, time);
  if (view_.hex)
    append_hex(line.raw, bytes_of(r));
  else
    append_shown(line.raw, bytes_of(r));
  if (view_.decoded) line.meaning = meaning_of(row.first);
  return line;
}

void TrafficLog::append_record(std::string& out, std::uint64_t n, std::string_view meaning) const {
  const Record& r = record(n);
  char time[16];
  out += format_time_of_day(clock_.of(r.at), true, time);
  out += r.way == Way::sent ? " > " : " < ";
  if (view_.hex)
    append_hex(out, bytes_of(r));
  else
    append_shown(out, bytes_of(r), "<", ">");
  if (!meaning.empty()) (out += "    ") += meaning;
  out += '\n';
}

void TrafficLog::append_rows(std::string& out, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < std::min(end, rows_.size()); ++i) {
    const Row& row = rows_[i];
    if (row.last < first_) continue;
    if (row.kind == RowKind::record) {
      append_record(out, row.first, line(row).meaning);
    } else {
      append_fold_sentence(out, row);
      out += '\n';
    }
  }
}

std::string TrafficLog::text_of_all() const {
  std::string out;
  if (lost_ > 0) out = fmt::format("{} entries are missing: they came too fast.\n", lost_);
  for (std::uint64_t n = first_; n < next_; ++n)
    append_record(out, n, view_.decoded ? meaning_of(n) : std::string());
  return out;
}

}  // namespace hw::gui
