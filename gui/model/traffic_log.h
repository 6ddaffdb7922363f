#pragma once
// The terminal's record of one wire, in bounded memory: with times of day, polls folded, filtered, and
// explained only where visible. Drained from the session's ring once a frame, whatever is on the screen. GUI
// thread.
//
//   records_   ring of fixed records, oldest overwritten     bytes_   ring of their bytes
//   rows_      what is drawn: a record, or a fold of many; made from the records as they come
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/device/registry.h"
#include "core/link/traffic.h"

namespace hw::gui {

/// Time of day of an Instant: known where the scheduler was started.
struct DayClock {
  Duration at_zero{};  ///< time of day when the scheduler stood at 0
  [[nodiscard]] Duration of(Instant t) const {
    constexpr Duration day = std::chrono::hours(24);
    return ((at_zero + t.time_since_epoch()) % day + day) % day;
  }
  /// From the computer's clock, local time.
  static DayClock local(Instant now);
};
/// "14:02:04.951" or, without milliseconds, "14:02:04". Fits 16 bytes.
std::string_view format_time_of_day(Duration time_of_day, bool millis, char (&out)[16]);

class TrafficLog {
 public:
  struct Limits {
    std::size_t bytes = 8u << 20, records = 1u << 17;
    std::size_t explained_per_frame = 4096;  ///< while a filter searches meanings
  };
  using Explain = std::string (*)(std::string_view bytes, Way way, TrafficKind kind, std::string_view asked);

  explicit TrafficLog(Explain explain, DayClock clock = {}) : TrafficLog(explain, clock, Limits()) {}
  TrafficLog(Explain explain, DayClock clock, Limits limits);

  /// Once a frame. Takes all waiting entries; the oldest records are dropped to make room.
  void drain(TrafficRing& ring);
  void append(const TrafficEntry& entry);
  void clear();

  // ---- what is shown
  struct View {
    bool decoded = true;
    bool fold_polls = true;
    bool hex = false;
    std::string filter;  ///< case-insensitive; searches the bytes as shown and, when decoded, the meaning
    bool operator==(const View&) const = default;
  };
  [[nodiscard]] const View& view() const { return view_; }
  void set_view(View view);
  /// Brings the rows up to date. True while older records are still being searched.
  bool update_rows();

  enum class RowKind : std::uint8_t { record, folded_polls, folded_transfer };
  struct Row {
    std::uint64_t first = 0, last = 0;  ///< sequence numbers of records; equal for a single one
    std::uint32_t sent = 0;             ///< folded: number of records sent
    RowKind kind = RowKind::record;
    bool open = false;  ///< folded and opened: its records follow
  };
  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }
  [[nodiscard]] const Row& row(std::size_t i) const { return rows_[i]; }
  /// Opens or closes a fold.
  void toggle(const Row& fold);

  struct Line {
    Way way = Way::sent;
    TrafficKind kind = TrafficKind::intent;
    std::string time;     ///< "14:02:04.951"
    std::string raw;      ///< as shown: escaped, or hex. Of a fold: "2916 polls of X, Y, V folded."
    std::string meaning;  ///< empty when not decoded
  };
  /// The words of a row. Few rows are visible: made when drawn, kept until they change.
  const Line& line(const Row& row);

  [[nodiscard]] std::uint64_t records() const { return next_ - first_; }
  [[nodiscard]] std::uint64_t first_record() const { return first_; }
  /// A record as it was on the wire. `n`: from first_record() on, records() of them; valid until the next
  /// drain().
  struct Entry {
    Instant at{};
    Way way = Way::sent;
    TrafficKind kind = TrafficKind::intent;
    std::string_view bytes;
  };
  [[nodiscard]] Entry entry(std::uint64_t n) const {
    const Record& r = record(n);
    return {r.at, r.way, r.kind, bytes_of(r)};
  }
  /// Entries that arrived faster than they could be taken, missing from the log.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  /// Changes whenever the rows may have changed.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] DayClock clock() const { return clock_; }
  void set_clock(DayClock clock) { clock_ = clock; }

  /// Appends rows as text with times to `out`: for the clipboard, scripts and screen readers.
  void append_rows(std::string& out, std::size_t begin, std::size_t end);
  /// All kept records, unfolded, as text: time, direction, raw, meaning.
  std::string text_of_all() const;

 private:
  struct Record {
    Instant at{};
    std::uint64_t begin = 0;  ///< in the endless stream of bytes
    std::uint32_t size = 0;
    Way way = Way::sent;
    TrafficKind kind = TrafficKind::intent;
  };
  static constexpr std::size_t no_fold = ~std::size_t{0};
  [[nodiscard]] const Record& record(std::uint64_t n) const { return records_[n & (limits_.records - 1)]; }
  [[nodiscard]] std::string_view bytes_of(const Record& r) const;
  void keep(Instant at, Way way, TrafficKind kind, std::string_view bytes);
  void restart_rows();
  void drop_old_rows();
  void add_row(std::uint64_t n);
  void add_poll(std::uint64_t n);
  void add_transfer(std::uint64_t n);
  void extend(Row& fold, std::uint64_t n);
  [[nodiscard]] bool open_now(std::uint64_t first) const { return open_folds_.contains(first); }
  [[nodiscard]] bool passes(std::uint64_t n, bool by_meaning) const;
  [[nodiscard]] std::string meaning_of(std::uint64_t n) const;
  [[nodiscard]] std::string_view asked_before(std::uint64_t n) const;
  void append_fold_sentence(std::string& out, const Row& row) const;
  void append_record(std::string& out, std::uint64_t n, std::string_view meaning) const;

  Explain explain_;
  DayClock clock_;
  Limits limits_;
  // Reserved in full; the pages are allocated only as they fill.
  std::unique_ptr<char[]> bytes_;
  std::vector<Record> records_;
  std::uint64_t first_ = 0, next_ = 0;  ///< records kept: [first_, next_)
  std::uint64_t next_byte_ = 0;         ///< length of the endless stream
  std::uint64_t lost_ = 0, lost_before_clear_ = 0, version_ = 0;
  View view_;
  std::string filter_;  ///< in lower case
  std::deque<Row> rows_;
  std::size_t fold_ = no_fold;    ///< the row that the next record may join
  std::uint64_t rows_up_to_ = 0;  ///< records before this one have their row
  bool looking_back_ = false;     ///< a filter is still searching older records
  std::unordered_set<std::uint64_t> open_folds_;
  struct Cached {
    Row row;
    bool valid = false;
    Line line;
  };
  std::vector<Cached> cache_;
};

/// Bytes in readable form: printable ASCII as it is, others as a name or hex between the two marks.
void append_shown(std::string& out, std::string_view bytes, std::string_view open = "\xE2\x80\xB9",
                  std::string_view close = "\xE2\x80\xBA");
void append_hex(std::string& out, std::string_view bytes);

}  // namespace hw::gui
