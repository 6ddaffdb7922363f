#include "core/drawing/dxf_scan.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/core.h>

#include "core/base/number_text.h"

namespace hw::drawing {
namespace {

constexpr std::string_view nothing_taken = "Nothing was loaded from it.";

/// Pairs of lines: a group code, and its value.
class Pairs {
 public:
  explicit Pairs(std::string_view text) : rest_(text) {}
  struct Pair {
    int code = -1;  ///< -1: no number
    std::string_view value;
    int line = 0;         ///< of the value
    bool padded = false;  ///< the value had blanks around it
  };
  bool next(Pair& pair) {
    if (rest_.empty()) return false;
    pair.code = whole_number<int>(take_line()).value_or(-1);
    if (rest_.empty() && pair.code < 0) return false;
    pair.value = take_line();
    pair.line = line_;
    pair.padded = padded_;
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
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::size_t size = line.size();
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!line.empty() && blank(line.back())) line.remove_suffix(1);
    while (!line.empty() && blank(line.front())) line.remove_prefix(1);
    padded_ = line.size() != size;
    return line;
  }
  std::string_view rest_;
  std::size_t longest_line_ = 0;
  int line_ = 0;
  bool padded_ = false;  ///< the last line
};

/// The parser trusts an entity's count of its parts: it allocates and reads as many.
struct Count {
  std::string_view entity;
  int code;
  int part;  ///< group code that begins each part; -1: parts are not counted
};
constexpr std::array counts{Count{"LWPOLYLINE", 90, 10}, Count{"SPLINE", 72, 40}, Count{"SPLINE", 73, 10},
                            Count{"SPLINE", 74, 11},     Count{"LEADER", 76, -1}, Count{"HATCH", 91, -1},
                            Count{"HATCH", 93, -1},      Count{"LTYPE", 73, -1}};

/// Whether the group is a length, coordinate, angle or scale.
bool is_measure(int code) {
  return (code >= 10 && code < 60) || (code >= 140 && code < 150) || (code >= 210 && code < 240);
}

/// Whether the group names an entity, block, layer or variable.
bool is_name(int code) { return code == 0 || code == 2 || code == 8 || code == 9; }

/// Whether the parser reads the text as a number: a decimal comma is allowed, and underflow is 0.
bool is_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end == text.data() + text.size() && error == std::errc()) return std::isfinite(value);
  if (error == std::errc::result_out_of_range)
    return text.find("e-") != text.npos || text.find("E-") != text.npos;
  const std::size_t comma = text.find(',');
  if (comma == text.npos) return false;
  std::string with_point(text);
  with_point[comma] = '.';
  return is_number(with_point);
}

class Scan {
 public:
  explicit Scan(const std::string& name) : name_(name) {}

