#pragma once
// The texts of one controller's program slots: what is typed, the file it belongs to, what the language says
// of it, and what the controller is known to hold. GUI thread.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/device/catalog.h"
#include "core/device/language.h"
#include "core/device/snapshot.h"
#include "core/session/autosave.h"
#include "core/session/text_file.h"
#include "gui/model/mood.h"
#include "gui/model/text_diff.h"

namespace hw::gui {

/// What the controller's slot is known to hold.
struct HeldProgram {
  bool known = false;      ///< false: never read, or something may have changed it since
  bool from_here = false;  ///< it was loaded from the text of this console
  bool runs_on = false;  ///< not known any more, but the run that was under way then still is: it is of this
  bool whole = true;     ///< false: it has code that means nothing here, which `text` leaves out
  std::vector<std::string> listing;  ///< canonical commands
  std::string text;                  ///< as it was loaded or listed
  ProgramReport report;              ///< of `text`
  Instant at{};                      ///< when it was loaded or read
};

class ProgramTexts {
 public:
  /// `language` null: texts are kept, not understood.
  ProgramTexts(const ProgramFacts& facts, const Language* language);

  [[nodiscard]] int count() const { return static_cast<int>(slots_.size()); }
  [[nodiscard]] int chosen() const { return chosen_; }
  void choose(int slot);

  // ---- text
  [[nodiscard]] const std::string& text(int slot) const { return at(slot).text; }
  /// Grows with each change, whoever made it. A view that has an older one takes the text again.
  [[nodiscard]] std::uint64_t version(int slot) const { return at(slot).version; }
  void set_text(int slot, std::string text);
  /// Analysed when the text has changed, not before.
  const ProgramReport& report(int slot);
  /// The text has program headings of its own, so that it belongs to more slots than this one.
  bool has_headings(int slot);
  /// Sum over the slot, in the catalog's unit.
  int cost(int slot);

  // ---- files
  [[nodiscard]] const std::filesystem::path& file(int slot) const { return at(slot).path; }
  [[nodiscard]] std::string file_name(int slot) const { return at(slot).path.filename().string(); }
  /// Differs from its file, or is in no file at all.
  [[nodiscard]] bool edited(int slot) const;
  void opened(int slot, std::filesystem::path path, TextFile file);
  [[nodiscard]] TextFile to_save(int slot) const;
  /// What its file is known to hold; none: it was not read since the text was recovered.
  [[nodiscard]] std::optional<std::string> known_in_file(int slot) const;
  /// `text` is what was written: it may have been edited meanwhile.
  void saved(int slot, std::filesystem::path path, std::string_view text);
  [[nodiscard]] std::vector<UnsavedText> unsaved() const;
  void restore(const std::vector<UnsavedText>& texts);
  /// Changes with each change of a text or file: for the autosave.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }

  // ---- what the controller holds
  [[nodiscard]] const HeldProgram& held(int slot) const { return at(slot).held; }
  /// LoadProgram has ended well.
  void loaded(int slot, const std::string& text, Instant when);
  /// UploadProgram brought this listing; not `whole`: of what it understood.
  void listed(int slot, const std::string& listing, Instant when, bool whole = true);
  void cleared(int slot, Instant when);
  /// Somebody else may have changed it: the wire was lost, a reset. What runs meanwhile runs on.
  void doubt();
  /// Somebody else has changed it.
  void forget();
  /// What ran when it became doubtful has ended.
  void nothing_runs();
  /// The lines that the controller tells can be found in the text that was loaded or listed.
  [[nodiscard]] bool lines_known(int slot) const {
    return held(slot).whole && (held(slot).known || held(slot).runs_on);
  }
  /// The controller is known to hold what is typed here now.
  bool controller_has(int slot);
  /// Line (from 0) of the present text that the controller works on; -1: none, or not known: then the text
  /// may be of another program.
  int live_line(int slot, int command);

 private:
  struct Slot {
    std::string text;
    std::uint64_t version = 1, analysed = 0, diffed = 0;
    ProgramReport report;
    std::filesystem::path path;
    std::string in_file;  ///< what the file holds
    bool dos_lines = false, has_file = false;
    HeldProgram held;
    TextDiff held_to_now{"", ""};
  };
  [[nodiscard]] const Slot& at(int slot) const { return slots_[static_cast<std::size_t>(slot)]; }
  Slot& at(int slot) { return slots_[static_cast<std::size_t>(slot)]; }
  void hold(int slot, const std::string& text, bool from_here, Instant when);

  const Language* language_;
  std::vector<Slot> slots_;
  int chosen_ = 0;
  std::uint64_t changes_ = 0;
};

/// The line between editor and terminal: what the controller runs or holds, against what is typed.
struct ProgramNote {
  Mood mood = Mood::plain;
  std::string sentence;  ///< empty: nothing to say
  bool operator==(const ProgramNote&) const = default;
};
ProgramNote program_note(ProgramTexts& texts, int slot, const Snapshot& now, const ProgramFacts& facts,
                         std::string_view loaded_at);

/// Line `line` (from 0) of the text, without the spaces before it.
std::string_view line_of(std::string_view text, int line);

/// First error of a report as "line 8", for sentences; empty: none.
std::string first_error_line(const ProgramReport& report);

}  // namespace hw::gui
