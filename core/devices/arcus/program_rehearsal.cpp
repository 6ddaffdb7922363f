#include "core/devices/arcus/program_rehearsal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/index.h"
#include "core/devices/arcus/language/compiler.h"
#include "core/devices/arcus/language/listing.h"
#include "core/devices/arcus/move_stream.h"
#include "core/devices/arcus/program_language.h"
#include "core/devices/arcus/program_places.h"
#include "core/devices/arcus/program_start.h"
#include "core/devices/arcus/program_watch.h"
#include "core/devices/arcus/sequence_reader.h"
#include "core/devices/arcus/sequence_writer.h"
#include "core/emulation/bench_file.h"
#include "core/emulation/bench_schedule.h"
#include "core/emulation/track_keeper.h"

namespace hw::arcus {
namespace {

constexpr int run_it = 1;

class Rehearsing {
 public:
  Rehearsing(ArcusEmulator& emulator, const language::Compilation& made, const RehearseOptions& options,
             const Catalog& catalog, const language::Dialect& dialect)
      : emulator_(emulator),
        controller_(emulator.controller()),
        made_(made),
        options_(options),
        catalog_(catalog),
        program_(std::clamp(options.slot, 0, controller_.model().programs - 1)),
        watch_(controller_, made, dialect),
        track_(emulator, options) {
    if (options.from) begin_like(emulator, *options.from, catalog);
    result_.program_size["0"] = static_cast<int>(made.lines.size());
    for (int i = 0; i < std::min(controller_.axes(), static_cast<int>(options.start_at.size())); ++i)
      (void)controller_.set_position(i, options.start_at[static_cast<std::size_t>(i)]);
    for (int i = 0; i < controller_.axes(); ++i) {
      RehearsedAxis axis;
      axis.name = std::string(1, controller_.model().axis_letters[static_cast<std::size_t>(i)]);
      axis.begin = axis.position = axis.minimum = axis.maximum = controller_.position(i);
      turned_[ix(i)] = controller_.axis(i).turned;
      result_.axes.push_back(std::move(axis));
    }
    result_.outputs_at_first = outputs();
  }

  Result<> set_bench() { return BenchSchedule::act(options_.bench, emulator_); }
  Result<> set_bench(const BenchFile& bench) { return bench_schedule_.begin(bench, emulator_); }

  Rehearsal run() {
    for (std::size_t n = 0; n < made_.lines.size(); ++n)
      controller_.set_program_line(static_cast<int>(n), made_.lines[n]);
    std::vector<Controller::Trace> trace;
    controller_.trace = &trace;
    controller_.control_program(program_, run_it);
    track_.look(now_);
    go_through(trace);
    controller_.trace = nullptr;
    return finish();
  }

 private:
  [[nodiscard]] bool moves() const {
    for (int i = 0; i < controller_.axes(); ++i)
      if (controller_.moving(i)) return true;
    return false;
  }
  [[nodiscard]] bool any_program_runs() const {
    for (int n = 0; n < controller_.model().programs; ++n)
      if (controller_.program_state(n) == static_cast<int>(language::ThreadState::running)) return true;
    return false;
  }

  /// The low-level line of the started program; -1: it has ended, or waits for a motion of an earlier line.
  [[nodiscard]] int command_at_work() const {
    if (controller_.program_state(program_) != static_cast<int>(language::ThreadState::running)) return -1;
    const int line = controller_.program_place(program_);
    if (line < 0 || ix(line) >= made_.program.code.size()) return -1;
    return made_.program.code[ix(line)].op == language::Opcode::wait ? -1 : line;
  }

  /// The statement after a DELAY runs in the turn in which the delay ends, so it is never seen as the next
  /// one.
  [[nodiscard]] bool ends_delay(int before) const {
    const auto& code = made_.program.code;
    return before >= 0 && code[ix(before)].op == language::Opcode::delay && ix(before + 1) < code.size() &&
           code[ix(before + 1)].op != language::Opcode::wait &&
           controller_.program_state(program_) == static_cast<int>(language::ThreadState::running) &&
           controller_.program_place(program_) != before;
  }

  /// Whether a line belongs to the started program: from its beginning to that of the next program,
  /// subroutines included.
  [[nodiscard]] bool is_of_started(int line) const {
    const auto& begins = made_.program.programs;
    const auto own = begins[ix(program_)];
    return line >= 0 && own && line >= *own &&
           std::none_of(begins.begin(), begins.end(),
                        [&](const auto& other) { return other && *other > *own && line >= *other; });
  }

