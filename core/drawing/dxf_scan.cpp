#include "core/drawing/dxf_scan.h"

#include <algorithm>

#include <fmt/core.h>

#include "core/base/number_text.h"

namespace hw::drawing {
namespace {

constexpr std::string_view nothing_taken = "Nothing was taken from it.";

/// Pairs of lines: a group code, and its value.
class Pairs {
 public:
  explicit Pairs(std::string_view text) : rest_(text) {}
  struct Pair {
    int code = -1;  ///< -1: no number
    std::string_view value;
    int line = 0;  ///< of the value
  };
  bool next(Pair& pair) {
    if (rest_.empty()) return false;
    pair.code = whole_number<int>(take_line()).value_or(-1);
    if (rest_.empty() && pair.code < 0) return false;
    pair.value = take_line();
    pair.line = line_;
    return true;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] std::size_t longest_line() const { return longest_line_; }

 private:
  std::string_view take_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    longest_line_ = std::max(longest_line_, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!line.empty() && blank(line.back())) line.remove_suffix(1);
    while (!line.empty() && blank(line.front())) line.remove_prefix(1);
    return line;
  }
  std::string_view rest_;
  std::size_t longest_line_ = 0;
  int line_ = 0;
};

/// The parser makes room for as many as an entity says that it has.
struct Count {
  std::string_view entity;
  int code;
};
constexpr Count counts[] = {{"LWPOLYLINE", 90}, {"SPLINE", 72}, {"SPLINE", 73}, {"SPLINE", 74},
                            {"LEADER", 76},     {"HATCH", 91},  {"HATCH", 93},  {"LTYPE", 73}};

class Scan {
 public:
  explicit Scan(const std::string& name) : name_(name) {}

  Result<ScannedDxf> run(std::string_view text) {
    Pairs pairs(text);
    Pairs::Pair pair;
    bool ends = false;
    for (; !ends && pairs.next(pair); ++pairs_) {
      if (pair.code < 0)
        return wrong(pair.line - 1, "a group code was expected here, a whole number", "Is it a DXF file?");
      if (pair.code == 0) {
        if (auto whole = entity_ends(); !whole) return fail(whole.error());
        ends = pair.value == "EOF";
        begin(pair);
      } else if (pair.code == 2 && awaits_section_name_) {
        section_ = pair.value;
        awaits_section_name_ = false;
      } else {
        take(pair);
      }
    }
    if (!ends)
      return fail(FaultKind::text, fmt::format("{} is cut off: it does not end with EOF.", name_),
                  std::string(nothing_taken), "Save or copy it again.");
    return ScannedDxf{std::move(found_), pairs.longest_line(),
                      text.substr(0, text.size() - pairs.rest().size())};
  }

 private:
  void begin(const Pairs::Pair& pair) {
    name_of_entity_ = pair.value;
    began_at_line_ = pair.line;
    began_at_pair_ = pairs_;
    declared_ = 0;
    awaits_section_name_ = pair.value == "SECTION";
    const bool draws = section_ == "ENTITIES" || section_ == "BLOCKS";
    in_entity_ = draws && !awaits_section_name_ && pair.value != "ENDSEC";
    if (in_entity_) found_.push_back({pair.value, pair.line, false});
    if (pair.value == "ENDSEC") section_ = {};
  }
  void take(const Pairs::Pair& pair) {
    if (pair.code == 67 && in_entity_) found_.back().on_sheet = pair.value == "1";
    for (const Count& count : counts)
      if (count.code == pair.code && count.entity == name_of_entity_) {
        const auto declared = whole_number<std::int64_t>(pair.value);
        declared_ = std::max(declared_, declared ? (*declared < 0 ? most : *declared) : most);
      }
  }
  Result<> entity_ends() const {
    if (declared_ <= pairs_ - began_at_pair_) return {};
    return wrong(began_at_line_,
                 fmt::format("{} says that it has more parts than there are", name_of_entity_),
                 "The file is damaged.");
  }
  [[nodiscard]] tl::unexpected<Fault> wrong(int line, std::string what, std::string advice) const {
    return fail(FaultKind::text, fmt::format("{}, line {}: {}.", name_, line, what),
                std::string(nothing_taken), std::move(advice));
  }

  static constexpr std::int64_t most = INT64_MAX;
  const std::string& name_;
  std::vector<ScannedEntity> found_;
  std::string_view section_, name_of_entity_;
  bool awaits_section_name_ = false, in_entity_ = false;
  std::int64_t pairs_ = 0, began_at_pair_ = 0, declared_ = 0;
  int began_at_line_ = 0;
};

}  // namespace

Result<ScannedDxf> scan_dxf(std::string_view text, const std::string& name) {
  if (text.size() > largest_dxf)
    return fail(FaultKind::text,
                fmt::format("{} has {} MB; more than {} are not read.", name, text.size() / 1'000'000,
                            largest_dxf / 1'000'000),
                std::string(nothing_taken), "Save the part that is to be drawn as a file of its own.");
  if (text.starts_with("AutoCAD Binary DXF"))
    return fail(FaultKind::text, fmt::format("{} is a binary DXF file.", name), std::string(nothing_taken),
                "Save it as a DXF file in text form (ASCII), R12 for instance.");
  if (text.starts_with("AC10") && text.find('\n') == text.npos)
    return fail(FaultKind::text, fmt::format("{} is a DWG file.", name), std::string(nothing_taken),
                "Save it as DXF.");
  // For the parser a line ends there: it would see other names than are seen here.
  if (const std::size_t zero = text.find('\0'); zero != text.npos)
    return fail(
        FaultKind::text,
        fmt::format("{}, line {}: there is a zero byte, which no text has.", name,
                    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n') + 1),
        std::string(nothing_taken), "Is it a DXF file? Save or copy it again.");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return Scan(name).run(text);
}

}  // namespace hw::drawing
