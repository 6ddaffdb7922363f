#include "core/base/log.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <spdlog/sinks/rotating_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>

#include "core/base/log_feed.h"
#include "core/base/log_levels.h"

namespace hw::log {
namespace {

constexpr std::string_view subjects_there_are[] = {"link", "pump",    "driver", "script",
                                                   "gui",  "emulate", "sleep"};
constexpr std::pair<std::string_view, Level> level_words[] = {{"off", Level::quiet},
                                                              {"error", Level::error},
                                                              {"warning", Level::warning},
                                                              {"info", Level::info},
                                                              {"debug", Level::debug}};
constexpr std::size_t largest_file = 1'000'000;
constexpr std::size_t older_files = 3;
constexpr std::size_t lines_for_a_reader = 1024;  // between two of its frames

std::string time_of_day_now() {
  const auto now = std::chrono::system_clock::now();
  const auto ms =
      std::chrono::duration_cast<std::chrono::milliseconds>(now.time_since_epoch()).count() % 1000;
  const std::time_t at = std::chrono::system_clock::to_time_t(now);
  std::tm day{};
  localtime_r(&at, &day);
  return fmt::format("{:02}:{:02}:{:02}.{:03}", day.tm_hour, day.tm_min, day.tm_sec, ms);
}

}  // namespace

// Shared by all threads. Never destroyed, as a thread may log while the process ends.
struct Desk {
  std::mutex mutex;
  std::map<std::string, std::unique_ptr<Subject>, std::less<>> subjects;
  std::map<std::string, Level, std::less<>> chosen;  // by path
  Level usual = Level::warning;
  spdlog::logger to_screen{"handwheel", std::make_shared<spdlog::sinks::stderr_sink_st>()};
  std::unique_ptr<spdlog::logger> to_file;
  std::vector<Feed*> readers;

  Desk() {
    to_screen.set_pattern("%H:%M:%S.%e %l %v");
    to_screen.set_level(spdlog::level::trace);
  }

