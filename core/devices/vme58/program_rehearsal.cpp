// A dry run on the emulated board, in virtual time: the text goes through the command ring as it would from a
// host, and the board's own memory tells what happens.
#include "core/devices/vme58/program_rehearsal.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <deque>

#include <fmt/format.h>

#include "core/device/bench_file.h"
#include "core/device/emulator.h"
#include "core/device/planned_hands.h"
#include "core/devices/vme58/catalog.h"
#include "core/devices/vme58/command_text.h"
#include "core/devices/vme58/emulator.h"
#include "core/devices/vme58/program_check.h"

namespace hw::vme58 {
namespace {

constexpr std::size_t most_events = 10'000;
constexpr Duration board_copies = Millis(1), moving_step = Millis(10), resting_step = Millis(100);

int line_of(std::string_view text, std::size_t at) {
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// Axes that the text speaks to: up to the last of them.
int axes_needed(const std::vector<TextCommand>& commands) {
  std::size_t axes = 1;
  for (const TextCommand& command : commands) {
    if (!command.fact) continue;
    if (command.fact->op >= Op::AX && command.fact->op <= Op::AS)
      axes =
          std::max(axes, static_cast<std::size_t>(command.fact->op) - static_cast<std::size_t>(Op::AX) + 1);
    if (command.context.mode != where::single && command.fact->shape == Shape::list)
      axes = std::max(axes, command.numbers.size());
  }
  return static_cast<int>(std::min<std::size_t>(axes, most_axes));
}

class Rehearsing {
 public:
  Rehearsing(std::unique_ptr<Emulator> emulator, const std::vector<TextCommand>& commands,
             std::string_view plain, const RehearseOptions& options)
      : emulator_(std::move(emulator)),
        board_(*emulator_->bus()),
        options_(options),
        last_(from_seconds(std::clamp(options.for_seconds, 0.0, 1e9))),
        axes_(std::max(options.axes, axes_needed(commands))) {
    for (const TextCommand& command : commands)
      to_send_.push_back({line_of(plain, command.begin), std::string(command.text)});
  }

  Result<> set_bench(const BenchFile& bench) { return hands_.begin(bench, *emulator_); }

  Rehearsal run() {
    wait_for_start();
    began_ = now_;
    hands_.count_from(began_);
    for (int i = 0; i < std::min(axes_, static_cast<int>(options_.start_at.size())); ++i)
      send(fmt::format("A{} LP{}\n", axis_letters[static_cast<std::size_t>(i)],
                       options_.start_at[static_cast<std::size_t>(i)]));
    send("AX\n");
    (void)take_replies();
    look();
    for (Axis& axis : seen_) axis.lowest = axis.highest = axis.position;
    while (true) {
      feed();
      look();
      if (!result_.error.empty()) break;
      if (to_send_.empty() && taken() && !any_moving() && queues_empty()) {
        result_.finished = true;
        break;
      }
      if (now_ - began_ >= last_.time_since_epoch()) {
        result_.error = "The text was still at work when the rehearsal ended.";
        break;
      }
      pass(any_moving() ? moving_step : resting_step);
    }
    return finish();
  }

 private:
  struct Line {
    int line;
    std::string command;
  };
  struct Axis {
    std::int64_t position = 0, lowest = 0, highest = 0, travel = 0, velocity = 0;
    bool known = false;
  };

  // ---- time and the bus

  void advance(Instant to) {
    while (true) {
      std::optional<Instant> next = emulator_->next_event();
      if (const auto hand = hands_.next(); hand && *hand <= std::min(to, next.value_or(to))) next = hand;
      if (!next || *next > to) break;
      emulator_->advance_to(std::max(now_, *next));
      now_ = std::max(now_, *next);
      hands_.act_until(now_, *emulator_);
    }
    emulator_->advance_to(to);
    now_ = to;
  }
  void pass(Duration d) { advance(now_ + d); }
  std::uint32_t read(std::uint8_t bytes, std::uint16_t offset) {
    return bus_cycle(board_, false, bytes, offset);
  }
  void write(std::uint8_t bytes, std::uint16_t offset, std::uint32_t value) {
    bus_cycle(board_, true, bytes, offset, value);
  }

  void wait_for_start() {
    for (int i = 0; i < 1000 && (read(1, reg::status) & status::initialized) == 0; ++i) pass(Millis(1));
  }

  [[nodiscard]] bool taken() { return read(2, at::output_get_index) == put_; }
  void put(std::string_view text) {
    for (const char c : text) {
      write(2, static_cast<std::uint16_t>(at::output_buffer + 2 * put_), static_cast<unsigned char>(c));
      put_ = (put_ + 1) % ring_cells;
    }
    write(2, at::output_put_index, put_);
  }
  void send(std::string_view text) {
    put(text);
    for (int i = 0; i < 100 && !taken(); ++i) pass(Millis(1));
  }

  std::string take_replies() {
    std::string text;
    const std::uint32_t end = read(2, at::input_put_index);
    while (get_ != end) {
      const char c = static_cast<char>(read(2, static_cast<std::uint16_t>(at::input_buffer + 2 * get_)));
      if (c != '\r' || (!text.empty() && text.back() != '\n')) text += c == '\r' ? '\n' : c;
      get_ = (get_ + 1) % ring_cells;
    }
    write(2, at::input_get_index, get_);
    std::string lines;
    for (const char c : text)
      if (c != '\n' || (!lines.empty() && lines.back() != '\n')) lines += c;
    return lines;
  }

  // ---- the host's side

  // One command at a time, as the board takes them; a command error names the one before it.
  void feed() {
    while (!to_send_.empty() && taken()) {
      const Line next = std::move(to_send_.front());
      to_send_.pop_front();
      put(next.command + ";\n");
      sent_ = next;
      collect();
      if (!result_.error.empty()) return;
    }
    collect();
  }
  void collect() {
    result_.sent_to_host += take_replies();
    if ((read(1, reg::status) & status::command_error) == 0) return;
    result_.error = fmt::format("Line {}: the board rejects \"{}\".", sent_.line + 1, sent_.command);
    event(result_.error);
  }

  void look() {
    write(1, reg::control, control::update_data);
    for (int i = 0; i < 100 && (read(1, reg::control) & control::update_data) != 0; ++i) pass(board_copies);
    for (int i = 0; i < axes_; ++i) look_at(i);
    const std::uint32_t done = read(1, reg::done), limit = read(1, reg::limit);
    for (int i = 0; i < axes_; ++i) {
      const char letter = axis_letters[static_cast<std::size_t>(i)];
      if ((done >> i & 1) != 0)
        event(fmt::format("{} done at {}", letter, seen_[static_cast<std::size_t>(i)].position));
      const bool hit = (limit >> i & 1) != 0;
      if (hit && !result_.limit_touched) event(fmt::format("{} met a limit switch", letter));
      result_.limit_touched = result_.limit_touched || hit;
    }
  }
  void look_at(int i) {
    Axis& axis = seen_[static_cast<std::size_t>(i)];
    const auto position = static_cast<std::int32_t>(read(4, offset_of(i, AxisValue::command_position)));
    const auto velocity = static_cast<std::int32_t>(read(4, offset_of(i, AxisValue::command_velocity)));
    const char letter = axis_letters[static_cast<std::size_t>(i)];
    if (axis.known) axis.travel += std::abs(position - axis.position);
    if (axis.known && axis.velocity == 0 && velocity != 0) {
      event(fmt::format("{} moves", letter));
      ++result_.moves;
    }
    if (axis.known && axis.velocity != 0 && velocity == 0)
      event(fmt::format("{} rests at {}", letter, position));
    axis.position = position;
    axis.velocity = velocity;
    axis.lowest = std::min<std::int64_t>(axis.lowest, position);
    axis.highest = std::max<std::int64_t>(axis.highest, position);
    axis.known = true;
  }
  [[nodiscard]] bool any_moving() const {
    return std::any_of(seen_.begin(), seen_.end(), [](const Axis& a) { return a.velocity != 0; });
  }
  bool queues_empty() {
    (void)take_replies();
    std::string question;
    for (int i = 0; i < axes_; ++i)
      question += fmt::format("A{} RQ ", axis_letters[static_cast<std::size_t>(i)]);
    put(question + "AA RQ AM RQ " + context_after_ + "\n");
    for (int i = 0; i < 20 && !taken(); ++i) pass(Millis(1));
    const std::string answer = take_replies();
    int fields = 0, empty = 0;
    for (std::size_t at = 0; at < answer.size();) {
      const std::size_t end = std::min(answer.find_first_of(",\n", at), answer.size());
      ++fields;
      empty += std::atoi(answer.substr(at, end - at).c_str()) == queue_entries;
      at = end + 1;
    }
    return fields > axes_ && empty == fields;
  }

  void event(std::string what) {
    if (result_.events.size() < most_events)
      result_.events.push_back({seconds(now_ - began_), std::move(what), 0, -1});
  }

  Rehearsal finish() {
    result_.duration_s = seconds(now_ - began_);
    for (int i = 0; i < axes_; ++i) {
      const Axis& axis = seen_[static_cast<std::size_t>(i)];
      RehearsedAxis a;
      a.name = std::string(axis_letters.substr(static_cast<std::size_t>(i), 1));
      a.position = axis.position, a.minimum = axis.lowest, a.maximum = axis.highest, a.travel = axis.travel;
      result_.axes.push_back(std::move(a));
    }
    const std::uint32_t lines = read(1, reg::io_low) | read(1, reg::io_high) << 8;
    for (int line = 0; line < io_lines; ++line)
      if ((factory_outputs >> line & 1) != 0)
        result_.outputs[std::to_string(line)] = static_cast<int>(lines >> line & 1);
    return std::move(result_);
  }

  std::unique_ptr<Emulator> emulator_;
  BusTarget& board_;
  const RehearseOptions& options_;
  const Instant last_;
  const int axes_;
  std::deque<Line> to_send_;
  Line sent_{};
  PlannedHands hands_;
  std::array<Axis, most_axes> seen_{};
  std::string context_after_ = "AX";
  std::uint32_t put_ = 0, get_ = 0;
  Instant now_{}, began_{};
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
  auto emulator = make_emulator(options.device);
  if (!emulator) return fail(emulator.error());
  Rehearsing rehearsing(std::move(*emulator), commands, plain, options);
  if (!options.bench_toml.empty()) {
    auto catalog = make_catalog(options.device);
    if (!catalog) return fail(catalog.error());
    const auto bench = parse_bench_file(options.bench_toml, *catalog);
    if (!bench) return fail(bench.error());
    if (auto done = rehearsing.set_bench(*bench); !done) return fail(done.error());
  }
  Rehearsal result = rehearsing.run();
  result.program_size["0"] = static_cast<int>(text.size());
  return result;
}

}  // namespace hw::vme58
