#pragma once
// Gives an emulator a clock and a wire. Every attached stream is an end of that one wire: what any client
// sends reaches the controller, what the controller sends reaches every client. Io thread only.
//
// Time: the emulator's time is zero when its host is made and runs `speed` times as fast as the scheduler's.
// With `byte_times` a byte takes effect when its last bit has arrived and leaves ten bit times after the one
// before it, at the controller's present rate; a client at another rate garbles both ways. Without, the wire
// has no rate and no delay.
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/device/bench_file.h"
#include "core/device/emulator.h"
#include "core/session/wire.h"
#include "transports/byte_line.h"
#include "transports/state_file.h"

namespace hw {

struct HostOptions {
  std::string name = "emulator";  ///< for sentences: "vxm emulator"
  bool byte_times = false;
  double speed = 1;
  std::string state_file;  ///< empty: the memory is forgotten at the end
};

class EmulatorHost final : public BenchAccess, public std::enable_shared_from_this<EmulatorHost> {
 public:
  /// Loads the state file when there is one.
  static Result<std::shared_ptr<EmulatorHost>> make(Scheduler& scheduler, std::unique_ptr<Emulator> emulator,
                                                    HostOptions options, Trouble trouble = {});
  ~EmulatorHost() override;

  /// A client's end (an accepted connection, a pty's master side); stays until it closes. While the cable is
  /// pulled it stays open and its bytes are lost.
  void attach(std::unique_ptr<Stream> client);
  /// The end of a new cable in this process. It closes when the cable is pulled; a fault while it is.
  /// `baud` is the rate of the client's port; 0: that of the controller.
  Result<std::unique_ptr<Stream>> plug_in(int baud = 0);

  /// What the file says of the start happens now, the rest in the emulator's time from now on.
  Result<> set_up(const BenchFile& bench);
  Result<> operate(const BenchCommand& command) override;
  void look(BenchView& view) const override;
  [[nodiscard]] const Emulator& emulator() const override;

  [[nodiscard]] const HostOptions& options() const { return options_; }
  [[nodiscard]] std::size_t client_count() const { return clients_.size(); }

 private:
  struct Client;
  static constexpr Duration at_once = Millis(2);

  EmulatorHost(Scheduler& scheduler, std::unique_ptr<Emulator> emulator, HostOptions options);
  [[nodiscard]] Instant emulator_time() const;
  [[nodiscard]] Instant scheduler_time(Instant emulated) const;
  [[nodiscard]] Instant next_due() const;

  void add_client(std::unique_ptr<Stream> stream, bool by_cable);
  void bytes_from(const Client& client, std::string_view bytes);
  void alarm();
  void advance(Instant when) const;
  void catch_up(Instant now);
  void run_until(Instant now);
  void step_to(Instant when);
  void finish_round();
  Duration take_lateness(Instant now);
  void land(ByteLine::Byte byte);
  void take_output();
  void deliver();
  void spoil(std::string& bytes);
  void keep_memory();
  void tell_changed();
  Result<> apply(const BenchCommand& command);
  void pull_cable(bool pulled);

  Scheduler& scheduler_;
  std::unique_ptr<Emulator> emulator_;
  HostOptions options_;
  Instant began_;
  Timer timer_;
  Instant armed_for_{};        // this and the next in emulated time
  mutable Instant reached_{};  // looking moves time on too
  ByteLine incoming_, outgoing_;
  Instant left_at_{};  // emulated, as is the next: when the last byte left, and how much later that was done
  Duration late_{}, heard_late_{};
  std::string fresh_, leaving_;  // output just taken; output at the end of the wire
  std::vector<std::unique_ptr<Client>> clients_;
  bool unplugged_ = false;
  int to_garble_ = 0, to_drop_ = 0, garbled_ = 0;
  std::unique_ptr<StateFile> state_;
  std::uint64_t kept_version_ = 0;
  std::deque<TimedBenchCommand> plan_;  // `at` in emulated time, earliest first
  BenchView seen_;
};

}  // namespace hw
