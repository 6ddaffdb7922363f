#include "tests/core/devices/vme58/rig.h"

#include <algorithm>
#include <cstdlib>

#include "core/devices/vme58/emulator.h"

namespace hw::vme58::proof {

Rig::Rig(const DeviceOptions& options) {
  auto made = make_emulator(options);
  if (!made) {
    ADD_FAILURE() << made.error().sentence();
    std::abort();
  }
  emulator_ = std::move(*made);
}

// --- rings -------------------------------------------------------------------------------------------------

void Rig::send(std::string_view text) {
  constexpr std::size_t most_at_once = ring_cells - 1;
  while (!text.empty()) {
    const auto free = most_at_once - static_cast<std::size_t>(waiting());
    const std::string_view part = text.substr(0, free);
    ASSERT_FALSE(part.empty()) << "the board takes nothing more; left: " << text;
    text.remove_prefix(part.size());
    std::uint16_t put = read16(at::output_put_index);
    for (const char c : part) {
      write16(static_cast<std::uint16_t>(at::output_buffer + 2 * put), static_cast<std::uint8_t>(c));
      put = static_cast<std::uint16_t>((put + 1) % ring_cells);
    }
    write16(at::output_put_index, put);
  }
}

int Rig::waiting() {
  return (read16(at::output_put_index) - read16(at::output_get_index) + ring_cells) % ring_cells;
}

std::string Rig::output() {
  std::string text;
  // The board may have more to say than the ring holds.
  for (;;) {
    std::uint16_t get = read16(at::input_get_index);
    const std::uint16_t put = read16(at::input_put_index);
    if (get == put) return text;
    for (; get != put; get = static_cast<std::uint16_t>((get + 1) % ring_cells))
      text += static_cast<char>(read16(static_cast<std::uint16_t>(at::input_buffer + 2 * get)));
    write16(at::input_get_index, get);
  }
}

std::string Rig::ask(std::string_view text) {
  output();
  send(text);
  return output();
}

std::string Rig::value(std::string_view text) {
  std::string reply = ask(text);
  reply.erase(std::remove_if(reply.begin(), reply.end(), [](char c) { return c == '\r' || c == '\n'; }),
              reply.end());
  return reply;
}

void Rig::mail(std::string_view letters) {
  ASSERT_EQ(letters.size(), 2u);
  const auto high = static_cast<std::uint8_t>(letters[0]), low = static_cast<std::uint8_t>(letters[1]);
  write32(at::mailbox, std::uint32_t{high} << 16 | low);
  write8(reg::control, read8(reg::control) | control::interrupt_board);
}

std::int32_t Rig::axis_value(char letter, AxisValue value) {
  write8(reg::control, read8(reg::control) | control::update_data);
  for (int i = 0; i < 20 && (read8(reg::control) & control::update_data) != 0; ++i) run_for(100us);
  EXPECT_EQ(read8(reg::control) & control::update_data, 0) << "the axis data were not copied";
  return static_cast<std::int32_t>(read32(offset_of(static_cast<int>(axis_letters.find(letter)), value)));
}

// --- time --------------------------------------------------------------------------------------------------

void Rig::advance_to(Instant t) {
  now_ = t;
  emulator_->advance_to(t);
}

Duration Rig::run_until_done(std::string_view letters, Duration patience) {
  const Instant begin = now_;
  unsigned wanted = 0;
  for (const char c : letters) wanted |= bit_of(c);
  unsigned seen = 0;
  for (;;) {
    // Not through the register: reading it would clear flags that a test wants to see.
    for (const char c : letters)
      if (value(std::string("A") + c + " QA").substr(1, 1) == "D") seen |= bit_of(c);
    if ((seen & wanted) == wanted) return now_ - begin;
    const auto next = emulator_->next_event();
    if (!next || *next - begin > patience) {
      ADD_FAILURE() << "not done: " << letters;
      return now_ - begin;
    }
    advance_to(std::max(*next, now_));
  }
}

void Rig::run_until_quiet(Duration patience) {
  const Instant begin = now_;
  for (auto next = emulator_->next_event(); next; next = emulator_->next_event()) {
    if (*next - begin > patience) {
      ADD_FAILURE() << "something goes on and on";
      return;
    }
    advance_to(std::max(*next, now_));
  }
}

// --- hands -------------------------------------------------------------------------------------------------

void Rig::limit(char letter, char side, bool operated) {
  operate(bench::Limit(axis(letter), side == '+' ? Sign::plus : Sign::minus, operated));
}

void Rig::operate(const BenchCommand& command) {
  const auto done = emulator_->operate(command);
  EXPECT_TRUE(done.has_value()) << done.error().sentence();
}

BenchView Rig::view() const {
  BenchView v;
  emulator_->look(v);
  return v;
}

bool Rig::aux_high(char letter) const {
  constexpr int general_outputs = 6;
  return (view().outputs >> general_outputs & bit_of(letter)) != 0;
}

// --- questions ---------------------------------------------------------------------------------------------

std::int64_t Rig::number(char letter, std::string_view query) {
  const std::string reply = value(std::string("A") + letter + " " + std::string(query));
  EXPECT_FALSE(reply.empty()) << query << " was not answered";
  return std::atoll(reply.c_str());
}

std::int64_t Rig::position(char letter) { return number(letter, "RP"); }
std::int64_t Rig::velocity(char letter) { return number(letter, "RV"); }
int Rig::room(char letter) { return static_cast<int>(number(letter, "RQ")); }

std::string visible(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) text += c == '\r' ? "<cr>" : c == '\n' ? "<lf>" : std::string(1, c);
  return text;
}

}  // namespace hw::vme58::proof
