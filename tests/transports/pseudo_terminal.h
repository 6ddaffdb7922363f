#pragma once
// Tests that need a pseudo-terminal say so where there is none (a sandbox without /dev/ptmx), and do not run.
#include <cstdlib>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace hw::test {

inline bool has_pseudo_terminals() {
  static const bool found = [] {
    const int fd = ::posix_openpt(O_RDWR | O_NOCTTY);
    if (fd < 0) return false;
    const bool usable = ::grantpt(fd) == 0 && ::unlockpt(fd) == 0 && ::ptsname(fd) != nullptr;
    ::close(fd);
    return usable;
  }();
  return found;
}

}  // namespace hw::test

#define HW_NEEDS_PSEUDO_TERMINAL() \
  if (!::hw::test::has_pseudo_terminals()) GTEST_SKIP() << "There is no pseudo-terminal here."
