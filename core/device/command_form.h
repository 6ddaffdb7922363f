#pragma once
// One form of a command, as the catalog prints it, compared with a typed or sent text. Two notations:
//   SmMx               a letter is a place for a number where the example has digits instead of it
//   HS[axis]=[value]   a bracket is a place: [axis] the name of an axis, [+/-] a sign, [1-8] a number, any
//                      other a value (behind an equals sign any text); "..." at the end: and so on, and what
//                      stands between commas may then be left out
#include <string>
#include <string_view>
#include <vector>

#include "core/device/catalog.h"

namespace hw {

class CommandForm {
 public:
  CommandForm(const CommandInfo& command, const std::vector<AxisInfo>& axes);

  enum class Match { none, begins, whole };
  /// `text` is one command without address and terminator.
  [[nodiscard]] Match match(std::string_view text) const;
  /// The text before the first place: every text of this form begins with it.
  [[nodiscard]] const std::string& head() const { return head_; }

 private:
  enum class Place : std::uint8_t { literal, digit, digits, axis, sign, number, list, text };
  struct Part {
    Place place;
    char literal = 0;
  };
  void read_letters(const std::string& form, const std::string& example);
  void read_brackets(std::string_view form);
  /// Number of bytes of `text` that this part matches; npos: no match.
  [[nodiscard]] std::size_t taken(const Part& part, std::string_view text) const;

  std::vector<Part> parts_;
  std::string head_, axis_names_;
};

}  // namespace hw
