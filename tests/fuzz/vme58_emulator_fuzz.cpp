// A hostile host: cycles on the bus and command text as the fuzzer likes, between them time and hands on the
// bench. The board may do with it what it wants, but
//  - it stays alive and its time goes forward,
//  - no axis moves unless the board has taken the letters of a command that moves something out of the ring;
//    when all has come to rest and nothing waits, that holds again, until the next such command,
//  - what is at rest and holds no position stays where it is while the board takes no text,
//  - a kill through the mailbox and IC bring it back to work.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/devices/vme58/emulator.h"
#include "core/devices/vme58/emulator_vme58.h"
#include "tests/fuzz/arcus_emulator_session.h"

namespace {

using namespace hw;
using fuzz::Bytes;
using fuzz::require;

struct Mover {
  std::string_view letters;
  bool number;  ///< it is complete with what stands behind its number
};
constexpr std::array<Mover, 12> movers{{{"GO", false},
                                        {"GD", false},
                                        {"KM", false},
                                        {"KR", false},
                                        {"CX", false},
                                        {"JG", true},
                                        {"JF", true},
                                        {"HM", true},
                                        {"HR", true},
                                        {"MV", true},
                                        {"SP", true},
                                        {"FP", true}}};
constexpr std::string_view of_numbers = "0123456789+-., ";

// A loop of commands that take no time turns a thousand times a second.
constexpr Duration longest = std::chrono::minutes(1);

class Host {
 public:
  explicit Host(std::unique_ptr<Emulator> board) : emulator_(std::move(board)) { taken_to_ = get_index(); }

  std::uint32_t cycle(bool write, std::uint8_t width, std::uint16_t offset, std::uint32_t value = 0) {
    if (write &&
        width == 4) {  // in its halves, so that what the first one sets off is seen before the second
      cycle(true, 2, offset, value >> 16);
      return cycle(true, 2, static_cast<std::uint16_t>(offset + 2), value & 0xFFFF);
    }
    const std::uint32_t got = bus_cycle(bus(), write, width, offset, value);
    watch();
    return got;
  }

  /// As a program would: characters, then the index.
  void send(std::string_view text) {
    std::uint32_t put = cycle(false, 2, vme58::at::output_put_index) % vme58::ring_cells;
    for (const char c : text) {
      cycle(true, 2, static_cast<std::uint16_t>(vme58::at::output_buffer + 2 * put),
            static_cast<std::uint8_t>(c));
      put = (put + 1) % vme58::ring_cells;
    }
    cycle(true, 2, vme58::at::output_put_index, put);
  }

  std::string replies() {
    std::string text;
    for (int rounds = 0; rounds < 64; ++rounds) {
      std::uint32_t get = cycle(false, 2, vme58::at::input_get_index) % vme58::ring_cells;
      const std::uint32_t put = cycle(false, 2, vme58::at::input_put_index);
      if (get == put || put >= vme58::ring_cells) break;  // nothing more, or an empty slot
      for (; get != put; get = (get + 1) % vme58::ring_cells)
        text +=
            static_cast<char>(cycle(false, 2, static_cast<std::uint16_t>(vme58::at::input_buffer + 2 * get)));
      cycle(true, 2, vme58::at::input_get_index, get);
    }
    return text;
  }

  void mail(std::string_view letters) {
    cycle(true, 2, vme58::at::mailbox, static_cast<std::uint8_t>(letters[0]));
    cycle(true, 2, vme58::at::mailbox + 2, static_cast<std::uint8_t>(letters[1]));
    cycle(true, 1, vme58::reg::control, vme58::control::interrupt_board);
  }

  void pass(Duration time) {
    now_ += time;
    emulator_->advance_to(now_);
    watch();
  }

