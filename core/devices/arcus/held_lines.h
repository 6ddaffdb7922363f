#pragma once
// The known lines of the stored code: as last read, with nothing sent since that may have changed them. The
// controller writes each line to its flash at once (PMX ch. 6, DMX ch. 7), which wears; a line known to be
// there is not written again.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hw::arcus {

class HeldLines {
 public:
  HeldLines();
  /// Null: not known.
  [[nodiscard]] const std::string* known(int line) const;
  void was_read(int line, std::string text);
  /// Call before the command is sent: it may take effect even if it is not confirmed.
  void goes_out(std::string_view command);
  /// Another host may have written.
  void forget();

 private:
  std::vector<std::optional<std::string>> lines_;
};

}  // namespace hw::arcus
