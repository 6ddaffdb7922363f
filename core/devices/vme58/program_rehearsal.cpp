// A dry run on the emulated board, in virtual time: the text goes through the command ring as from a host,
// and the board notes each event with its time.
#include "core/devices/vme58/program_rehearsal.h"

#include <algorithm>
#include <array>
#include <deque>

#include <fmt/format.h>

#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/emulator.h"
#include "core/devices/vme58/emulator_vme58.h"
#include "core/devices/vme58/program_check.h"
#include "core/devices/vme58/program_start.h"
#include "core/devices/vme58/program_watch.h"
#include "core/emulation/bench_file.h"
#include "core/emulation/bench_schedule.h"
#include "core/emulation/track_keeper.h"

namespace hw::vme58 {
namespace {

constexpr int from_nowhere = -1;  ///< source of text sent by the rehearsal itself

int line_of(std::string_view text, std::size_t at) {
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

struct Line {
  int line;
  std::string command;
};

std::vector<Line> lines_of(const std::vector<TextCommand>& commands, std::string_view plain) {
  std::vector<Line> all;
  for (const TextCommand& command : commands)
    all.push_back({line_of(plain, command.begin), std::string(command.text)});
  return all;
}

std::vector<int> numbers_of(const std::vector<Line>& lines) {
  std::vector<int> all;
  for (const Line& line : lines) all.push_back(line.line);
  return all;
}

class Rehearsing {
 public:
  Rehearsing(Vme58Emulator& emulator, std::vector<Line> text, const Catalog& catalog,
             const RehearseOptions& options)
      : emulator_(emulator),
        board_(emulator.board()),
        options_(options),
        catalog_(catalog),
        last_(from_seconds(std::clamp(options.for_seconds, 0.0, 1e9))),
        text_(std::move(text)),
        track_(emulator, options),
        watch_(board_, numbers_of(text_)) {}

  Result<> set_bench() { return BenchSchedule::act(options_.bench, emulator_); }
  Result<> set_bench(const BenchFile& bench) { return bench_schedule_.begin(bench, emulator_); }

  Rehearsal run() {
    begin();
    while (true) {
      feed();
      listen();
      if (!result_.error.empty()) break;
      if (next_ == text_.size() && board_.idle()) {
        result_.finished = true;
        break;
      }
      if (!step()) {
        listen();
        if (result_.error.empty()) report_unfinished();
        break;
      }
      listen();
    }
    board_.record_to(nullptr);
    return finish();
  }

 private:
  void begin_like(const ControllerState& from) {
    for (const std::string& command : text_to_begin_like(from, catalog_, board_.variant())) {
      put(command + "\n");
      (void)take_replies();
    }
    stand_like(emulator_, from);
  }

  void begin() {
    bench_schedule_.count_from(now_);
    if (options_.from) begin_like(*options_.from);
    board_.record_to(&notes_);
    notes_.source = from_nowhere;
    for (int i = 0; i < std::min(axes(), static_cast<int>(options_.start_at.size())); ++i)
      put(fmt::format("A{} LP{}\n", axis_letters[ix(i)], options_.start_at[ix(i)]));
    put("AX\n");
    (void)take_replies();
    notes_.list.clear();
    board_.motion().measure_from_here();
    for (int i = 0; i < axes(); ++i) begin_[ix(i)] = board_.motion().position(i);
    result_.outputs_at_first = outputs();
    track_.look(now_);
  }
  void report_unfinished() {
    const ProgramWatch::Unfinished what = watch_.unfinished();
    result_.endless = what.endless;
    result_.error = "The text was still running when the rehearsal ended" +
                    (what.why.empty() ? std::string() : ": " + what.why) + ".";
    watch_.stopped(now_, what.source, result_.error);
  }
  [[nodiscard]] int axes() const { return board_.variant().axes(); }

  // ---- time and the bus

  /// Advances to the next event, so that each is noted at its own time. False: none before the end of the
  /// rehearsal.
  bool step() {
    std::optional<Instant> next = emulator_.next_event();
    for (const auto& other : {bench_schedule_.next(), track_.next()})
      if (other) next = std::min(next.value_or(*other), *other);
    const Instant end(last_);
    const bool some = next && *next <= end;
    result_.at_work(seconds(now_.time_since_epoch()), watch_.at_work());
    const Instant before = std::exchange(now_, some ? std::max(now_, *next) : std::max(now_, end));
    emulator_.advance_to(now_);
    bench_schedule_.act_until(now_, emulator_);
    track_.look(now_);
    // Advances the time if the board has endless events at one instant.
    const auto due = emulator_.next_event();
    if (some && now_ == before && due && *due <= now_) now_ += std::chrono::microseconds(1);
    return some;
  }
  std::uint32_t read(std::uint16_t offset) { return bus_cycle(emulator_, false, 2, offset); }
  void write(std::uint16_t offset, std::uint32_t value) { bus_cycle(emulator_, true, 2, offset, value); }

  [[nodiscard]] bool taken() { return read(at::output_get_index) == put_; }
  void put(std::string_view text) {
    for (const char c : text) {
      write(static_cast<std::uint16_t>(at::output_buffer + 2 * put_), static_cast<unsigned char>(c));
      put_ = (put_ + 1) % ring_cells;
    }
    write(at::output_put_index, put_);
  }

  std::string take_replies() {
    std::string text;
    const std::uint32_t end = read(at::input_put_index);
    while (get_ != end) {
      const char c = static_cast<char>(read(static_cast<std::uint16_t>(at::input_buffer + 2 * get_)));
      if (c != '\r' || (!text.empty() && text.back() != '\n')) text += c == '\r' ? '\n' : c;
      get_ = (get_ + 1) % ring_cells;
    }
    write(at::input_get_index, get_);
    std::string lines;
    for (const char c : text)
      if (c != '\n' || (!lines.empty() && lines.back() != '\n')) lines += c;
    return lines;
  }

  // ---- the host's side

  /// Feeds one command at a time, as the board takes them.
  void feed() {
    while (board_.powered() && !board_.booting()) {
      result_.sent_to_host += take_replies();
      if (next_ == text_.size() || !taken()) return;
      notes_.source = static_cast<int>(next_);
      put(text_[next_++].command + ";\n");
      listen();
      if (!result_.error.empty()) return;
    }
  }

  void listen() {
    for (const Note& note : notes_.list)
      if (result_.error.empty()) observe(note);
    notes_.list.clear();
  }
  void observe(const Note& note) {
    watch_.observe(note);
    switch (note.what) {
      case Note::What::moves:
        ++result_.moves;
        return event(note, fmt::format("{} moves", axis_letters[ix(note.number)]));
      case Note::What::rests:
        return event(note, fmt::format("{} rests at {}", axis_letters[ix(note.number)], note.position));
      case Note::What::done:
        return event(note, fmt::format("{} done at {}", axis_letters[ix(note.number)], note.position));
      case Note::What::limit:
        result_.limit_touched = true;
        return event(note, fmt::format("{} hit its {} limit switch", axis_letters[ix(note.number)],
                                       note.on ? "plus" : "minus"));
      case Note::What::looks:
        if (watch_.is_repeated(note)) return;
        return event_of(note, fmt::format("line {}", note.number), RehearsedEvent::Line::looked_at,
                        fmt::format("reads line {}: {}", note.number, note.on ? "low" : "high"));
      case Note::What::line: return switched(note, fmt::format("Out {}", note.number));
      case Note::What::aux: return switched(note, fmt::format("Aux {}", axis_letters[ix(note.number)]));
      case Note::What::rejected:
        if (note.source == from_nowhere) return;
        result_.error = fmt::format("Line {}: the board rejects \"{}\".", text_[ix(note.source)].line + 1,
                                    text_[ix(note.source)].command);
        watch_.stopped(note.at, note.source, result_.error);
        return event(note, result_.error);
      case Note::What::restarts:
        put_ = get_ = 0;  // both rings start again
        return event(note, "the board restarts");
    }
  }
  void event(const Note& note, std::string what) {
    result_.add({seconds(note.at.time_since_epoch()), std::move(what), 0, note.source});
  }

  void switched(const Note& note, const std::string& output) {
    event_of(note, output, RehearsedEvent::Line::switched, output + (note.on ? " on" : " off"));
  }
  void event_of(const Note& note, std::string name, RehearsedEvent::Line line, std::string what) {
    result_.add({seconds(note.at.time_since_epoch()), std::move(what), 0, note.source, line, std::move(name),
                 note.on ? 1 : 0});
  }

  Rehearsal finish() {
    result_.duration_s = seconds(now_.time_since_epoch());
    for (int i = 0; i < axes(); ++i) {
      const Span& span = board_.motion().axis(i).span;
      RehearsedAxis a;
      a.name = std::string(axis_letters.substr(ix(i), 1));
      a.position = board_.motion().position(i);
      a.begin = begin_[ix(i)];
      a.minimum = span.lowest, a.maximum = span.highest, a.travel = span.travel;
      result_.axes.push_back(std::move(a));
    }
    result_.outputs = outputs();
    result_.track = track_.take();
    result_.stops = watch_.stops();
    if (options_.from) result_.assumptions = assumptions(*options_.from, catalog_, moved());
    return std::move(result_);
  }

  [[nodiscard]] std::uint32_t moved() const {
    std::uint32_t bits = 0;
    for (int i = 0; i < axes(); ++i) bits |= std::uint32_t{board_.motion().axis(i).span.travel > 0} << i;
    return bits;
  }

  [[nodiscard]] std::map<std::string, int> outputs() const {
    const UserIo& io = board_.io();
    std::map<std::string, int> all;
    for (int line = 0; line < io_lines; ++line)
      if (io.is_output(line)) all[std::to_string(line)] = io.is_true(line) ? 1 : 0;
    for (int i = 0; i < axes(); ++i)
      all[std::to_string(first_auxiliary + i)] = static_cast<int>(io.aux_high() >> i & 1u);
    return all;
  }

  Vme58Emulator& emulator_;
  Board& board_;
  const RehearseOptions& options_;
  const Catalog& catalog_;
  const Duration last_;
  std::vector<Line> text_;
  std::size_t next_ = 0;  ///< index in text_ of the next command to send
  BenchSchedule bench_schedule_;
  TrackKeeper track_;
  ProgramWatch watch_;
  Notes notes_;
  std::uint32_t put_ = 0, get_ = 0;
  Instant now_{};
  std::array<std::int64_t, most_axes> begin_{};
  Rehearsal result_;
};

}  // namespace

Result<Rehearsal> rehearse_program(std::string_view text, const RehearseOptions& options) {
  const ProgramReport report = check_program(text);
  for (const Problem& p : report.problems)
    if (p.error)
      return fail(FaultKind::text, fmt::format("Line {}: {}", p.line + 1, p.sentence),
                  "Nothing was rehearsed.");
  const std::string plain = without_comments(text);
  Context context;
  const auto commands = read_commands(plain, context);
  auto made = make_emulator(options.device);
  if (!made) return fail(made.error());
  auto* emulator = dynamic_cast<Vme58Emulator*>(made->get());
  if (!emulator) return fail(FaultKind::internal, "The rehearsal has no board.");
  const auto catalog = make_catalog(options.device);
  if (!catalog) return fail(catalog.error());
  Rehearsing rehearsing(*emulator, lines_of(commands, plain), *catalog, options);
  if (auto done = rehearsing.set_bench(); !done) return fail(done.error());
  if (!options.bench_toml.empty()) {
    const auto bench = parse_bench_file(options.bench_toml, *catalog);
    if (!bench) return fail(bench.error());
    if (auto done = rehearsing.set_bench(*bench); !done) return fail(done.error());
  }
  Rehearsal result = rehearsing.run();
  result.program_size["0"] = static_cast<int>(text.size());
  return result;
}

}  // namespace hw::vme58