  Result<ScannedDxf> run(std::string_view text) {
    Pairs pairs(text);
    Pairs::Pair pair;
    bool ends = false;
    for (; !ends && pairs.next(pair); ++pairs_) {
      padded_names_ = padded_names_ || (pair.padded && is_name(pair.code));
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
    if (!ends && !has_sections_)
      return fail(FaultKind::text, fmt::format("{} is not a DXF file: no section begins in it.", name_),
                  std::string(nothing_taken), "Save the drawing as DXF.");
    if (!ends)
      return fail(FaultKind::text, fmt::format("{} is cut off: it does not end with EOF.", name_),
                  std::string(nothing_taken), "Save or copy it again.");
    return ScannedDxf{std::move(found_), pairs.longest_line(), padded_names_,
                      text.substr(0, text.size() - pairs.rest().size())};
  }

 private:
  void begin(const Pairs::Pair& pair) {
    name_of_entity_ = pair.value;
    began_at_line_ = pair.line;
    began_at_pair_ = pairs_;
    counted_ = std::any_of(counts.begin(), counts.end(),
                           [&](const Count& count) { return count.entity == pair.value; });
    declared_.fill(0), parts_.fill(0);
    awaits_section_name_ = pair.value == "SECTION";
    has_sections_ = has_sections_ || awaits_section_name_;
    const bool draws = section_ == "ENTITIES" || section_ == "BLOCKS";
    in_entity_ = draws && !awaits_section_name_ && pair.value != "ENDSEC";
    if (in_entity_) {
      if (pair.value != "VERTEX") owner_ = found_.size();
      found_.push_back({pair.value, pair.line});
    }
    if (pair.value == "ENDSEC") section_ = {};
  }
  void take(const Pairs::Pair& pair) {
    if (counted_) count(pair);
    if (!in_entity_) return;
    ScannedEntity& owner = found_[std::min(owner_, found_.size() - 1)];
    if (is_measure(pair.code)) {
      if (owner.no_number == 0 && !is_number(pair.value)) owner.no_number = pair.line;
    } else if (pair.code == 67) {
      found_.back().on_sheet = pair.value == "1";
    } else if (pair.code == 60) {
      found_.back().hidden = pair.value == "1";
    }
  }
  void count(const Pairs::Pair& pair) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i].entity != name_of_entity_) continue;
      if (counts[i].part == pair.code) ++parts_[i];
      if (counts[i].code != pair.code) continue;
      const auto declared = whole_number<std::int64_t>(pair.value);
      declared_[i] = std::max(declared_[i], declared ? (*declared < 0 ? most : *declared) : most);
    }
  }
  Result<> entity_ends() {
    if (!counted_) return {};
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i].entity != name_of_entity_) continue;
      if (declared_[i] > pairs_ - began_at_pair_)
        return wrong(began_at_line_, fmt::format("{} declares more parts than it has", name_of_entity_),
                     "The file is damaged.");
      if (in_entity_ && counts[i].part >= 0 && declared_[i] != parts_[i]) found_.back().miscounted = true;
    }
    return {};
  }
  [[nodiscard]] tl::unexpected<Fault> wrong(int line, std::string what, std::string advice) const {
    return fail(FaultKind::text, fmt::format("{}, line {}: {}.", name_, line, what),
                std::string(nothing_taken), std::move(advice));
  }

  static constexpr std::int64_t most = INT64_MAX;
  const std::string& name_;
  std::vector<ScannedEntity> found_;
  std::string_view section_, name_of_entity_;
  bool awaits_section_name_ = false, in_entity_ = false, counted_ = false, padded_names_ = false;
  bool has_sections_ = false;
  std::size_t owner_ = 0;  ///< index in found_ of the owner of the values; for a point its polyline
  std::int64_t pairs_ = 0, began_at_pair_ = 0;
  std::array<std::int64_t, counts.size()> declared_{}, parts_{};
  int began_at_line_ = 0;
};

}  // namespace

Result<> may_be_read(std::uintmax_t bytes, const std::string& name) {
  if (bytes <= largest_dxf) return {};
  return fail(FaultKind::text,
              fmt::format("{} has {} MB: a file of more than {} MB is not read.", name, bytes / 1'000'000,
                          largest_dxf / 1'000'000),
              std::string(nothing_taken), "Save the part to be drawn as a separate file.");
}

Result<ScannedDxf> scan_dxf(std::string_view text, const std::string& name) {
  if (auto small = may_be_read(text.size(), name); !small) return fail(small.error());
  if (text.empty())
    return fail(FaultKind::text, fmt::format("{} is empty.", name), {}, "Save or copy it again.");
  if (text.starts_with("AutoCAD Binary DXF"))
    return fail(FaultKind::text, fmt::format("{} is a binary DXF file.", name), std::string(nothing_taken),
                "Save it as a DXF file in text form (ASCII), R12 for instance.");
  if (text.starts_with("AC10"))
    return fail(FaultKind::text, fmt::format("{} is a DWG file.", name), std::string(nothing_taken),
                "Save it as DXF.");
  // The parser ends a line at a zero byte, so it would see other names than this scan.
  if (const std::size_t zero = text.find('\0'); zero != text.npos)
    return fail(
        FaultKind::text,
        fmt::format("{}, line {}: it contains a zero byte, which no text file has.", name,
                    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(zero), '\n') + 1),
        std::string(nothing_taken), "Is it a DXF file? Save or copy it again.");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return Scan(name).run(text);
}

}  // namespace hw::drawing
