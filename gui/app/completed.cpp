#include "gui/app/completed.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/log.h"
#include "core/device/registry.h"
#include "core/session/transport_list.h"

namespace hw::app {
namespace {

void put_word(std::string& words, std::string_view word) {
  if (!words.empty()) words += ' ';
  words += word;
}

std::string all_models() {
  std::string words;
  for (const DeviceType& type : device_types()) put_word(words, type.model);
  return words;
}

std::string example_addresses() {
  std::string words;
  for (const DeviceType& type : device_types()) {
    put_word(words, fmt::format("{}@emulator", type.model));
    const auto catalog = type.make_catalog({});
    if (!catalog) continue;
    for (const TransportInfo* way : ways_to(*catalog)) {
      const std::string where = way->example.empty() ? "" : fmt::format(":{}", way->example);
      put_word(words, fmt::format("{}@{}{}", type.model, way->name, where));
    }
  }
  return words;
}

std::string log_choices() {
  std::string words;
  const auto put_levels = [&](const std::string& subject) {
    for (int level = 0; level <= static_cast<int>(log::Level::debug); ++level)
      put_word(words, fmt::format("{}={}", subject, log::word_of(static_cast<log::Level>(level))));
  };
  for (const std::string_view family : log::families()) put_levels(std::string(family));
  for (const DeviceType& type : device_types()) put_levels(fmt::format("driver.{}", type.model));
  return words;
}

bool is_file(std::string_view placeholder) {
  for (const std::string_view part : {"FILE", "OUT", "PATH", "."})
    if (placeholder.find(part) != placeholder.npos && placeholder.find(':') == placeholder.npos) return true;
  return false;
}

}  // namespace

Completed completed(std::string_view placeholder) {
  Completed all;
  if (placeholder == "MODEL") all.words = all_models();
  if (placeholder == "ADDRESS") all.words = example_addresses();
  if (placeholder == "SUBJECT=LEVEL") all.words = log_choices();
  if (placeholder == "FORM") all.words = "man bash zsh fish";
  if (placeholder.find('|') != placeholder.npos) {
    all.words = placeholder;
    std::replace(all.words.begin(), all.words.end(), '|', ' ');
  }
  all.folders = placeholder == "FOLDER";
  all.ports = placeholder == "PORT";
  all.files = is_file(placeholder);
  if (const auto dot = placeholder.rfind('.'); all.files && dot != placeholder.npos)
    all.extension = placeholder.substr(dot + 1);
  return all;
}

}  // namespace hw::app
