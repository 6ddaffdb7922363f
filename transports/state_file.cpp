#include "transports/state_file.h"

#include "core/session/user_files.h"

namespace hw {

StateFile::StateFile(Scheduler& scheduler, std::string path, Trouble trouble)
    : scheduler_(scheduler),
      path_(std::move(path)),
      trouble_(std::make_shared<Trouble>(std::move(trouble))) {}

StateFile::~StateFile() { worker_.join(); }

void StateFile::keep(std::string text) {
  std::weak_ptr<Trouble> reported_to = trouble_;
  const Executor home = scheduler_.executor();
  asio::post(worker_, [path = path_, text = std::move(text), reported_to, home] {
    const Result<> written = write_file(path, text);
    if (written) return;
    Fault fault = written.error();
    fault.done =
        "The memory of the emulated controller is not saved; " + path + " still holds what was saved before.";
    asio::post(home, [reported_to, fault] {
      const auto trouble = reported_to.lock();
      if (trouble && *trouble) (*trouble)(fault);
    });
  });
}

}  // namespace hw
