#include "core/devices/vxm/program_rehearsal.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/base/index.h"
#include "core/devices/vxm/catalog.h"
#include "core/devices/vxm/emulator_vxm.h"
#include "core/devices/vxm/program_analysis.h"
#include "core/devices/vxm/program_start.h"
#include "core/devices/vxm/program_watch.h"
#include "core/devices/vxm/report.h"
#include "core/emulation/bench_file.h"
#include "core/emulation/bench_schedule.h"
#include "core/emulation/track_keeper.h"

namespace hw::vxm {
namespace {

constexpr int most_yields = 100'000;  // in a row, a millisecond each

std::string error_sentence(char letter) {
  const std::string name = std::string("E") + letter + ": ";
  switch (letter) {
    case error_memory: return name + "the text does not fit into the 256 bytes of its program.";
    case error_loops: return name + "more than ten loops were open at once.";
    case error_jumps: return name + "more than four JM jumps were open at once.";
    case error_nonstop:
      return name + "nonstop indexing met a command that is not allowed there, another motor, or no U9.";
    default: return name + "the controller stopped with an error.";
  }
}

/// The event that a wait waits for, in words.
std::string waited_for(const Wait& wait) {
  const std::string of_slave = wait.on_slave ? " of the Slave" : "";
  switch (wait.u) {
    case 32: return "the Jog 1- button" + of_slave;
    case 33: return "the Jog 1+ button" + of_slave;
    case 90: return "the Run button" + of_slave;
    case 13:
    case 23: return "one of the buttons Jog 1-, Jog 1+ and Run" + of_slave;
    default: return "input 1" + of_slave;
  }
}

class Rehearsing {
 public:
  Rehearsing(const Analysis& analysis, const RehearseOptions& options, const Catalog& catalog)
      : analysis_(analysis),
        options_(options),
        catalog_(catalog),
        motors_(static_cast<int>(catalog.axes.size())),
        emulator_(emulator_options(motors_)),
        track_(emulator_, options),
        watch_(analysis) {}

  Result<> set_bench() { return BenchSchedule::act(options_.bench, emulator_); }
  Result<> set_bench(const BenchFile& bench) { return bench_schedule_.begin(bench, emulator_); }

  Rehearsal run() {
    Box& box = emulator_.box();
    emulator_.receive("F");
    if (options_.from)
      begin_like(emulator_, *options_.from, catalog_, [this](int slot) { return text_fills(slot); });
    emulator_.receive(selecting(options_.slot) + analysis_.script);
    started_ = slot_to_run();
    emulator_.receive(selecting(started_));
    for (int i = 0; i < program_count; ++i)
      if (box.program(i).used() > 0) result_.program_size[std::to_string(i)] = box.program(i).used();
    if (box.error() != 0) {
      result_.error = error_sentence(box.error());
      return finish();
    }
    std::string before;
    emulator_.take_output(before);
    for (int i = 0; i < motors_; ++i) {
      Box& owner = i < motors_per_controller ? box : *box.slave();
      if (const auto begin = begins_at(i))
        owner.set_counter(i % motors_per_controller, wrap_position(*begin));
      begin_[ix(i)] = axis(i).counter;
    }
    outputs_seen_ = output_bits();
    result_.outputs_at_first = outputs();
    box.trace = &trace_;
    emulator_.receive("R");
    track_.look(now_);
    go_through();
    box.trace = nullptr;
    return finish();
  }

 private:
  static std::string selecting(int slot) { return "PM" + std::to_string(slot) + ","; }
  /// The slot of the text's R; without R the requested slot, unless the text leaves that empty.
  [[nodiscard]] int slot_to_run() {
    if (analysis_.run_slot >= 0) return analysis_.run_slot;
    const bool holds_it = options_.slot >= 0 && options_.slot < program_count;
    return holds_it && !emulator_.box().program(options_.slot).empty() ? options_.slot : analysis_.last_slot;
  }
  [[nodiscard]] bool text_fills(int slot) const {
    return slot == options_.slot || analysis_.programs.contains(slot);
  }
  static EmulatorOptions emulator_options(int motors) {
    EmulatorOptions options;
    options.motors = motors;
    return options;
  }

