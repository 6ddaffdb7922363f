#pragma once
// What each line of the stored code is known to be: as it was read last, and nothing has gone out since that
// may have changed it. The controller writes each line to its flash at once (PMX ch. 6, DMX ch. 7), which
// wears; what is known to be there is not written again.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hw::arcus {

class HeldLines {
 public:
  HeldLines();
  /// Null: it is not known.
  [[nodiscard]] const std::string* known(int line) const;
  void was_read(int line, std::string text);
  /// Before it does, and whether or not it is confirmed.
  void goes_out(std::string_view command);
  /// Somebody else may have written.
  void forget();

 private:
  std::vector<std::optional<std::string>> lines_;
};

}  // namespace hw::arcus
