#include "core/devices/vme58/emulator.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "core/devices/vme58/emulator_vme58.h"

namespace hw::vme58 {
namespace {

constexpr std::string_view memory_text = "# A VME58 keeps nothing without power.\n";

}  // namespace

// --- bus ---------------------------------------------------------------------------------------------------

std::uint8_t Vme58Emulator::read8(std::uint16_t offset) { return board_.read(offset % window_bytes); }

std::uint16_t Vme58Emulator::read16(std::uint16_t offset) {
  const auto even = static_cast<std::uint16_t>(offset % window_bytes & ~1u);
  const unsigned high = board_.read(even);
  return static_cast<std::uint16_t>(high << 8 | board_.read(even + 1));
}

void Vme58Emulator::write8(std::uint16_t offset, std::uint8_t value) {
  board_.write(offset % window_bytes, value);
  board_.written(offset % window_bytes);
}

void Vme58Emulator::write16(std::uint16_t offset, std::uint16_t value) {
  const auto even = static_cast<std::uint16_t>(offset % window_bytes & ~1u);
  board_.write(even, static_cast<std::uint8_t>(value >> 8));
  board_.write(even + 1, static_cast<std::uint8_t>(value));
  board_.written(even + 1);
}

// --- time --------------------------------------------------------------------------------------------------

void Vme58Emulator::advance_to(Instant now) {
  int at_one_time = 0;
  for (;;) {
    const auto next = board_.next_event();
    if (!next || *next > now) break;
    at_one_time = *next > board_.now() ? 0 : at_one_time + 1;
    if (at_one_time > most_events_at_once) break;
    board_.advance(std::max(*next, board_.now()));
  }
  if (now > board_.now()) board_.advance(now);
}

// --- memory ------------------------------------------------------------------------------------------------

std::string Vme58Emulator::save_memory() const { return std::string(memory_text); }

Result<> Vme58Emulator::load_memory(std::string_view text) {
  if (text.substr(0, memory_text.size()) == memory_text) return {};
  return fail(FaultKind::text, "This is not a memory of a VME58.", "Nothing was changed.",
              "A VME58 has none: it keeps nothing without power.");
}

// --- options -----------------------------------------------------------------------------------------------

Result<std::unique_ptr<Emulator>> make_emulator(const std::map<std::string, std::string>& options) {
  for (const auto& [key, value] : options)
    if (!is_board_option(key))
      return fail(FaultKind::text, fmt::format("The VME58 emulator has no option \"{}\".", key), "",
                  fmt::format("Its options are {}.", board_option_names()));
  auto read = read_board_options(options);
  if (!read) return fail(read.error());
  return std::make_unique<Vme58Emulator>(*read);
}

}  // namespace hw::vme58
