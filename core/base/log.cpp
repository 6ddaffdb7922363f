#include "core/base/log.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace hw::log {
namespace {

spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> one = [] {
    auto made =
        std::make_shared<spdlog::logger>("handwheel", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    made->set_pattern("%H:%M:%S.%e %l %v");
    made->set_level(spdlog::level::warn);
    return made;
  }();
  return *one;
}

spdlog::level::level_enum of(Level level) {
  switch (level) {
    case Level::quiet: return spdlog::level::off;
    case Level::error: return spdlog::level::err;
    case Level::warning: return spdlog::level::warn;
    case Level::info: return spdlog::level::info;
    case Level::debug: return spdlog::level::debug;
  }
  return spdlog::level::warn;
}

void write(Level level, std::string_view where, std::string_view sentence) {
  logger().log(of(level), "{}: {}", where, sentence);
}

}  // namespace

void set_level(Level level) { logger().set_level(of(level)); }
void error(std::string_view where, std::string_view sentence) { write(Level::error, where, sentence); }
void warning(std::string_view where, std::string_view sentence) { write(Level::warning, where, sentence); }
void info(std::string_view where, std::string_view sentence) { write(Level::info, where, sentence); }
void debug(std::string_view where, std::string_view sentence) { write(Level::debug, where, sentence); }

}  // namespace hw::log
