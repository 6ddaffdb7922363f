#pragma once
// "Take here": the present place of the axes becomes what the chosen block says. Ids: `blocks/here`,
// `blocks/here_end` of an arc.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/sequence/editor.h"
#include "gui/shell/frame.h"

namespace hw::panels {

/// One way of teaching a block.
struct Lesson {
  const char *id = nullptr, *label = nullptr;
  enum class What : std::uint8_t { place, distance, centre, end } what = What::place;
};

class BlockTeach {
 public:
  /// Of this kind of block; null id: no such.
  [[nodiscard]] static std::array<Lesson, 2> lessons(const sequence::Step::Body& body);
  /// Empty: it can be done now.
  [[nodiscard]] std::string_view why_not(const gui::Frame& frame, const sequence::Editor& editor,
                                         const sequence::StepPath& path, Lesson::What what);
  /// What the block becomes; nothing: it stays.
  [[nodiscard]] std::optional<sequence::Step::Body> teach(const gui::Frame& frame,
                                                          const sequence::Editor& editor,
                                                          const sequence::StepPath& path, Lesson::What what);

 private:
  const sequence::Places& begins_at(const sequence::Editor& editor, const sequence::StepPath& path);

  sequence::Places begins_at_;  ///< of the block asked about last
  sequence::StepPath of_;
  std::uint64_t version_ = ~std::uint64_t{0};
};

}  // namespace hw::panels