  /// Runs until no program runs and nothing moves, or the time is over.
  void go_through(std::vector<Controller::Trace>& trace) {
    const Instant last = Instant(from_seconds(std::clamp(options_.for_seconds, 0.0, 1e9)));
    while (any_program_runs() || moves()) {
      std::optional<Instant> next =
          emulator_.next_event();  // each turn of an axis is one: extremes are exact
      for (const auto& other : {bench_schedule_.next(), track_.next()})
        if (other) next = std::min(next.value_or(*other), *other);
      if (!next || *next > last) return out_of_time(last, trace);
      const int command = command_at_work();
      result_.at_work(seconds(now_), command);
      now_ = std::max(now_, *next);
      emulator_.advance_to(now_);
      if (ends_delay(command)) result_.at_work(seconds(now_), command + 1);
      bench_schedule_.act_until(now_, emulator_);
      track_.look(now_);
      collect(trace);
    }
    result_.error = watch_.errors();
    result_.finished = result_.error.empty();
  }

  void out_of_time(Instant last, std::vector<Controller::Trace>& trace) {
    const bool nothing_comes = !emulator_.next_event() && !bench_schedule_.next();
    now_ = std::max(now_, last);
    emulator_.advance_to(now_);
    collect(trace);
    const ProgramWatch::Unfinished what = watch_.unfinished(nothing_comes);
    result_.error = what.sentence, result_.endless = what.endless;
  }

  void collect(std::vector<Controller::Trace>& trace) {
    for (Controller::Trace& t : trace) {
      const bool begins_a_motion = t.axes != 0 && t.limit == 0 && is_of_started(t.line);
      if (begins_a_motion) result_.at_work(seconds(t.at), t.line);
      if (watch_.observe(t)) event(t);
    }
    trace.clear();
    watch_.look_at_programs();
    for (const auto& [axis, position] : controller_.overwritten) stretch(result_.axes[ix(axis)], position);
    controller_.overwritten.clear();
    for (int i = 0; i < controller_.axes(); ++i) {
      RehearsedAxis& axis = result_.axes[static_cast<std::size_t>(i)];
      axis.position = controller_.position(i);
      stretch(axis, axis.position);
      const std::int64_t made = controller_.axis(i).turned;
      way_[ix(i)] += static_cast<double>(made - turned_[ix(i)]) / controller_.pulses_per_unit(i);
      turned_[ix(i)] = made;
      axis.travel = std::llround(way_[ix(i)]);
      const StatusBits& bits = controller_.model().status;
      const std::int64_t word = controller_.status(i);
      for (const int bit : {bits.plus_limit, bits.minus_limit})
        result_.limit_touched = result_.limit_touched || (bit != no_bit && (word >> bit & 1) != 0);
    }
  }

  static void stretch(RehearsedAxis& axis, std::int64_t position) {
    axis.minimum = std::min(axis.minimum, position);
    axis.maximum = std::max(axis.maximum, position);
  }

  void event(Controller::Trace& t) {
    using Line = RehearsedEvent::Line;
    const Line line = t.io.empty() ? Line::none : t.reads ? Line::looked_at : Line::switched;
    result_.add({seconds(t.at), std::move(t.what), 0, t.line, line, std::move(t.io), t.level});
  }

  Rehearsal finish() {
    result_.duration_s = seconds(now_);
    result_.track = track_.take();
    result_.moves = controller_.moves_begun;
    for (int i = 0; i < controller_.axes(); ++i)
      result_.axes[ix(i)].in_counts = controller_.settings().on(Setting::loop, i);
    result_.outputs = outputs();
    result_.stops = watch_.stops();
    if (options_.from) result_.assumptions = assumptions(*options_.from, catalog_, moved(), made_.program);
    return std::move(result_);
  }

  [[nodiscard]] std::map<std::string, int> outputs() const {
    std::map<std::string, int> all;
    for (int n = 1; n <= controller_.model().outputs; ++n)
      all[std::to_string(n)] = static_cast<int>(controller_.outputs() >> (n - 1) & 1);
    return all;
  }
  [[nodiscard]] std::uint32_t moved() const {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < result_.axes.size(); ++i)
      bits |= std::uint32_t{result_.axes[i].travel > 0} << i;
    return bits;
  }

