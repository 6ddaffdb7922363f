#pragma once
// Log lines for a person or a service manager, to stderr and, in the console, to a file. Any thread. Results
// never go this way.
//
// Each line has a subject, a path: link, pump, driver.vxm, gui. Whoever decides something (drops, refuses,
// gives up) keeps the subject that it asked for once, and says why at debug:
//     log_.debug("{} dropped: {}", text, why);
// While nobody wants such lines, that costs one read of a number: nothing is formatted. What is costly to say
// at all (a sentence put together) stands behind log_.wants(log::Level::debug).
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
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
  [[nodiscard]] bool wants(Level level) const { return level <= level_.load(std::memory_order_relaxed); }
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
  /// A sentence as it stands, if this level is wanted.
  void say(Level level, std::string_view sentence) const {
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

/// The one of that name; it lives as long as the process. Look it up once: this takes a lock.
Subject& subject(std::string_view name);

/// Of all subjects that nobody chose a level for. Starts at `warning`.
void set_level(Level level);

/// "link=debug", "driver=info,pump=debug" (driver: driver.vxm and all others), or "debug" for everything. The
/// longest path that fits a subject counts. A fault says what there is.
Result<> choose(std::string_view choices);

/// From now on every line goes into this file too. It is turned over at 1 MB; three older ones are kept.
Result<> keep_in(const std::filesystem::path& file);

// Lines of whoever has no subject of its own.
void error(std::string_view where, std::string_view sentence);
void warning(std::string_view where, std::string_view sentence);
void info(std::string_view where, std::string_view sentence);
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
