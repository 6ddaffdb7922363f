#pragma once
// The blocks of one controller: the sequence being edited and its file. GUI thread.
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
  /// Once a frame: sets the unit of new blocks to the one in which all axes are shown, else to steps.
  void begin_in(const Catalog& catalog, std::span<const DisplayUnit> units);
  // Steps as SequenceText counts them; -1: none.
  int wanted_step = -1;  ///< to be selected in the drawing of the blocks
  int chosen_step = -1;  ///< selected there

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  /// Returns whether the blocks differ from their file, or have none.
  [[nodiscard]] bool edited() const;
  void opened(std::filesystem::path path, sequence::Sequence sequence);
  /// Replaces the blocks by ones made from something else, with no file; undo restores the former ones.
  void became(sequence::Sequence sequence);
  /// `version`: of the editor when the written data was taken. The blocks may have been edited since.
  void saved(std::filesystem::path path, std::uint64_t version);

  // ---- for the autosave
  [[nodiscard]] std::uint64_t changes() const { return editor.version() + files_; }
  struct Unsaved {
    std::shared_ptr<const sequence::Sequence> sequence;
    std::string path;
    [[nodiscard]] UnsavedText text() const;  ///< slow: for the worker
  };
  /// None: everything is in a file.
  [[nodiscard]] std::optional<Unsaved> unsaved() const;
  /// Restores this list from the kept texts. A fault: they could not be read, and the list is unchanged.
  Result<> restore(const std::vector<UnsavedText>& texts);

 private:
  std::filesystem::path file_;
  std::array<DisplayUnit, max_axes> begun_in_;
  std::uint64_t in_file_ = 0;  ///< Editor::version() that the file holds
  std::uint64_t files_ = 0;    ///< how often a file was opened or saved
};

}  // namespace hw::gui
