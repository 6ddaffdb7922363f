#pragma once
// The blocks of one controller: a sequence under the hand, and the file that it belongs to. GUI thread.
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/device/catalog.h"
#include "core/sequence/editor.h"
#include "core/session/autosave.h"
#include "gui/model/units_format.h"

namespace hw::gui {

class BlockList {
 public:
  /// Empty, with the axes of the controller.
  explicit BlockList(const Catalog& catalog);

  sequence::Editor editor;
  /// Once a frame: blocks that are begun now are kept in the unit that all axes are shown in, else in steps.
  void begin_in(const Catalog& catalog, std::span<const DisplayUnit> units);
  // As SequenceText counts the steps; -1: none.
  int wanted_step = -1;  ///< to be chosen where the blocks are drawn
  int chosen_step = -1;  ///< there

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Differs from its file, or is in none.
  [[nodiscard]] bool edited() const;
  void opened(std::filesystem::path path, sequence::Sequence sequence);
  /// Made of something else, in no file; undo brings back those before.
  void became(sequence::Sequence sequence);
  /// `version`: of the editor, when what was written was taken. It may have been edited meanwhile.
  void saved(std::filesystem::path path, std::uint64_t version);

  // ---- for the autosave
  [[nodiscard]] std::uint64_t changes() const { return editor.version() + files_; }
  struct Unsaved {
    std::shared_ptr<const sequence::Sequence> sequence;
    std::string path;
    [[nodiscard]] UnsavedText text() const;  ///< long, for the worker
  };
  /// None: all of it is in a file.
  [[nodiscard]] std::optional<Unsaved> unsaved() const;
  /// Takes its own out of what was kept. A fault: it could not be read, the list is as before.
  Result<> restore(const std::vector<UnsavedText>& texts);

 private:
  std::filesystem::path file_;
  std::array<DisplayUnit, max_axes> begun_in_;
  std::uint64_t in_file_ = 0;  ///< Editor::version() that the file holds
  std::uint64_t files_ = 0;    ///< how often it was opened or saved
};

}  // namespace hw::gui
