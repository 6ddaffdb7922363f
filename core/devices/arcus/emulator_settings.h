#pragma once
// The values behind every "NAME" and "NAME=value" of a model, found by its table of settings.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/devices/arcus/facts.h"

namespace hw::arcus {

class Settings {
 public:
  explicit Settings(const Model& model);

  [[nodiscard]] bool has(Setting id) const { return fact(id) != nullptr; }
  [[nodiscard]] const SettingFact* fact(Setting id) const { return facts_[static_cast<std::size_t>(id)]; }
  /// 0 for a setting that the model does not have.
  [[nodiscard]] std::int64_t get(Setting id, int which = 0) const;
  [[nodiscard]] bool on(Setting id, int which = 0) const { return get(id, which) != 0; }
  void set(Setting id, std::int64_t value, int which = 0);

  /// The value as a reply shows it.
  [[nodiscard]] std::string text(const SettingFact& fact, std::int64_t value) const;
  /// None: malformed or out of range.
  [[nodiscard]] std::optional<std::int64_t> parse(const SettingFact& fact, std::string_view text) const;

  /// Factory values for all settings, or only for those that STORE does not keep.
  void reset(bool stored_too);
  /// Copies the stored settings of `from`.
  void take_stored(const Settings& from);
  /// Writes what STORE keeps as lines `FORM=value` ("SCVX=0"), and reads one back. False: no such line.
  void append_stored(std::string& lines) const;
  bool load_line(std::string_view line);

 private:
  [[nodiscard]] std::string name_of(const SettingFact& fact, int which) const;

  const Model* model_;
  std::array<const SettingFact*, setting_count> facts_{};
  std::array<std::size_t, setting_count> places_{};
  std::vector<std::int64_t> values_;
};

/// A whole number with an optional sign; none for anything else, or for more than 18 digits.
std::optional<std::int64_t> parse_integer(std::string_view text);

}  // namespace hw::arcus