  [[nodiscard]] std::optional<std::int64_t> begins_at(int motor) const {
    if (ix(motor) < options_.start_at.size()) return options_.start_at[ix(motor)];
    if (!options_.from || motor >= options_.from->now.axis_count) return std::nullopt;
    const AxisState& axis = options_.from->now.axes[ix(motor)];
    return axis.position_known ? std::optional(axis.commanded().value) : std::nullopt;
  }

  /// Runs until the program ends, stops for good, or its time is over.
  void go_through() {
    Box& box = emulator_.box();
    const Instant last = Instant(from_seconds(std::clamp(options_.for_seconds, 0.0, 1e9)));
    collect();
    int yields = 0;
    while (box.running()) {
      if (box.run().doing == Doing::for_host) {
        event(now_, "the host answers W with G", -1, -1);
        box.go();
        box.settle();
        collect();
        continue;
      }
      std::optional<Instant> next = emulator_.next_event();
      const auto hand = bench_schedule_.next();
      for (const auto& other : {hand, track_.next()})
        if (other && (!next || *other < *next)) next = other;
      // A loop that takes no time would only use up the rest of the time.
      const bool empty_loop = box.run().doing == Doing::yielding && !hand;
      yields = empty_loop ? yields + 1 : 0;
      if (!next || *next > last || yields > most_yields) return out_of_time(last);
      now_ = std::max(now_, *next);
      emulator_.advance_to(now_);
      bench_schedule_.act_until(now_, emulator_);
      track_.look(now_);
      collect();
    }
    result_.finished = box.error() == 0;
    if (box.error() == 0) return;
    result_.error = error_sentence(box.error());
    result_.stops.push_back(watch_.stop(now_, result_.error));
  }

  void out_of_time(Instant last) {
    const Box& box = emulator_.box();
    const Run& run = box.run();
    const std::string program = "Program " + std::to_string(run.stack.empty() ? 0 : run.stack.back().program);
    if (run.doing == Doing::waiting)
      result_.error = program + " waits in U" + std::to_string(run.wait.u + (run.wait.on_slave ? 100 : 0)) +
                      " for " + waited_for(run.wait) + ", and nothing switches it.";
    else
      result_.error = still_running(program);
    now_ = std::max(now_, last);
    result_.stops.push_back(watch_.stop(now_, result_.error));
    if (run.doing != Doing::yielding) emulator_.advance_to(now_);
    collect();
  }

  [[nodiscard]] std::string still_running(const std::string& program) {
    const std::string loop = watch_.loop_words(emulator_.box());
    result_.endless = watch_.endless(emulator_.box());
    return program + " was still running when the rehearsal ended" + (loop.empty() ? "." : ": " + loop + ".");
  }

  void event(Instant t, std::string what, int slot, int command) {
    result_.add({seconds(t), std::move(what), slot, command});
  }
  void event_of(std::string name, RehearsedEvent::Line line, int level, std::string what) {
    result_.add({seconds(now_), std::move(what), -1, -1, line, std::move(name), level});
  }

  void collect() {
    Box& box = emulator_.box();
    for (Trace& t : trace_) {
      watch_.observe(t, box);
      if (t.program == started_) result_.at_work(seconds(t.at), t.command);
      event(t.at, std::move(t.what), t.program, t.command);
    }
    trace_.clear();
    note_lines();
    if (result_.events.size() > Rehearsal::most_events) box.trace = nullptr;
    result_.moves = box.moves_begun();
    emulator_.take_output(result_.sent_to_host);
    if (box.limit_was_hit()) result_.limit_touched = true;
  }

  /// Notes switched outputs, and waits for inputs.
  void note_lines() {
    const unsigned now = output_bits(), before = std::exchange(outputs_seen_, now);
    for (int i = 0; now != before && i < outputs_count(); ++i) {
      if (((now ^ before) >> i & 1u) == 0) continue;
      const std::string name = "output " + std::to_string(i + 1);
      const bool on = (now >> i & 1u) != 0;
      event_of(name, RehearsedEvent::Line::switched, on ? 1 : 0, name + (on ? " on" : " off"));
    }
    const Run& run = emulator_.box().run();
    const bool waits = run.doing == Doing::waiting;
    if (waits == std::exchange(waits_, waits) || !emulator_.box().running()) return;
    if (waits) waited_for_ = waited_for(run.wait);
    event_of(waited_for_, waits ? RehearsedEvent::Line::waits : RehearsedEvent::Line::comes, 0,
             waits ? "waits for " + waited_for_ : "goes on");
  }

