// A host at the window of an emulated VME58, without any transport between: what the board's firmware costs.
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include <benchmark/benchmark.h>

#include "core/devices/vme58/emulator.h"
#include "core/devices/vme58/facts.h"

namespace hw::vme58 {
namespace {

/// Characters into the ring, then the index, as drivers do it.
void send(BusTarget& board, std::string_view text) {
  auto put = static_cast<std::uint16_t>(bus_cycle(board, false, 2, at::output_put_index));
  for (const char c : text) {
    const auto cell = static_cast<std::uint16_t>(at::output_buffer + 2 * put);
    bus_cycle(board, true, 2, cell, static_cast<std::uint8_t>(c));
    put = static_cast<std::uint16_t>((put + 1) % ring_cells);
  }
  bus_cycle(board, true, 2, at::output_put_index, put);
}

std::unique_ptr<Emulator> board_in_a_slot() {
  auto made = make_emulator(std::map<std::string, std::string>());
  return std::move(*made);
}

void command_through_the_window(benchmark::State& state) {
  const auto emulator = board_in_a_slot();
  for (auto _ : state) send(*emulator->bus(), "AX LP12345 ");
  state.counters["commands_per_s"] =
      benchmark::Counter(2.0 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(command_through_the_window);

void move_from_text_to_done_flag(benchmark::State& state) {
  const auto emulator = board_in_a_slot();
  Instant now{};
  for (auto _ : state) {
    send(*emulator->bus(), "AX VL10000 AC1000000 MR1000 GO ID MR-1000 GO ID ");
    now += std::chrono::seconds(1);
    emulator->advance_to(now);
    benchmark::DoNotOptimize(bus_cycle(*emulator->bus(), false, 1, reg::done));
  }
}
BENCHMARK(move_from_text_to_done_flag);

/// Request of the update, the board's copy, then encoder, position and velocity of each axis.
void all_axes_read(benchmark::State& state) {
  const auto emulator = board_in_a_slot();
  BusTarget& board = *emulator->bus();
  send(board, "AA JG100,200,300,400,500,600,700,800; ");
  Instant now{};
  for (auto _ : state) {
    bus_cycle(board, true, 1, reg::control, control::update_data);
    now += std::chrono::milliseconds(1);
    emulator->advance_to(now);
    for (int axis = 0; axis < most_axes; ++axis)
      for (const AxisValue value :
           {AxisValue::encoder_position, AxisValue::command_position, AxisValue::command_velocity})
        benchmark::DoNotOptimize(bus_cycle(board, false, 4, offset_of(axis, value)));
  }
  state.counters["reads_per_s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(all_axes_read);

}  // namespace
}  // namespace hw::vme58
