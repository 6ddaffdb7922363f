#include "tests/contract/another_host.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "transports/serve.h"

namespace hw {
namespace {

constexpr std::uint16_t put_index = 0x800, buffer = 0x804, cells = 256;

/// Into the ring of a board, as its bus master does.
void write_into_ring(IoContext& io, Window& window, const std::function<void(Duration)>& run,
                     const std::string& bytes) {
  const auto on_the_bus = [&](std::vector<BusCycle>& cycles) {
    asio::co_spawn(
        io, [](Window& w, std::span<BusCycle> c) -> Task<> { (void)co_await w.run(c); }(window, cycles),
        asio::detached);
    run(Millis(1));
  };
  std::vector<BusCycle> cycles(1, BusCycle::read(2, put_index));
  on_the_bus(cycles);
  std::uint32_t put = cycles[0].value;
  cycles.clear();
  for (const char c : bytes) {
    cycles.push_back(
        BusCycle::store(2, static_cast<std::uint16_t>(buffer + 2 * put), static_cast<std::uint8_t>(c)));
    put = (put + 1) % cells;
  }
  cycles.push_back(BusCycle::store(2, put_index, put));
  on_the_bus(cycles);
}

}  // namespace

void send_as_another(IoContext& io, Session& session, const std::function<void(Duration)>& run,
                     const std::string& bytes) {
  const auto host = EmulatorHost::of(session.bench());
  ASSERT_NE(host, nullptr);
  if (host->is_board()) {
    const auto window = std::move(*host->plug_in_window());
    write_into_ring(io, *window, run, bytes);
    return run(Millis(100));
  }
  const auto stream = std::move(*host->plug_in());
  stream->send(bytes);
  run(Millis(100));
}

const WireTexts& wire_texts(std::string_view model) {
  static const std::vector<WireTexts> all{
      {"vxm", "D", "N", "I1M100,R", "X", "B0\r"},
      {"pmx-4ex-sa", "@00STOPX\r", "@00PX=0\r", "@00X4100\r", "PX", "V7=3"},
      {"dmx-k-sa", "@00STOP\r", "@00PX=0\r", "@00X4100\r", "PX", "V7=3"},
      {"vme58", "AX;ST;", "AX;LP0;", "AX;MR100;GO;", "AX RP", "AX VL900"},
      {"twin", "0 S A\n", "0 P A 0\n", "0 D A 100\n", "?", "VA=300"}};
  static const WireTexts none{};
  const auto row = std::find_if(all.begin(), all.end(), [&](const WireTexts& t) { return t.model == model; });
  if (row != all.end()) return *row;
  ADD_FAILURE() << "Add the texts of " << model << " to the table in " __FILE__ ".";
  return none;
}

}  // namespace hw
