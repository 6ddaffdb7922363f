#pragma once
// The VXM driver: its parts, and the calls of the pump. Each part has its own state and a file of its name.
// On construction it is given the other parts that it needs, and nothing more.
//
//   conversation      questions and answers
//   greeting          the first answer
//   identification    model, version, Slave
//   signals           limits, inputs, outputs
//   parameters        values of set and get, storing
//   slots, scratch    the contents of the five programs; the program of the console's own moves
//   motor_readings    the motors that turn
//   speeds, hold      S and its origin; whether H is on
//   knowledge         values that are read once and hold until they change
//   presence          on-line, in Local mode, halted, restarted
//   job, under_way    runs under way, and how they end
//   ramp              motions that D slows down
//   positions         positions of the motors
//   headline          the most urgent message
//   kills             K
//   hold_switch       H
//   admission         whether a command may begin now
//   restarts, status  the state after a restart; the replies to V
//   legs, moves       moves, jogs, homing, zero, outputs: runs of an unused program
//   runs              run, hold, step
//   stops             stops (decision V102), and their progress
//   texts             raw text of users and scripts
//   echo, opening     making the controller listen
//   status_rounds     the round of status
//   unsolicited_messages   messages that no question asked for
#include <memory>
#include <string>

#include "core/device/driver.h"
#include "core/devices/vxm/driver_parts.h"

namespace hw::vxm {

std::unique_ptr<Driver> make_driver(DriverContext context);

class VxmDriver final : public Driver {
 public:
  explicit VxmDriver(DriverContext context);

  void attach(Station& station) override;
  Task<Result<>> connect() override;
  Task<Result<>> poll(Round round) override;
  void watch_inputs(Instant until) override { known_.signals.watch_inputs(until); }
  void watch_limits(Instant until) override { known_.signals.watch_limits(until); }
  Task<Result<>> perform(const IntentBody& intent) override;
  Task<Result<std::string>> stop(const StopOrder& order) override;
  [[nodiscard]] LastWill last_will(unsigned axes) const override;
  StopProgress stop_progress(const StopOrder& order) override;
  void wire_lost() override;
  Task<Result<std::string>> query(std::string text, Duration patience) override;
  [[nodiscard]] TextMeaning meaning_of(const intent::SendText& text) const override;
  [[nodiscard]] TextGoals goals_of(std::string_view text) const override;
  [[nodiscard]] bool clears_up() const override;
  [[nodiscard]] std::string leaves_behind() const override;
  [[nodiscard]] Duration moving_period() const override;
  [[nodiscard]] Duration idle_period() const override { return Millis(200); }

 private:
  Task<Result<>> find_out_all();
  Task<Result<>> make_ready();
  Task<Result<>> perform_program(const IntentBody& body);
  static int slot_of(const IntentBody& body);
  Task<Result<>> read_again();
  [[nodiscard]] Listening listening() const;

  const Console console_;
  Conversation conversation_;
  Known known_;
  Course course_;
  Work work_;
  Watch watch_;
};

}  // namespace hw::vxm