  ArcusEmulator& emulator_;
  Controller& controller_;
  const language::Compilation& made_;
  const RehearseOptions& options_;
  const Catalog& catalog_;
  const int program_;  ///< the program that is started
  ProgramWatch watch_;
  BenchSchedule bench_schedule_;
  TrackKeeper track_;
  Instant now_{};
  std::array<std::int64_t, max_axes> turned_{};  ///< pulses made until the last look
  std::array<double, max_axes> way_{};           ///< in the unit of positions
  Rehearsal result_;
};

Result<> without_errors(const language::Compilation& made, const char* done) {
  for (const Problem& p : made.problems)
    if (p.error) return fail(FaultKind::text, "Line " + std::to_string(p.line + 1) + ": " + p.sentence, done);
  return {};
}

/// Refuses a text without the program to start, which would seem to succeed. An empty text has nothing to
/// start.
Result<> with_program(const language::Compilation& made, int wanted) {
  const auto& programs = made.program.programs;
  const auto start = ix(std::clamp(wanted, 0, static_cast<int>(programs.size()) - 1));
  if (made.lines.empty() || programs[start]) return {};
  std::string there;
  for (std::size_t n = 0; n < programs.size(); ++n)
    if (programs[n]) there += (there.empty() ? "PRG " : ", PRG ") + std::to_string(n);
  const std::string number = std::to_string(start);
  return fail(FaultKind::text,
              "There is no program " + number + " to start; the text has " +
                  (there.empty() ? "subroutines only" : there) + ". Write a PRG " + number +
                  (there.empty() ? " that calls them with GOSUB." : ", which may start others with SR."),
              "Nothing was rehearsed.");
}

}  // namespace

Result<Rehearsal> rehearse_program(std::string_view text, const RehearseOptions& options, Emulator& emulator,
                                   const Catalog& catalog, const language::Dialect& dialect) {
  auto* arcus = dynamic_cast<ArcusEmulator*>(&emulator);
  if (!arcus) return fail(FaultKind::internal, "The rehearsal has no controller.");
  const language::Compilation made = language::compile(text, dialect);
  if (auto good = without_errors(made, "Nothing was rehearsed."); !good) return fail(good.error());
  if (auto there = with_program(made, options.slot); !there) return fail(there.error());
  Rehearsing rehearsing(*arcus, made, options, catalog, dialect);
  if (auto done = rehearsing.set_bench(); !done) return fail(done.error());
  if (!options.bench_toml.empty()) {
    const auto bench = parse_bench_file(options.bench_toml, catalog);
    if (!bench) return fail(bench.error());
    if (auto done = rehearsing.set_bench(*bench); !done) return fail(done.error());
  }
  return rehearsing.run();
}

ProgramReport ProgramLanguage::analyse(std::string_view text, int /*slot*/) const {
  return analyse_program(text, dialect_);
}

Result<Rehearsal> ProgramLanguage::rehearse(std::string_view text, const RehearseOptions& options) const {
  const auto catalog = make_catalog_({});
  if (!catalog) return fail(catalog.error());
  auto emulator = make_emulator_({{"unaddressed", "yes"}});
  if (!emulator) return fail(emulator.error());
  return rehearse_program(text, options, **emulator, *catalog, dialect_);
}

Result<SequenceText> ProgramLanguage::write(const sequence::Sequence& sequence,
                                            const Catalog& catalog) const {
  return write_sequence(sequence, catalog, dialect_);
}

Result<SequenceText> ProgramLanguage::write_with_gaps(const sequence::Sequence& sequence,
                                                      const Catalog& catalog,
                                                      std::vector<RefusedStep>& refused) const {
  return write_sequence(sequence, catalog, dialect_, &refused);
}

Result<Pieces> ProgramLanguage::in_pieces(const sequence::Sequence& sequence, const Catalog& catalog,
                                          int from_step) const {
  if (auto has = has_step(sequence, from_step); !has) return fail(has.error());
  if (!catalog.move_list.columns.empty()) {
    const auto whole = write(sequence, catalog);
    if (!whole) return fail(whole.error());
    const ProgramReport report = analyse(whole->text, 0);
    const bool fits = std::all_of(report.cost.begin(), report.cost.end(),
                                  [&](const auto& c) { return c.second <= catalog.program.capacity; });
    if (!fits) {
      auto moves = stream_moves(sequence, catalog, from_step);
      if (!moves) return fail(moves.error());
      if (*moves) return std::move(**moves);
    }
  }
  return cut_by_text(*this, sequence, catalog, from_step);
}

Result<SequenceRead> ProgramLanguage::read(std::string_view text, const sequence::Sequence& frame,
                                           const Catalog& catalog) const {
  return read_sequence(text, frame, catalog, dialect_);
}

std::string ProgramLanguage::write_listing(const std::vector<std::string>& lines) const {
  return language::write_listing(lines, dialect_);
}

std::vector<AxisTarget> ProgramLanguage::places_in(std::string_view text, int start) const {
  return places_of_program(text, start, dialect_);
}

}  // namespace hw::arcus
