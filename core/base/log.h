#pragma once
// Log lines for a person or a service manager, to stderr and, in the console, to a file and a list
// (log_feed.h). Any thread. Never used for results.
//
// Each line has a subject, a path: link, pump, driver.vxm, gui. Code that decides something (drops, refuses,
// gives up) looks its subject up once and logs the reason at debug:
//     log_.debug("{} dropped: {}", text, why);
// While the level is off, a line costs one read of a number: nothing is formatted. Put a line that is costly
// to build behind log_.wants(log::Level::debug).
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "core/base/result.h"

namespace hw::log {

enum class Level : std::uint8_t { quiet, error, warning, info, debug };

class Subject {
 public:
  Subject(std::string name, Level level) : name_(std::move(name)), level_(level) {}

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool wants(Level level) const { return level <= this->level(); }
  [[nodiscard]] Level level() const { return level_.load(std::memory_order_relaxed); }
  void set_level(Level level) { level_.store(level, std::memory_order_relaxed); }

  template <class... T>
  void debug(fmt::format_string<T...> format, T&&... values) const {
    if (wants(Level::debug)) [[unlikely]]
      write(Level::debug, fmt::format(format, std::forward<T>(values)...));
  }
  template <class... T>
  void warning(fmt::format_string<T...> format, T&&... values) const {
    if (wants(Level::warning)) write(Level::warning, fmt::format(format, std::forward<T>(values)...));
  }
  /// Logs a finished sentence, if this level is wanted.
  void add(Level level, std::string_view sentence) const {
    if (wants(level)) write(level, sentence);
  }

 private:
  void write(Level level, std::string_view sentence) const;

  std::string name_;
  std::atomic<Level> level_;
};

/// Bytes of a wire in a line: "PM-1\\r\\x06".
struct Bytes {
  std::string_view bytes;
};
std::string written(Bytes bytes);

/// The subject of that name; it lives as long as the process. Look it up once: this takes a lock.
Subject& subject(std::string_view name);

/// The tops of all subjects: "link", "driver".
std::span<const std::string_view> families();
/// "debug".
std::string_view word_of(Level level);
/// Sets the level of a path and of all below it: "driver", "driver.vxm". Empty: of everything; initially
/// `warning`. subject(path).level() returns it.
void set_level(std::string_view path, Level level);

/// "link=debug", "driver=info,pump=debug" (driver: driver.vxm and all others), or "debug" for everything. The
/// longest path that fits a subject counts. The fault lists the subjects and levels.
Result<> choose(std::string_view choices);

/// Logs to this file too, from now on. Rotated at 1 MB; three older files are kept.
Result<> keep_in(const std::filesystem::path& file);

// For code without a subject of its own.
void error(std::string_view where, std::string_view sentence);
void warning(std::string_view where, std::string_view sentence);
void debug(std::string_view where, std::string_view sentence);

}  // namespace hw::log

template <>
struct fmt::formatter<hw::log::Bytes> {
  constexpr auto parse(fmt::format_parse_context& context) { return context.begin(); }
  auto format(hw::log::Bytes bytes, fmt::format_context& context) const {
    const std::string text = hw::log::written(bytes);
    return std::copy(text.begin(), text.end(), context.out());
  }
};
