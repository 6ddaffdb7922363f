#pragma once
// Gives emulators a clock and a wire: a single controller, or several on the same line (RS-485). Each
// attached stream is an end of that wire. Bytes of a client reach all controllers, bytes of a controller
// reach all clients, and bytes that two controllers send at once arrive as garbage. Io thread only.
//
// Time: the emulators' time is zero when their host is made, and runs `speed` times as fast as the
// scheduler's time. With `byte_times` a byte takes effect when its last bit has arrived and leaves ten bit
// times after the byte before it, at the rate of the first controller; an end at another rate garbles both
// ways. Without `byte_times` the wire has no rate and no delay.
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "core/emulation/bench_file.h"
#include "core/emulation/emulator.h"
#include "core/session/wire.h"
#include "transports/byte_line.h"
#include "transports/state_file.h"

namespace hw {

struct HostOptions {
  std::string name = "emulator";  ///< for messages: "vxm emulator"
  bool byte_times = false;
  double speed = 1;
  /// The file of the memory; empty: the memory is lost at the end. Each of several controllers has a file of
  /// its own: this name, a dot and its id.
  std::string state_file;
};

struct HostedDevice {
  std::string id;  ///< on a line with several devices: "07"
  std::unique_ptr<Emulator> emulator;
};

class EmulatorHost final : public std::enable_shared_from_this<EmulatorHost> {
 public:
  /// Makes a host with at least one device. Loads existing state files. `trouble` is called when a state file
  /// could not be written, and when a bus port client was disconnected.
  static Result<std::shared_ptr<EmulatorHost>> make(Scheduler& scheduler, std::vector<HostedDevice> devices,
                                                    HostOptions options, Trouble trouble = {});
  static Result<std::shared_ptr<EmulatorHost>> make(Scheduler& scheduler, std::unique_ptr<Emulator> emulator,
                                                    HostOptions options, Trouble trouble = {});
  ~EmulatorHost();

  /// Adds a client's end (an accepted connection, a pty's master side) until it closes. While the cable is
  /// pulled the client stays open and its bytes are lost.
  void attach(std::unique_ptr<Stream> client);
  /// Returns the end of a new cable in this process. It closes when the cable is pulled. A fault while the
  /// cable is pulled. `baud` is the rate of the client's port; 0: that of the controller.
  Result<std::unique_ptr<Stream>> plug_in(int baud = 0);

  /// Whether the device is a board in a memory window, which only the next two functions reach.
  [[nodiscard]] bool is_board() const { return board() != nullptr; }
  /// Returns a window onto the board in this process. It closes when the cable is pulled. A fault while the
  /// cable is pulled.
  Result<std::unique_ptr<Window>> plug_in_window();
  /// Adds a client of a bus port until it closes or sends an invalid message.
  void attach_bus(std::unique_ptr<Stream> client);

  /// The bench of a device. It keeps the host alive.
  [[nodiscard]] std::shared_ptr<BenchAccess> bench(std::size_t device = 0);
  [[nodiscard]] std::size_t device_count() const { return devices_.size(); }
  /// The host of a bench; null: the bench has no EmulatorHost.
  static std::shared_ptr<EmulatorHost> of(const std::shared_ptr<BenchAccess>& bench);
  /// Sets each device on such a bench. Start commands of the file are carried out now, the rest in the
  /// emulators' time from now on.
  Result<> set_up(const BenchFile& bench);

  [[nodiscard]] const HostOptions& options() const { return options_; }

 private:
  struct Client;
  class Device;
  // serve_bus.cpp
  class HostWindow;
  struct BusClient;
  static constexpr Duration at_once = Millis(2);
  /// Time that the kernel takes to pass a reply to another program and its next question back to this
  /// program.
  static constexpr Duration hand_over = std::chrono::microseconds(400);

  /// The last reply, until the next question.
  struct LastReply {
    Instant left_at{};             ///< when its last byte was due to leave; emulated time
    std::optional<Duration> late;  ///< delay of its sending
    Duration late_by{};            ///< delay of the question
  };
  /// Output that was just taken, all sent at this rate.
  struct Sent {
    std::string fresh, leaving;
    int baud = 0;
  };
  /// Faults of the cable, made by the bench.
  struct Faults {
    bool unplugged = false;
    int to_garble = 0, to_drop = 0, garbled = 0;  ///< bytes
  };

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
  void notify_interrupt();
  void pull_windows();

  Scheduler& scheduler_;
  HostOptions options_;
  Trouble trouble_;
  Instant began_;
  Timer timer_;
  Instant armed_for_{};        // emulated time, as `reached_`
  mutable Instant reached_{};  // reading the clock advances it too
  ByteLine incoming_, outgoing_;
  LastReply reply_;
  Sent sent_;
  std::vector<std::unique_ptr<Device>> devices_;
  std::vector<std::unique_ptr<Client>> clients_;
  std::vector<HostWindow*> windows_;
  std::vector<std::shared_ptr<BusClient>> bus_clients_;
  Faults faults_;
  std::deque<TimedBenchCommand> plan_;  // commands for each device; `at` is emulated time, earliest first
};

}  // namespace hw