  [[nodiscard]] Level level_of(std::string_view name) const {
    for (std::string_view path = name; !path.empty();) {
      if (const auto rule = chosen.find(path); rule != chosen.end()) return rule->second;
      const auto dot = path.rfind('.');
      path = path.substr(0, dot == path.npos ? 0 : dot);
    }
    return usual;
  }
  void apply() {
    for (auto& [name, subject] : subjects) subject->set_level(level_of(name));
  }
  void publish_to_readers(Level level, std::string_view subject, std::string_view sentence) {
    if (readers.empty()) return;
    const std::string time = time_of_day_now();
    for (Feed* reader : readers) {
      reader->lines.push_in_place([&](Line& line) {
        line.time = time;
        line.level = level;
        line.subject = subject;
        line.sentence = sentence;
      });
      if (reader->wake_) reader->wake_();
    }
  }
};

namespace {

Desk& desk() {
  static Desk& one = *new Desk();
  return one;
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

std::optional<Level> level_named(std::string_view word) {
  for (const auto& [name, level] : level_words)
    if (name == word) return level;
  return std::nullopt;
}

// Only drivers have subjects below their own. The names of the models are not known here.
bool is_subject(std::string_view path) {
  constexpr std::string_view of_a_driver = "driver.";
  return (path.starts_with(of_a_driver) && path.size() > of_a_driver.size()) ||
         std::find(std::begin(subjects_there_are), std::end(subjects_there_are), path) !=
             std::end(subjects_there_are);
}

/// "link, driver, driver.MODEL or sleep".
std::string possible_subjects() {
  std::string all;
  for (const std::string_view one : subjects_there_are) {
    const bool last = one == *std::rbegin(subjects_there_are);
    all += fmt::format("{}{}{}",
                       all.empty() ? ""
                       : last      ? " or "
                                   : ", ",
                       one, one == "driver" ? ", driver.MODEL" : "");
  }
  return all;
}

Result<> choose_one(std::string_view choice) {
  const auto equals = choice.find('=');
  const std::string_view path = equals == choice.npos ? "" : choice.substr(0, equals);
  const auto level = level_named(equals == choice.npos ? choice : choice.substr(equals + 1));
  if (!level || (equals != choice.npos && !is_subject(path)))
    return fail(FaultKind::text, fmt::format("\"{}\" names no subject and level of the log.", choice), {},
                "Give SUBJECT=LEVEL: " + possible_subjects() + ", and off, error, warning, info or debug.");
  const std::lock_guard lock(desk().mutex);
  if (path.empty())
    desk().usual = *level;
  else
    desk().chosen.insert_or_assign(std::string(path), *level);
  desk().apply();
  return {};
}

}  // namespace

void Subject::write(Level level, std::string_view sentence) const {
  const std::lock_guard lock(desk().mutex);
  desk().to_screen.log(of(level), "{}: {}", name_, sentence);
  if (desk().to_file) desk().to_file->log(of(level), "{}: {}", name_, sentence);
  desk().publish_to_readers(level, name_, sentence);
}

Feed::Feed(std::function<void()> wake) : lines(lines_for_a_reader), wake_(std::move(wake)) {
  const std::lock_guard lock(desk().mutex);
  desk().readers.push_back(this);
}
Feed::~Feed() {
  const std::lock_guard lock(desk().mutex);
  std::erase(desk().readers, this);
}

std::string written(Bytes bytes) {
  constexpr std::size_t most = 200;
  std::string out;
  for (const char c : bytes.bytes.substr(0, most)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\r')
      out += "\\r";
    else if (c == '\n')
      out += "\\n";
    else if (c == '\\')
      out += "\\\\";
    else if (byte < 0x20 || byte > 0x7E)
      out += fmt::format("\\x{:02x}", byte);
    else
      out += c;
  }
  if (bytes.bytes.size() > most) out += fmt::format(" and {} bytes", bytes.bytes.size() - most);
  return out;
}

Subject& subject(std::string_view name) {
  const std::lock_guard lock(desk().mutex);
  auto& subjects = desk().subjects;
  auto found = subjects.find(name);
  if (found == subjects.end())
    found = subjects.emplace(name, std::make_unique<Subject>(std::string(name), desk().level_of(name))).first;
  return *found->second;
}

std::span<const std::string_view> families() { return subjects_there_are; }

std::string_view word_of(Level level) {
  for (const auto& [name, value] : level_words)
    if (value == level) return name;
  return "off";
}

std::optional<Level> common_level(std::string_view path) {
  const std::lock_guard lock(desk().mutex);
  const Level level = desk().level_of(path);
  for (const auto& [name, subject] : desk().subjects) {
    const bool below = path.empty() || (name.starts_with(path) && name.substr(path.size()).starts_with('.'));
    if (below && subject->level() != level) return std::nullopt;
  }
  for (const auto& [chosen, other] : desk().chosen) {
    const bool below =
        path.empty() || (chosen.starts_with(path) && chosen.substr(path.size()).starts_with('.'));
    if (below && other != level) return std::nullopt;
  }
  return level;
}

void set_level(std::string_view path, Level level) {
  const std::lock_guard lock(desk().mutex);
  auto& chosen = desk().chosen;
  std::erase_if(chosen, [path](const auto& rule) {
    const std::string& name = rule.first;
    return path.empty() ||
           (name.starts_with(path) && (name.size() == path.size() || name[path.size()] == '.'));
  });
  if (path.empty())
    desk().usual = level;
  else
    chosen.insert_or_assign(std::string(path), level);
  desk().apply();
}

Result<> choose(std::string_view choices) {
  for (std::size_t from = 0; from <= choices.size();) {
    const std::size_t comma = std::min(choices.find(',', from), choices.size());
    if (auto understood = choose_one(choices.substr(from, comma - from)); !understood) return understood;
    from = comma + 1;
  }
  return {};
}

Result<> keep_in(const std::filesystem::path& file) {
  try {
    spdlog::file_event_handlers private_file;
    private_file.after_open = [](const spdlog::filename_t&, std::FILE* open) {
      struct stat about {};
      if (::fstat(::fileno(open), &about) == 0 && S_ISREG(about.st_mode)) ::fchmod(::fileno(open), 0600);
    };
    auto sink = std::make_shared<spdlog::sinks::rotating_file_sink_st>(file.string(), largest_file,
                                                                       older_files, false, private_file);
    auto made = std::make_unique<spdlog::logger>("file", std::move(sink));
    made->set_pattern("%Y-%m-%d %H:%M:%S.%e %l %v");
    made->set_level(spdlog::level::trace);
    made->flush_on(spdlog::level::trace);  // the last lines matter most when the program crashes
    const std::lock_guard lock(desk().mutex);
    desk().to_file = std::move(made);
    return {};
  } catch (const spdlog::spdlog_ex& why) {
    return fail(FaultKind::port, fmt::format("The log cannot be kept in {}: {}.", file.string(), why.what()));
  }
}

void error(std::string_view where, std::string_view sentence) { subject(where).add(Level::error, sentence); }
void warning(std::string_view where, std::string_view sentence) {
  subject(where).add(Level::warning, sentence);
}
void debug(std::string_view where, std::string_view sentence) { subject(where).add(Level::debug, sentence); }

}  // namespace hw::log
