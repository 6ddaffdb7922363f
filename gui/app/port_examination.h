#pragma once
// Examines ports for the link doctor. Reads files of the system on a thread of its own.
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "gui/model/worker.h"
#include "gui/shell/port_examiner.h"

namespace hw::app {

class PortExamination final : public gui::PortExaminer {
 public:
  explicit PortExamination(std::function<void()> wake) : reader_(std::move(wake), true) {}

  void examine(const std::string& path) override;
  const gui::ExaminedPort* find(const std::string& path) override;
  void set_adapter_timer(const std::string& path, int milliseconds) override;

 private:
  void keep_what_is_found(const std::string& path, std::function<gui::ExaminedPort()> look);

  std::map<std::string, gui::ExaminedPort> known_;
  std::shared_ptr<void> alive_ = std::make_shared<int>(0);
  gui::Worker reader_;
};

}  // namespace hw::app
