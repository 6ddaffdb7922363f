#pragma once
// The controller's five programs: selection and contents; writing, reading, emptying.
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/device/transfer_progress.h"
#include "core/devices/vxm/codec_text.h"
#include "core/devices/vxm/console.h"
#include "core/devices/vxm/conversation.h"
#include "core/devices/vxm/facts.h"
#include "core/devices/vxm/parameters.h"
#include "core/devices/vxm/text_goals.h"

namespace hw::vxm {

class Slots {
 public:
  using Lines = std::vector<std::string>;
  /// `may_touch`: the controller takes such commands now.
  Slots(const Console& console, Conversation& conversation, const Parameters& setup,
        std::function<Result<>()> may_touch)
      : console_(console),
        conversation_(conversation),
        parameters_(setup),
        may_touch_(std::move(may_touch)),
        progress_(console.snapshot.transfer, console.catalog) {}

  // ---- selection
  /// The user's choice; -1: not known.
  [[nodiscard]] int selected() const { return selected_; }
  /// The user has selected this program.
  void was_selected(int slot);
  /// Selects a program and has it confirmed. The user's selection is restored as soon as the wire is free for
  /// it: a stop, or a lost wire, may come in between.
  Task<Result<>> choose(int slot, Priority priority);
  Task<Result<>> give_back_selection();
  [[nodiscard]] bool selection_is_given_back() const { return chosen_ == selected_ && !may_have_grown_; }

  // ---- contents
  /// The program as read; none: not read.
  [[nodiscard]] const std::optional<Lines>& listing(int slot) const;
  [[nodiscard]] bool knows_sizes() const { return sizes_read_; }
  Task<Result<>> read_sizes();
  /// A program that M has shown empty, for a move of the console.
  Task<Result<int>> find_empty();
  /// The same, with the changes by texts since it was read.
  [[nodiscard]] ProgramContents contents(int slot) const;
  /// A command of the user's text has changed the selected program.
  void selected_was_changed(const TextCommand& by);
  /// Has all programs read again.
  void doubt_all();
  /// The controller has restarted: it holds the stored programs, and 0 is selected.
  void forget();

  // ---- requests
  Task<Result<>> load(const intent::LoadProgram& request);
  Task<Result<>> upload(int slot);
  Task<Result<>> clear(int slot);
  Task<Result<>> select(int slot);

 private:
  using Set = std::uint8_t;  ///< bit per slot
  static Set only(int slot) { return slot < 0 ? Set{0} : static_cast<Set>(1u << slot); }
  Task<Result<std::int64_t>> ask_selected();
  Task<Result<>> read_size();
  Task<Result<>> take_back_pauses(Priority priority);
  Task<Result<>> take_back_pauses_of(int slot, Priority priority);
  [[nodiscard]] bool may_be_scratch(int slot) const;
  void warn_of_pause_at_end(int slot, const TextCommand& pause) const;
  void ask_for_room(std::string sentence) const;
  Task<Result<>> load_slot(int slot, const Lines& lines, const Lines& expected);
  Task<Result<>> write_slot(int slot, const Lines& lines, const Lines& expected);
  Task<Result<>> send_lines(const Lines& lines);
  [[nodiscard]] std::string incomplete(int slot) const;
  Task<Result<>> verify_slot(int slot, const Lines& expected);
  void holds(int slot, const Listing& listing);
  void doubt(int slot);

  const Console& console_;
  Conversation& conversation_;
  const Parameters& parameters_;
  std::function<Result<>()> may_touch_;
  TransferProgress progress_;
  int selected_ = -1;
  int chosen_ = -1;  ///< selected in the controller, for a while not the user's choice; -1: not known
  Set may_be_selected_ = 0, may_have_grown_ = 0;
  int confirmed_empty_ = -1;  ///< as shown by M; -1: none
  std::array<std::optional<Lines>, program_count> listings_;
  std::array<ProgramContents, program_count> typed_;  ///< of those that texts have changed since
  bool sizes_read_ = false;
};

}  // namespace hw::vxm
