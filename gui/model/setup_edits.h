#pragma once
// Edited parameter values, compared with those of the controller and of a file. Nothing is sent until the
// user asks for it; written values are read back by the driver. GUI thread.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/intent.h"
#include "core/device/snapshot.h"
#include "core/session/parameter_file.h"

namespace hw::gui {

class SetupEdits {
 public:
  explicit SetupEdits(const Catalog& catalog);

  [[nodiscard]] std::size_t size() const { return edits_.size(); }
  /// The edited value; nothing: not edited.
  [[nodiscard]] std::optional<std::int64_t> edited(std::size_t i) const { return edits_[i]; }
  /// False: out of range, nothing changed; `why` states the range.
  bool set(std::size_t i, std::int64_t value, std::string* why = nullptr);
  void undo(std::size_t i) { edits_[i].reset(); }
  /// Edited value, else the controller's, else nothing.
  [[nodiscard]] std::optional<std::int64_t> shown(std::size_t i, const Snapshot& now) const;
  /// Returns whether the edited value differs from the controller's known one (or that is not known).
  [[nodiscard]] bool changed(std::size_t i, const Snapshot& now) const;
  [[nodiscard]] bool off_factory(std::size_t i, const Snapshot& now) const;
  [[nodiscard]] std::vector<std::size_t> to_send(const Snapshot& now) const;
  [[nodiscard]] int changes(const Snapshot& now) const;
  /// Drops edits that the controller has by now.
  void settle(const Snapshot& now);

  /// Takes the values of a file as edits. Returns sentences about omitted values.
  std::vector<std::string> take(const CheckedBackup& file, const Snapshot& now, int* differing = nullptr);
  /// All values as shown, for a file.
  [[nodiscard]] Backup to_file(const Snapshot& now) const;

  /// Returns whether every letter group of `filter` occurs in mnemonic, label, group, explanation or unit.
  [[nodiscard]] bool matches(std::size_t i, std::string_view filter) const;

 private:
  const Catalog& catalog_;
  std::vector<std::optional<std::int64_t>> edits_;
  std::vector<std::string> searched_;  ///< in lower case
};

/// Writes values one after another, each only when the previous one has succeeded.
class SetupWrite {
 public:
  using Send = std::function<IntentId(IntentBody)>;
  /// `confirmed`: the warnings of these parameters were read.
  void begin(const SetupEdits& edits, const Snapshot& now, const Catalog& catalog, bool confirmed,
             const Send& send);
  void update(const Snapshot& now, const Catalog& catalog, const Send& send);
  [[nodiscard]] bool busy() const { return next_ < values_.size(); }
  [[nodiscard]] std::size_t written() const { return next_; }
  [[nodiscard]] std::size_t all() const { return values_.size(); }
  /// The outcome, reported once: "3 values written." or the refusal.
  struct Report {
    bool good = true;
    std::string sentence;
  };
  Report take_report() { return std::exchange(report_, Report()); }

 private:
  void send_next(const Catalog& catalog, const Send& send);
  [[nodiscard]] std::string store_words(const Catalog& catalog) const;
  std::vector<std::pair<std::size_t, std::int64_t>> values_;
  std::size_t next_ = 0;
  IntentId waiting_for_ = 0;
  bool confirmed_ = false;
  Report report_;
};

/// A value in written form: "0.800" with decimals, "4EX07" with a prefix, else the number.
std::string value_text(const ParamInfo& param, std::int64_t value);
/// "0 or 1 to 600", "4EX00 to 4EX99", with the values in written form.
std::string range_in_words(const ParamInfo& param);
/// The parameter's unit, as its axes count now.
std::string unit_of(const ParamInfo& param, const Catalog& catalog, const Snapshot& now);
/// A value in words: the label of a choice, the names of set bits, or number and unit.
std::string value_in_words(const ParamInfo& param, std::int64_t value);

}  // namespace hw::gui
