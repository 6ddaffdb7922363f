#pragma once
// The VXM driver: its parts, and the calls of the pump. Each part has its own state and a file of its name.
// On construction it is given the other parts that it needs, and nothing more.
//
//   conversation      questions and answers
//   greeting          what answers at first
//   identification    what it is
//   signals           limits, inputs, outputs
//   parameters        values of set and get, storing
//   slots, scratch    what its five programs hold; the one of the console's own moves
//   motor_readings    which motors turn
//   speeds, hold      S, and whose it is; whether H is on
//   knowledge         what is read once and holds until it changes
//   presence          whether and how it listens
//   job, under_way    what goes on in it, and how that ends
//   ramp              motions that D slows down
//   positions         where the motors are
//   headline          what needs attention most
//   kills             K
//   hold_switch       H
//   admission         whether something may be begun now
//   restarts, status  the state after a restart; the replies to V
//   legs, moves       moves, jogs, homing, zero, outputs: runs of a program that nobody uses
//   runs              run, hold, step
//   stops             stops (decision V102), and what shows of them
//   texts             raw text of users and scripts
//   echo, opening     getting it to listen
//   status_rounds     the round of status
//   unsolicited_messages   what it sends unasked
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