  /// Microseconds to seconds; event by event when the input asks for it.
  void pass_as(Bytes& in) {
    const auto kind = in.next();
    if (now_.time_since_epoch() > longest) return;
    if ((kind & 1) == 0) {
      constexpr int widest = 13;
      return pass(std::chrono::microseconds(1LL << (kind / 8 % widest)) * (1 + in.next()));
    }
    for (int i = 0; i < kind / 8; ++i) {
      const auto next = emulator_->next_event();
      if (!next || next->time_since_epoch() > longest) return;
      require(*next >= now_);
      pass(*next - now_);
    }
  }

  void operate(const BenchCommand& hand) {
    (void)emulator_->operate(hand);
    watch();
  }

  /// The same board again, at another place in memory.
  void clone() { emulator_ = emulator_->clone(); }

  void look() {
    BenchView view;
    emulator_->look(view);
    (void)emulator_->bus()->interrupt();
  }

 private:
  BusTarget& bus() { return *emulator_->bus(); }
  vme58::Board& board() { return static_cast<vme58::Vme58Emulator&>(*emulator_).board(); }
  std::uint32_t get_index() { return bus().read16(vme58::at::output_get_index) % vme58::ring_cells; }

  /// What has left the ring since the last look, and whether something moves without reason.
  void watch() {
    if (!board().powered() || board().booting()) {
      forget();
      return;
    }
    const bool took_text = taken_to_ != get_index();
    for (const std::uint32_t get = get_index(); taken_to_ != get;
         taken_to_ = (taken_to_ + 1) % vme58::ring_cells)
      receive(static_cast<char>(
          bus().read16(static_cast<std::uint16_t>(vme58::at::output_buffer + 2 * taken_to_))));
    for (int a = 0; a < board().variant().axes(); ++a) {
      const vme58::Motion& motion = board().motion();
      if (!may_move_) require(!motion.moving(a));
      const bool by_encoder = motion.settings(a).holding || motion.settings(a).tracking;
      auto& rests_at = rests_at_[static_cast<std::size_t>(a)];
      if (!may_move_ && !took_text && !by_encoder && rests_at) require(motion.position(a) == *rests_at);
      rests_at.reset();
      if (!motion.moving(a) && !by_encoder) rests_at = motion.position(a);
    }
    if (complete_ && board().idle()) may_move_ = false;
  }
  void receive(char c) {
    received_[0] = received_[1];
    received_[1] = c;
    const std::string_view letters(received_.data(), received_.size());
    const auto* mover =
        std::find_if(movers.begin(), movers.end(), [&](const Mover& m) { return m.letters == letters; });
    if (mover != movers.end()) {
      may_move_ = true;
      complete_ = !mover->number;
    } else if (of_numbers.find(c) == of_numbers.npos) {
      complete_ = true;
    }
  }
  /// Without power, and while it boots: nothing that came before counts.
  void forget() {
    taken_to_ = get_index();
    received_ = {};
    may_move_ = false;
    rests_at_ = {};
  }

