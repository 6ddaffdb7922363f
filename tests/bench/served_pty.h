#pragma once
// An emulator behind a pseudo-terminal that takes the byte times of its rate, in a process of its own: what
// `handwheel emulate vxm --pty PATH --wire real` is to other software.
#include <string>

namespace hw {

class ServedPty {
 public:
  explicit ServedPty(int baud);  ///< returns when the terminal is there
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
