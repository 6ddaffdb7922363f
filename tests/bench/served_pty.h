#pragma once
// An emulator behind a pseudo-terminal that takes the byte times of its rate, in a process of its own: what
// `handwheel emulate MODEL --pty PATH --wire real` is to other software.
#include <string>
#include <string_view>

namespace hw {

class ServedPty {
 public:
  /// vxm or pmx-4ex-sa, at a rate that it has. Returns when the terminal is there.
  ServedPty(std::string_view model, int baud);
  ~ServedPty();
  ServedPty(const ServedPty&) = delete;
  /// A file descriptor at that rate; negative: not opened.
  [[nodiscard]] int open_client(int baud) const;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
  int child_ = 0;
};

}  // namespace hw