  std::unique_ptr<Emulator> emulator_;
  Instant now_{};
  std::uint32_t taken_to_ = 0;
  std::array<char, 2> received_{};
  bool may_move_ = false;  ///< a command that moves has been taken, and not all has come to rest since
  bool complete_ = true;   ///< the latest of them: no number of it can come any more
  std::array<std::optional<std::int64_t>, vme58::most_axes> rests_at_{};
};

/// Mostly where something can happen.
std::uint16_t offset_from(Bytes& in) {
  static constexpr std::uint16_t places[] = {
      vme58::at::output_put_index, vme58::at::input_get_index, vme58::at::mailbox,
      vme58::at::mailbox + 2,      vme58::reg::control,        vme58::reg::status,
      vme58::reg::limit,           vme58::reg::vector,         vme58::at::output_buffer,
      vme58::at::reserved1,        vme58::at::axis_data,       vme58::at::input_put_index};
  const auto which = in.next();
  if (which < 128) return static_cast<std::uint16_t>(places[which % std::size(places)] + (which >> 6));
  return static_cast<std::uint16_t>(which << 8 | in.next());
}

void random_cycle(Host& host, Bytes& in) {
  static constexpr std::uint8_t widths[] = {1, 2, 4};
  const auto kind = in.next();
  const std::uint16_t offset = offset_from(in);
  std::uint32_t value = in.next();
  if (kind & 4)
    value = value << 24 | std::uint32_t{in.next()} << 16 | std::uint32_t{in.next()} << 8 | in.next();
  host.cycle(kind & 1, widths[(kind >> 3) % 3], offset, value);
}

/// Text that has meaning more often than chance would give it.
void text(Host& host, Bytes& in) {
  std::string all;
  for (int words = 1 + in.next() % 6; words > 0; --words) {
    const auto which = in.next();
    const auto& facts = vme58::command_facts;
    all += facts[which % facts.size()].letters;
    const auto form = in.next();
    if (form & 1) all += std::to_string(static_cast<std::int16_t>(in.next() << 8 | in.next()));
    if (form & 2) all += "," + std::to_string(in.next());
    if (form & 4) all += ".5";
    if (form & 8) all += ";";
    if (form & 16) all += " ";
  }
  host.send(all);
}

/// What stands in the ring may ask for more, and the board takes it in as soon as it can.
void drain(Host& host) {
  for (int rounds = 0; rounds < 300; ++rounds) {
    host.mail("KL");
    host.pass(std::chrono::milliseconds(200));
    (void)host.replies();
    const auto put = host.cycle(false, 2, vme58::at::output_put_index);
    if (put >= vme58::ring_cells) host.cycle(true, 2, vme58::at::output_put_index, 0);
    if (put == host.cycle(false, 2, vme58::at::output_get_index)) return;
  }
}

void expect_back_at_work(Host& host, std::string_view variant) {
  host.operate(bench::Power(true));
  host.pass(std::chrono::seconds(1));
  for (int a = 0; a < vme58::most_axes; ++a)
    host.operate(bench::Jam(AxisId{static_cast<std::uint8_t>(a)}, false));
  host.cycle(true, 2, vme58::at::input_get_index, host.cycle(false, 2, vme58::at::input_put_index));
  drain(host);
  host.send("\r;");  // the end of a number may begin one more motion
  drain(host);
  host.send("AX EF IC ");
  (void)host.replies();
  host.send("IC ");
  const auto status = host.cycle(false, 1, vme58::reg::status);
  require((status & vme58::status::command_error) == 0);
  require((status & vme58::status::done) == 0);
  host.send("AX HF HN HF TF ES0 HN LF UF PF LP0 AC100000 VL1000 VB0 MR10 GO ID ");
  host.pass(std::chrono::seconds(2));
  (void)host.replies();
  host.send("RP");
  require(host.replies() == "\n\r10\n\r");
  require((host.cycle(false, 1, vme58::reg::done) & 1) != 0);
  host.send("WY");
  require(host.replies() == "\n\rVME58 ver 2.24-" + std::string(variant) + "\n\r");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes in(data, size);
  const std::string variant(vme58::variants[in.next() % vme58::variants.size()].name);
  auto made = vme58::make_emulator({{"variant", variant}});
  require(made.has_value());
  Host host(std::move(*made));
  while (!in.empty()) {
    const auto op = in.next();
    if (op < 60) {
      random_cycle(host, in);
    } else if (op < 130) {
      text(host, in);
    } else if (op < 160) {
      host.send(in.text(1 + op % 32));
    } else if (op < 190) {
      (void)host.replies();
    } else if (op < 225) {
      host.pass_as(in);
    } else if (op < 245) {
      host.operate(fuzz::hand(in));
    } else if (op < 250) {
      host.mail(vme58::mailbox_commands[op % vme58::mailbox_commands.size()]);
    } else {
      host.clone();
    }
    host.look();
  }
  expect_back_at_work(host, variant);
  return 0;
}
