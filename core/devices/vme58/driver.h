#pragma once
// The VME58 driver: its parts, and the pump's requests to them. Each part has its own state and a file of its
// name; its constructor receives exactly the other parts that it needs.
//
//   wire, readings        bursts of bus cycles; registers and data area
//   selection             the axis that a text addresses
//   conversation          the rings: commands in, replies out, and the question of each reply
//   mailbox               urgent commands past everything that waits (decision M29)
//   commands              commands of the console, and rejections by the board
//   next_round, queues    the questions that are due; the board's command queues
//   parameter_values      the known set-up
//   limit_ends            switches
//   servo_loops           servo axes: places and loops
//   motions               the motion of each axis
//   speeds                VL, which a move with a speed of its own borrows
//   status_questions      the questions of a status round that are commands
//   lines                 inputs and outputs
//   servo_drive, moves, actions, setup
//                         commands of the user
//   stop_effect, all_stop, stops
//                         stops, and their progress
//   effects, feed, programs, texts
//                         command strings of users, scripts and programs
//   samples               recordings of one axis
//   finding               identifying the board
#include <functional>
#include <memory>
#include <string>

#include "core/device/driver.h"
#include "core/devices/vme58/driver_parts.h"
#include "core/devices/vme58/finding.h"
#include "core/devices/vme58/samples.h"

namespace hw::vme58 {

std::unique_ptr<Driver> make_driver(DriverContext context);

class Vme58Driver final : public Driver, private Readings::Listener {
 public:
  explicit Vme58Driver(DriverContext context);

  void attach(Station& station) override;
  Task<Result<>> connect() override;
  Task<Result<>> poll(Round round) override;
  Task<Result<>> perform(const IntentBody& intent) override;
  Task<Result<std::string>> stop(const StopOrder& order) override;
  [[nodiscard]] LastWill last_will(unsigned axes) const override;
  StopProgress stop_progress(const StopOrder& order) override;
  void wire_lost() override;
  Task<Result<std::string>> query(std::string text, Duration patience) override;
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& text) const override;
  [[nodiscard]] TextGoals goals_of(std::string_view text) const override;
  [[nodiscard]] Duration moving_period() const override;
  [[nodiscard]] Duration idle_period() const override;

 private:
  void registers_read(const Registers& registers) override;
  void axes_read(int whole, Instant at) override;

  // ---- driver_connect.cpp
  Task<Result<>> found_reset(Doubt why);
  Task<Result<>> reset_by_text(std::string text);
  Task<Result<>> reset();
  Task<Result<>> starts_again(std::string_view how);
  Task<Result<>> read_state();
  void lose_motions();
  void forget();

  // ---- driver.cpp
  Task<Result<>> read_more(Registers registers);
  void record_round();
  void show_worst();
  Task<Result<>> carry_out(const IntentBody& body);
  Task<Result<>> send_text(std::string text);
  [[nodiscard]] int axes() const { return static_cast<int>(catalog_.axes.size()); }

  const Catalog& catalog_;
  Snapshot& snapshot_;
  ScriptTexts& script_texts_;
  std::function<void()> changed_;

  Talk talk_;
  Known known_;
  Work work_;
  Strings strings_;
  Samples samples_;
  Finding finding_;

  bool connected_before_ = false;
  std::string round_text_;  ///< kept so that its memory is reused
};

}  // namespace hw::vme58
