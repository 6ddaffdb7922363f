#pragma once
// Finds ports for the connection page, on the io thread. Lists serial ports by their files and asks each a
// harmless question.
#include <atomic>
#include <map>
#include <string>
#include <vector>

#include "core/base/ring.h"
#include "core/time/scheduler.h"
#include "gui/app/emulator_serving.h"
#include "gui/app/port_examination.h"
#include "gui/shell/port_finder.h"
#include "transports/scan.h"

namespace hw::app {

class PortWatch final : public gui::PortFinder {
 public:
  PortWatch(Scheduler& scheduler, std::function<void()> wake)
      : scheduler_(scheduler), wake_(wake), examination_(wake), serving_(scheduler, wake) {}

  const std::vector<gui::FoundPort>& ports() override;
  void look() override;
  void watch(bool on) override;
  void ask(const std::string& path) override;
  [[nodiscard]] bool busy() const override { return asking_ > 0; }
  [[nodiscard]] gui::PortExaminer* examiner() override { return &examination_; }
  [[nodiscard]] gui::EmulatorServer* server() override { return &serving_; }

  static constexpr Duration look_every = std::chrono::seconds(2);

 private:
  void take(PortReport& report);
  void list();
  void list_serial();
  void list_usb();

  Scheduler& scheduler_;
  std::function<void()> wake_;
  std::vector<gui::FoundPort> found_;
  std::map<std::string, SerialPort> known_;
  std::shared_ptr<Ring<PortReport>> reports_ = std::make_shared<Ring<PortReport>>(64);  // io -> GUI thread
  int asking_ = 0;
  bool watching_ = false;
  std::shared_ptr<std::atomic<bool>> usb_moved_ =
      std::make_shared<std::atomic<bool>>(false);  // set on the io thread
  std::shared_ptr<int> page_;                      // expires when the watch ends
  Instant listed_at_{};
  PortExamination examination_;
  EmulatorServing serving_;
};

}  // namespace hw::app
