#pragma once
// "Take here": puts the present position of the axes into the chosen block. Ids: `blocks/here`,
// `blocks/here_end` of an arc.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/sequence/editor.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// A way to teach a block.
struct Lesson {
  const char *id = nullptr, *label = nullptr;
  enum class What : std::uint8_t { place, distance, centre, end } what = What::place;
};

class BlockTeach {
 public:
  /// The lessons for this kind of block; null id: no lesson.
  [[nodiscard]] static std::array<Lesson, 2> lessons(const sequence::Step::Body& body);
  /// Why the block cannot be taught now; empty: it can.
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame, const sequence::Editor& editor,
                                         const sequence::StepPath& path, Lesson::What what);
  /// Returns the taught block; nullopt: the block is unchanged.
  [[nodiscard]] std::optional<sequence::Step::Body> teach(const gui::Frame& frame,
                                                          const sequence::Editor& editor,
                                                          const sequence::StepPath& path, Lesson::What what);

 private:
  const sequence::Places& begins_at(const sequence::Editor& editor, const sequence::StepPath& path);

  sequence::Places begins_at_;  ///< start positions of the last block queried
  sequence::StepPath of_;
  std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace hw::panels
