#pragma once
// One open controller, as seen by the rest of the console. Three kinds of members: any thread may send
// intents; one reader thread takes snapshots and reads rings; the io thread does the rest.
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "core/base/latest.h"
#include "core/device/pump.h"
#include "core/device/state_log.h"
#include "core/session/begun_here.h"
#include "core/session/saved_places.h"
#include "core/session/shared_wire.h"

namespace hw {

class Session : public std::enable_shared_from_this<Session> {
 public:
  /// Io thread. `wake` is called on the io thread when the reader has something new to read.
  static Result<std::shared_ptr<Session>> open(Scheduler& scheduler, const Address& address,
                                               WireOpener opener, std::function<void()> wake);
  /// The same on a shared wire. `place`: index of its id in the wire's address.
  static Result<std::shared_ptr<Session>> open_on(Scheduler& scheduler, const Address& address,
                                                  std::shared_ptr<SharedWire> wire, std::size_t place,
                                                  std::function<void()> wake);
  /// The same with a `type` that need not be in device_types().
  static Result<std::shared_ptr<Session>> open_as(const DeviceType& type, Scheduler& scheduler,
                                                  const Address& address, std::shared_ptr<SharedWire> wire,
                                                  std::size_t place, std::function<void()> wake);
  ~Session();

  // ---- any thread
  /// `asked_at`: when the user asked, from which stop times are measured. None: now.
  IntentId send(IntentBody body, std::optional<Instant> asked_at = {});
  void operate_bench(BenchCommand command);
  [[nodiscard]] const Catalog& catalog() const { return catalog_; }
  [[nodiscard]] const DeviceType& type() const { return type_; }
  [[nodiscard]] const Address& address() const { return address_; }
  [[nodiscard]] Instant now() const { return scheduler_.now(); }
  /// Whether the controller's motion or program was begun through this session.
  [[nodiscard]] bool begun_here() const { return begun_here_.any(); }

  // ---- the one reader thread
  const Snapshot& snapshot() { return reader_.snapshot.view(); }
  const BenchView& bench_view() { return reader_.bench.view(); }
  [[nodiscard]] TrafficRing& traffic() { return reader_.traffic; }
  [[nodiscard]] Ring<Notice>& notices() { return reader_.notices; }
  [[nodiscard]] Ring<Ending>& endings() { return reader_.endings; }
  [[nodiscard]] Ring<AxisSample>& samples() { return reader_.samples; }

  // ---- io thread
  [[nodiscard]] const Snapshot& known() const { return pump_.known(); }
  [[nodiscard]] Pump& pump() { return pump_; }
  [[nodiscard]] const std::shared_ptr<BenchAccess>& bench() const { return bench_; }
  /// Places of scripts.
  [[nodiscard]] SavedPlaces& places() { return places_; }
  /// Sends the intent and resumes with its outcome.
  Task<Result<>> perform(IntentBody body);
  /// With outcome(): the same in two steps, for several controllers at once.
  IntentId post(IntentBody body);
  /// Sends a script's raw text; the next wait_until_idle() reports a refusal.
  IntentId send_text(std::string text, bool to_all);
  Task<Result<>> outcome(IntentId id);
  /// Resumes when the controller answers, or with the reason why the first attempt failed.
  Task<Result<>> wait_until_connected();
  /// The text of a stored program, read from the controller.
  Task<Result<std::string>> listing(int slot);
  /// Resumes when nothing moves or runs and the state is fresh.
  Task<Result<>> wait_until_idle(Duration patience);
  Task<> close();

  static constexpr std::size_t traffic_capacity = 1 << 14;  ///< some seconds of the fastest wire

 private:
  Session(Scheduler& scheduler, Address address, const DeviceType& type, Catalog catalog,
          std::shared_ptr<SharedWire> wire, std::size_t place, std::function<void()> wake);
  Task<Result<std::shared_ptr<Link>>> open_wire();
  void take(Intent intent);
  void follow_texts(const Snapshot& snapshot);
  void show(const Snapshot& snapshot);
  void show_bench();
  void report(Notice notice);

  /// What the io thread gives to the reader thread.
  struct ForReader {
    explicit ForReader(std::function<void()> wakes) : wake(std::move(wakes)) {}
    std::function<void()> wake;
    Latest<Snapshot> snapshot;
    Latest<BenchView> bench;
    TrafficRing traffic{traffic_capacity};
    Ring<Notice> notices{1024};
    Ring<Ending> endings{1024};
    Ring<AxisSample> samples{1 << 14};
  };
  struct ScriptsTexts {
    std::vector<IntentId> sent;  ///< with unknown outcome
    std::string refused;         ///< why the first was refused; until the next wait
  };

  Scheduler& scheduler_;
  const Address address_;
  const DeviceType& type_;
  const Catalog catalog_;
  const std::shared_ptr<SharedWire> wire_;
  const std::size_t place_;  ///< among the devices on the wire
  std::atomic<IntentId> last_intent_{0};
  BegunHere begun_here_{catalog_};
  IntentId posted_ = 0;  ///< latest intent given to the pump
  ScriptsTexts scripts_texts_;
  ForReader reader_;
  std::shared_ptr<BenchAccess> bench_;
  BenchView bench_view_;
  SavedPlaces places_;
  std::map<int, std::string> listings_;  ///< by slot, as last reported
  Snapshot shown_;                       ///< snapshot of the reader's latest wake
  StateLog state_log_{catalog_};
  FaultKind why_no_wire_ = FaultKind::lost;  ///< of the latest attempt to open it
  Pump pump_;
};

/// Why a motion or program has not finished normally, as a sentence; empty: it has.
std::string why_not_finished(const Snapshot& snapshot, const Catalog& catalog);
/// The axis that this sentence names; -1: none.
int axis_not_finished(const Snapshot& snapshot, const Catalog& catalog);

}  // namespace hw
