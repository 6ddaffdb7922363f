#pragma once
// One plan at work: the real sessions, links and drivers on emulated controllers behind a faulty wire, in
// virtual time, and a judge who sees it all.
#include <memory>
#include <string>
#include <vector>

#include "core/session/session_group.h"
#include "core/time/virtual_scheduler.h"
#include "tests/simulation/judge.h"
#include "tests/simulation/keepsake.h"
#include "tests/simulation/models.h"
#include "tests/simulation/plan.h"
#include "tests/simulation/wire_faults.h"
#include "transports/serve.h"

namespace hw::simulation {

class Stage {
 public:
  explicit Stage(const Plan& plan);
  ~Stage();
  /// To the end of the plan, or to the first thing that breaks a law.
  void run();

  // ---- for the verbs
  [[nodiscard]] Instant now() const { return time_.now(); }
  [[nodiscard]] Judge& judge() { return judge_; }
  [[nodiscard]] const ModelFacts& facts() const { return facts_; }
  [[nodiscard]] int devices() const { return static_cast<int>(machines_.size()); }
  [[nodiscard]] WireFaults& faults() { return faults_; }
  void open();
  void close();
  void send(int device, IntentBody body);
  /// The latest that was.
  [[nodiscard]] IntentId sent() const { return sent_; }
  void type(int device, std::string text);
  /// The same; it may move those axes. `distance`: of one that no other move of the plan has, or 0.
  IntentId move(int device, std::uint32_t axes, Steps distance, IntentBody body);
  /// Ways of the first axis with its tool on, `lines` times 20 steps each, however long that is.
  void run_in_pieces(int device, int ways, int lines);
  /// The same, which the first two of a bus draw together; the tool is the first one's.
  void run_together(int ways, int lines);
  void stop(int device, std::uint32_t axes, StopKind kind, IntentBody body);
  void stop_all_devices(bool at_once);
  enum class LetGo : std::uint8_t { by_hand, never };
  /// As the panel does it: a keep-alive with each frame while it is held.
  void jog(int device, AxisId axis, Sign sign, Duration held, LetGo how);
  /// Typed into a tab that is being closed.
  void stop_closing(int device, std::string text);
  void query_stop(int device, std::uint32_t axes, std::string text, Duration patience);
  void query(int device, std::string text, Duration patience);
  void wait_until_idle(int device, Duration patience);
  /// Its calls one after the other, each when the one before has returned, until one fails.
  void script(int device, std::string_view calls);
  /// A wait that has to tell why all is not well.
  void wait_in_vain(int device, Duration patience);
  /// The first attempt to connect has to succeed.
  void must_connect(int device);
  void operate(int device, BenchCommand command);
  void other_host_sends(std::string_view bytes);
  void unplug(Duration how_long);
  /// And gives it back as soon as a supply can.
  void cut_power(int device);

 private:
  struct Hand;  // a jog that is held
  void make_machines();
  [[nodiscard]] std::vector<std::string> settings(std::size_t machine) const;
  Task<bool> answers(std::shared_ptr<Session> session, std::string text, Duration patience);
  Task<bool> is_idle(std::shared_ptr<Session> session, int device, Duration patience);
  Task<> play(std::shared_ptr<Session> session, std::vector<Step> calls);
  Task<bool> returns(std::shared_ptr<Session> session, Step call);
  Task<> close_and_look(std::shared_ptr<SessionGroup> group, int call);
  [[nodiscard]] bool may_judge_what_is_left(Instant closed_at) const;
  void judge_what_is_left(std::size_t machine);
  WireOpener opener();
  [[nodiscard]] Session* session(int device) const;
  void finish();

  Plan plan_;
  const ModelFacts& facts_;
  IoContext io_;
  VirtualScheduler time_{io_};
  WireFaults faults_;
  Address address_;
  Judge judge_;
  struct Machine {
    const Emulator* emulator;  ///< the host has it
    std::vector<std::string> questions;
    Words settings;         ///< before the console has come, and what the plan itself puts in
    bool reported = false;  ///< a closing console has said what it leaves behind
  };
  std::vector<Machine> machines_;
  std::shared_ptr<EmulatorHost> host_;
  std::unique_ptr<Stream> other_host_;
  std::shared_ptr<SessionGroup> group_;
  std::vector<std::shared_ptr<SessionGroup>> closing_;
  IntentId sent_ = 0;         ///< last
  int closing_now_ = 0;       ///< of those, they that still hold the port, which is opened exclusively
  bool opens_later_ = false;  ///< when it is free
  std::vector<std::unique_ptr<Hand>> bench_schedule_;
  std::unique_ptr<Timer> plug_in_;
  std::vector<std::unique_ptr<Timer>> power_;
};

}  // namespace hw::simulation
