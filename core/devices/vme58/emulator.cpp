#include "core/devices/vme58/emulator.h"

#include <algorithm>
#include <utility>

#include "core/devices/vme58/emulator_vme58.h"

namespace hw::vme58 {
namespace {

constexpr int most_events_at_one_time = 100'000;  // then time has to go on
constexpr std::string_view memory_text = "# A VME58 keeps nothing without power.\n";

tl::unexpected<Fault> wrong_option(std::string what, std::string advice = {}) {
  return fail(FaultKind::text, std::move(what), "", std::move(advice));
}

/// IIO: one letter for each group of four lines; the last two lines are outputs for good.
std::optional<std::uint16_t> outputs_of(std::string_view jumpers) {
  constexpr std::size_t groups = first_fixed_output / lines_of_a_group;
  if (jumpers.size() != groups) return std::nullopt;
  unsigned outputs = ((1u << io_lines) - 1) & ~((1u << first_fixed_output) - 1);
  for (std::size_t g = 0; g < groups; ++g) {
    const char c = jumpers[g];
    if (c == 'O' || c == 'o')
      outputs |= ((1u << lines_of_a_group) - 1) << (g * lines_of_a_group);
    else if (c != 'I' && c != 'i')
      return std::nullopt;
  }
  return static_cast<std::uint16_t>(outputs);
}

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
    if (at_one_time > most_events_at_one_time) break;
    board_.advance(std::max(*next, board_.now()));
  }
  if (now > board_.now()) board_.advance(now);
}

// --- memory ------------------------------------------------------------------------------------------------

std::string Vme58Emulator::save_memory() const { return std::string(memory_text); }

Result<> Vme58Emulator::load_memory(std::string_view text) {
  if (text.substr(0, memory_text.size()) == memory_text) return {};
  return fail(FaultKind::text, "This is no memory of a VME58.", "Nothing was changed.",
              "A VME58 has none: it keeps nothing without power.");
}

// --- options -----------------------------------------------------------------------------------------------

namespace {

Result<BoardMake> read_options(const std::map<std::string, std::string>& given) {
  BoardMake make;
  for (const auto& [key, value] : given) {
    if (key == "variant") {
      make.variant = find_variant(value);
      if (make.variant == nullptr) {
        std::string names;
        for (const Variant& v : variants) names += (names.empty() ? "" : ", ") + std::string(v.name);
        return wrong_option("variant=" + value + ": there is no such model.", "Models are " + names + ".");
      }
    } else if (key == "jumpers") {
      const auto outputs = outputs_of(value);
      if (!outputs)
        return wrong_option(
            "jumpers=" + value + ": three letters, I or O, say what lines 0-3, 4-7 and 8-11 are.",
            "The factory's are IIO.");
      make.outputs = *outputs;
    } else if (key == "firmware") {
      constexpr std::size_t longest = 8;
      if (value.empty() || value.size() > longest ||
          value.find_first_not_of("0123456789.") != std::string::npos)
        return wrong_option("firmware=" + value + ": a revision is a number like 2.24.");
      make.firmware = value;
    } else {
      return wrong_option("The VME58 emulator has no option \"" + key + "\".",
                          "Its options are variant, jumpers and firmware.");
    }
  }
  return make;
}

}  // namespace

Result<std::unique_ptr<Emulator>> make_emulator(const std::map<std::string, std::string>& options) {
  auto read = read_options(options);
  if (!read) return fail(read.error());
  return std::make_unique<Vme58Emulator>(*read);
}

}  // namespace hw::vme58
