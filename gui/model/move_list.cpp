#include "gui/model/move_list.h"

#include <cmath>

#include <fmt/format.h>

#include "gui/model/typed_number.h"

namespace hw::gui {
namespace {

std::string_view next_part(std::string_view& rest, char end) {
  const std::size_t at = std::min(rest.find(end), rest.size());
  const std::string_view part = rest.substr(0, at);
  rest.remove_prefix(std::min(at + 1, rest.size()));
  return part;
}

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && (s.front() == ' ' || s.front() == '\t')) s.remove_prefix(1);
  while (!s.empty() && (s.back() == ' ' || s.back() == '\t' || s.back() == '\r')) s.remove_suffix(1);
  return s;
}

}  // namespace

std::string write_moves(const std::vector<MoveRow>& rows, const MoveListFacts& facts) {
  std::string text = "; ";
  for (const ActionField& c : facts.columns) text += (&c == facts.columns.data() ? "" : ", ") + c.label;
  text += "\n";
  for (const MoveRow& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int decimals = facts.columns[i].decimals;
      text += fmt::format("{:.{}f}{}", static_cast<double>(row[i]) / std::pow(10.0, decimals), decimals,
                          i + 1 < row.size() ? ", " : "\n");
    }
  return text;
}

Result<std::vector<MoveRow>> read_moves(std::string_view text, const MoveListFacts& facts) {
  std::vector<MoveRow> rows;
  for (int line = 1; !text.empty(); ++line) {
    std::string_view rest = trimmed(next_part(text, '\n'));
    if (rest.empty() || rest.front() == ';' || rest.front() == '#') continue;
    const auto wrong = [&](std::string why) {
      return fail(FaultKind::text, fmt::format("Line {}: {}", line, why), "The list is unchanged.",
                  fmt::format("Write {} numbers with commas between them.", facts.columns.size()));
    };
    MoveRow row;
    for (const ActionField& column : facts.columns) {
      const std::string_view part = trimmed(next_part(rest, ','));
      const double scale = std::pow(10.0, column.decimals);
      const NumberRange range{static_cast<double>(column.minimum) / scale,
                              static_cast<double>(column.maximum) / scale, column.decimals, column.unit};
      if (const std::string why = range_sentence(part, range); !why.empty())
        return wrong(fmt::format("{} \"{}\": {}", column.label, part, why));
      row.push_back(std::llround(*read_number(part) * scale));
    }
    if (!trimmed(rest).empty()) return wrong("more numbers than columns.");
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace hw::gui