  [[nodiscard]] const Axis& axis(int motor) {
    const Box& owner = motor < motors_per_controller ? emulator_.box() : *emulator_.box().slave();
    return owner.axis(motor % motors_per_controller);
  }

  Rehearsal finish() {
    result_.duration_s = seconds(now_);
    result_.track = track_.take();
    for (int i = 0; i < motors_; ++i) {
      const Axis& now = axis(i);
      RehearsedAxis a;
      a.name = std::to_string(i + 1);
      a.position = now.counter, a.minimum = now.lowest, a.maximum = now.highest, a.travel = now.travelled;
      a.begin = begin_[ix(i)];
      result_.axes.push_back(std::move(a));
    }
    result_.outputs = outputs();
    result_.stops.insert(result_.stops.begin(), watch_.stops().begin(), watch_.stops().end());
    if (options_.from) assume(*options_.from);
    return std::move(result_);
  }

  [[nodiscard]] int outputs_count() const {
    return motors_ > motors_per_controller ? 2 * outputs_per_controller : outputs_per_controller;
  }
  /// Bit n: output n+1 is on; those of the Slave behind the controller's own.
  [[nodiscard]] unsigned output_bits() {
    const Box& box = emulator_.box();
    const auto bits = static_cast<unsigned>(box.outputs());
    return box.slave() == nullptr
               ? bits
               : bits | static_cast<unsigned>(box.slave()->outputs()) << outputs_per_controller;
  }
  [[nodiscard]] std::map<std::string, int> outputs() {
    std::map<std::string, int> all;
    for (int i = 0; i < outputs_count(); ++i) all[std::to_string(i + 1)] = output_bits() >> i & 1;
    return all;
  }

  void assume(const ControllerState& from) {
    std::uint32_t moved = 0;
    for (int i = 0; i < motors_; ++i) moved |= std::uint32_t{axis(i).travelled > 0} << i;
    result_.assumptions = watch_.assumptions();
    const FinishedRun ran{emulator_.box(), started_, [this](int slot) { return text_fills(slot); }};
    for (RehearsedAssumption& a : assumptions(from, catalog_, moved, ran))
      result_.assumptions.push_back(std::move(a));
  }

  const Analysis& analysis_;
  const RehearseOptions& options_;
  const Catalog& catalog_;
  int motors_;
  VxmEmulator emulator_;
  BenchSchedule bench_schedule_;
  TrackKeeper track_;
  ProgramWatch watch_;
  std::vector<Trace> trace_;
  int started_ = 0;  ///< program
  unsigned outputs_seen_ = 0;
  bool waits_ = false;
  std::string waited_for_;  ///< the last one
  std::array<std::int64_t, max_motors> begin_{};
  Instant now_{};
  Rehearsal result_;
};

Result<> refuse_errors(const ProgramReport& report) {
  for (const Problem& p : report.problems)
    if (p.error)
      return fail(FaultKind::text, "Line " + std::to_string(p.line + 1) + ": " + p.sentence,
                  "Nothing was rehearsed.");
  return {};
}

}  // namespace

Result<Rehearsal> rehearse_program(std::string_view text, const RehearseOptions& options) {
  Analysis analysis = analyse_text(text, options.slot);
  check_programs(analysis);
  if (auto good = refuse_errors(analysis.report); !good) return fail(good.error());
  const int needed = analysis.motors > motors_per_controller ? max_motors : motors_per_controller;
  const int motors = std::clamp(options.axes == 0 ? needed : options.axes, 1, max_motors);
  const auto catalog = make_catalog({{"motors", std::to_string(motors)}});
  if (!catalog) return fail(catalog.error());
  Rehearsing rehearsing(analysis, options, *catalog);
  if (auto done = rehearsing.set_bench(); !done) return fail(done.error());
  if (!options.bench_toml.empty()) {
    const auto bench = parse_bench_file(options.bench_toml, *catalog);
    if (!bench) return fail(bench.error());
    if (auto done = rehearsing.set_bench(*bench); !done) return fail(done.error());
  }
  return rehearsing.run();
}

}  // namespace hw::vxm
