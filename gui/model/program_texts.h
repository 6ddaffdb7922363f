#pragma once
// The texts of one controller's program slots: the typed text, its file, its report by the language, and the
// program that the controller is known to hold. GUI thread.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/controller_state.h"
#include "core/device/language.h"
#include "core/device/snapshot.h"
#include "core/session/autosave.h"
#include "core/session/text_file.h"
#include "gui/model/severity.h"
#include "gui/model/text_diff.h"

namespace hw::gui {

/// The known content of a slot in the controller.
struct HeldProgram {
  bool known = false;      ///< false: never read, or possibly changed since
  bool from_here = false;  ///< loaded from the text of this console
  bool runs_on = false;    ///< no longer known, but a run begun before still goes on, and is of this program
  bool whole = true;       ///< false: contains code unknown here, which `text` omits
  std::vector<std::string> listing;  ///< canonical commands
  std::string text;                  ///< as loaded or listed
  ProgramReport report;              ///< of `text`
  Instant at{};                      ///< when loaded or read
};

class ProgramTexts {
 public:
  /// `language` null: texts are kept, but not analysed.
  ProgramTexts(const ProgramFacts& facts, const Language* language);

  [[nodiscard]] int count() const { return static_cast<int>(slots_.size()); }
  [[nodiscard]] int chosen() const { return chosen_; }
  void choose(int slot);
  /// The program that a run of the slot's text starts: the slot itself or, where one text holds all programs,
  /// the one chosen for it; if the text has no such program, its first.
  int start_of(int slot);
  /// Where one text holds all programs: the program that Run starts.
  void choose_start(int program) { start_ = program; }

  // ---- text
  [[nodiscard]] const std::string& text(int slot) const { return at(slot).text; }
  /// Grows with each change, whatever its source. A view with an older version takes the text again.
  [[nodiscard]] std::uint64_t version(int slot) const { return at(slot).version; }
  void set_text(int slot, std::string text);
  /// Analysed anew only when the text has changed.
  const ProgramReport& report(int slot);
  /// Sum over the slot, in the catalog's unit.
  int cost(int slot);

  // ---- files
  [[nodiscard]] const std::filesystem::path& file(int slot) const { return at(slot).path; }
  [[nodiscard]] std::string file_name(int slot) const { return at(slot).path.filename().string(); }
  /// Returns whether the text differs from its file, or has none.
  [[nodiscard]] bool edited(int slot) const;
  void opened(int slot, std::filesystem::path path, TextFile file);
  [[nodiscard]] TextFile to_save(int slot) const;
  /// The known content of its file; none: not read since the text was recovered.
  [[nodiscard]] std::optional<std::string> known_in_file(int slot) const;
  /// `text` is what was written: the slot's text may have been edited since.
  void saved(int slot, std::filesystem::path path, std::string_view text);
  [[nodiscard]] std::vector<UnsavedText> unsaved() const;
  void restore(const std::vector<UnsavedText>& texts);
  /// Changes with every text or file: for the autosave.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }

  // ---- contents of the controller
  [[nodiscard]] const HeldProgram& held(int slot) const { return at(slot).held; }
  /// LoadProgram has succeeded.
  void loaded(int slot, const std::string& text, Instant when);
  /// UploadProgram returned this listing; not `whole`: only the part that was understood.
  void listed(int slot, const std::string& listing, Instant when, bool whole = true);
  void cleared(int slot, Instant when);
  /// The slots may have been changed by others (lost wire, reset). A run under way continues.
  void doubt();
  /// The slots were changed by others.
  void forget();
  /// The run under way when the slots became doubtful has ended.
  void nothing_runs();
  /// Returns whether the lines that the controller reports can be found in the loaded or listed text.
  [[nodiscard]] bool lines_known(int slot) const {
    return held(slot).whole && (held(slot).known || held(slot).runs_on);
  }
  /// Returns whether the controller is known to hold the present text.
  bool controller_has(int slot);
  /// Line (from 0) of the present text that the controller is executing; -1: none, or not known: the text may
  /// then be of another program.
  int live_line(int slot, int command);

 private:
  struct Slot {
    std::string text;
    std::uint64_t version = 1, analysed = 0, diffed = 0;
    ProgramReport report;
    std::filesystem::path path;
    std::string in_file;  ///< the contents of the file
    bool dos_lines = false, has_file = false;
    HeldProgram held;
    TextDiff held_to_now{"", ""};
  };
  [[nodiscard]] const Slot& at(int slot) const { return slots_[static_cast<std::size_t>(slot)]; }
  Slot& at(int slot) { return slots_[static_cast<std::size_t>(slot)]; }
  void hold(int slot, const std::string& text, bool from_here, Instant when);

  const Language* language_;
  const bool one_text_;  ///< holds all programs: ProgramFacts::threads
  std::vector<Slot> slots_;
  int chosen_ = 0, start_ = 0;
  std::uint64_t changes_ = 0;
};

/// The known state of the controller, including its programs as far as known.
[[nodiscard]] ControllerState known_state(const ProgramTexts& texts, const Snapshot& now);

/// The line between editor and terminal: the program that the controller runs or holds, compared with the
/// text.
struct ProgramNote {
  Severity severity = Severity::plain;
  std::string sentence;  ///< empty: nothing to say
  bool operator==(const ProgramNote&) const = default;
};
ProgramNote program_note(ProgramTexts& texts, int slot, const Snapshot& now, const ProgramFacts& facts,
                         std::string_view loaded_at);

/// Line `line` (from 0) of the text, without leading spaces.
std::string_view line_of(std::string_view text, int line);

/// First error of a report as "line 8", for sentences; empty: none.
std::string first_error_line(const ProgramReport& report);

}  // namespace hw::gui
