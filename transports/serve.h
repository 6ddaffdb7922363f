#pragma once
// Gives emulators a clock and a wire: one controller, or several that hang on the same line (RS-485). Every
// attached stream is an end of that one wire: what any client sends reaches each controller, what a
// controller sends reaches every client; what two controllers say at once reaches them as garbage. Io thread
// only.
//
// Time: the emulators' time is zero when their host is made and runs `speed` times as fast as the
// scheduler's. With `byte_times` a byte takes effect when its last bit has arrived and leaves ten bit times
// after the one before it, at the rate of the first controller; whoever is at another rate garbles both ways.
// Without, the wire has no rate and no delay.
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
  /// Empty: the memory is forgotten at the end. With several controllers each has a file of its own, this
  /// name with a dot and its id behind.
  std::string state_file;
};

struct HostedDevice {
  std::string id;  ///< on a line with several: "07"
  std::unique_ptr<Emulator> emulator;
};

class EmulatorHost final : public std::enable_shared_from_this<EmulatorHost> {
 public:
  /// At least one device. Loads the state files that there are. `trouble` hears of a state file that could
  /// not be written, and of a client of a bus port that was sent away.
  static Result<std::shared_ptr<EmulatorHost>> make(Scheduler& scheduler, std::vector<HostedDevice> devices,
                                                    HostOptions options, Trouble trouble = {});
  static Result<std::shared_ptr<EmulatorHost>> make(Scheduler& scheduler, std::unique_ptr<Emulator> emulator,
                                                    HostOptions options, Trouble trouble = {});
  ~EmulatorHost();

  /// A client's end (an accepted connection, a pty's master side); stays until it closes. While the cable is
  /// pulled it stays open and its bytes are lost.
  void attach(std::unique_ptr<Stream> client);
  /// The end of a new cable in this process. It closes when the cable is pulled; a fault while it is.
  /// `baud` is the rate of the client's port; 0: that of the controller.
  Result<std::unique_ptr<Stream>> plug_in(int baud = 0);

  /// The device is a board in a memory window: it is reached by these two and not by those above.
  [[nodiscard]] bool is_board() const { return board() != nullptr; }
  /// The window of a new host in this process. It closes when the cable is pulled; a fault while it is.
  Result<std::unique_ptr<Window>> plug_in_window();
  /// A client of a bus port; stays until it closes or sends what is no message of a bus port.
  void attach_bus(std::unique_ptr<Stream> client);

  /// What surrounds one of the devices. It keeps the host alive.
  [[nodiscard]] std::shared_ptr<BenchAccess> bench(std::size_t device = 0);
  [[nodiscard]] std::size_t device_count() const { return devices_.size(); }
  /// The host that a bench belongs to; null: it is none of ours.
  static std::shared_ptr<EmulatorHost> of(const std::shared_ptr<BenchAccess>& bench);
  /// Each device stands on a bench like this: what the file says of the start happens now, the rest in the
  /// emulators' time from now on.
  Result<> set_up(const BenchFile& bench);

  [[nodiscard]] const HostOptions& options() const { return options_; }
  [[nodiscard]] std::size_t client_count() const { return clients_.size(); }

 private:
  struct Client;
  class Device;
  // serve_bus.cpp
  class HostWindow;
  struct BusClient;
  static constexpr Duration at_once = Millis(2);
  /// What the kernel needs to hand a reply to another program and its next question back to this one.
  static constexpr Duration hand_over = std::chrono::microseconds(400);

  EmulatorHost(Scheduler& scheduler, HostOptions options);
  Result<> add_device(HostedDevice device, const std::string& state_file);
  [[nodiscard]] Instant emulator_time() const;
  [[nodiscard]] Instant scheduler_time(Instant emulated) const;
  [[nodiscard]] Instant next_due() const;
  [[nodiscard]] int line_rate() const;

  void add_client(std::unique_ptr<Stream> stream, bool by_cable);
  void bytes_from(const Client& client, std::string_view bytes);
  void alarm();
  void advance(Instant when) const;
  void catch_up(Instant now);
  void run_until(Instant now);
  void step_to(Instant when);
  void finish_round();
  Duration time_off_the_wire(Instant now);
  void land(ByteLine::Byte byte);
  void take_output();
  void deliver();
  void spoil(std::string& bytes);
  Result<> operate(Device& device, const BenchCommand& command);
  Result<> apply(Device& device, const BenchCommand& command);
  void pull_cable(bool pulled);
  // serve_bus.cpp
  [[nodiscard]] BusTarget* board() const;
  void run_cycles(std::span<BusCycle> cycles);
  void run_cycle(BusCycle& cycle);
  void tell_interrupt();
  void pull_windows();

  Scheduler& scheduler_;
  HostOptions options_;
  Trouble trouble_;
  Instant began_;
  Timer timer_;
  Instant armed_for_{};        // this and the next in emulated time
  mutable Instant reached_{};  // looking moves time on too
  ByteLine incoming_, outgoing_;
  // Of the last reply, until the next question: when its last byte left (emulated time), how much later that
  // was done.
  Instant left_at_{};
  std::optional<Duration> late_;
  Duration heard_late_{};
  std::string fresh_, leaving_;  // output just taken; output at the end of the wire, ...
  int leaving_baud_ = 0;         // ... all of it sent at this rate
  std::vector<std::unique_ptr<Device>> devices_;
  std::vector<std::unique_ptr<Client>> clients_;
  std::vector<HostWindow*> windows_;
  std::vector<std::shared_ptr<BusClient>> bus_clients_;
  bool unplugged_ = false;
  int to_garble_ = 0, to_drop_ = 0, garbled_ = 0;
  std::deque<TimedBenchCommand> plan_;  // for each device; `at` in emulated time, earliest first
};

}  // namespace hw
