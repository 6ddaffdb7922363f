#pragma once
// What is logged while it lives, at debug, for a test to read; stderr stays quiet.
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/log_feed.h"

namespace hw::test {

class LogReader {
 public:
  LogReader() {
    testing::internal::CaptureStderr();
    log::set_level("", log::Level::debug);
  }
  ~LogReader() {
    log::set_level("", log::Level::warning);
    testing::internal::GetCapturedStderr();
  }
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;

  /// All lines so far: "pump: vxm: stop 1 (everything) is over\n".
  const std::string& text() {
    feed_.lines.drain(
        [this](const log::Line& line) { text_ += fmt::format("{}: {}\n", line.subject, line.sentence); });
    return text_;
  }

 private:
  log::Feed feed_{nullptr};
  std::string text_;
};

}  // namespace hw::test
