#include "core/base/near_name.h"

#include <algorithm>
#include <numeric>

namespace hw {
namespace {

char plain(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// The number of letters to change, add, drop or swap to turn one name into the other, ignoring case.
std::size_t changes_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const bool same = plain(a[i - 1]) == plain(b[k - 1]);
      row[k] = std::min({last[k] + 1, row[k - 1] + 1, last[k - 1] + (same ? 0 : 1)});
      const bool swapped =
          i > 1 && k > 1 && plain(a[i - 1]) == plain(b[k - 2]) && plain(a[i - 2]) == plain(b[k - 1]);
      if (swapped) row[k] = std::min(row[k], before[k - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

}  // namespace

std::string_view near_name(std::string_view wanted, const std::vector<std::string>& names) {
  constexpr std::size_t longest = 64;  // longer names are not typing errors
  if (wanted.empty() || wanted.size() > longest) return {};
  std::string_view best;
  std::size_t closer_than = wanted.size() < 4 ? 2 : 3;
  for (const std::string& name : names) {
    if (name.size() > longest) continue;
    const std::size_t changes = changes_between(wanted, name);
    if (changes >= closer_than || changes >= wanted.size()) continue;  // nothing of the name would be left
    closer_than = changes;
    best = name;
  }
  return best;
}

std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names) {
  const std::string_view name = near_name(wanted, names);
  return name.empty() ? std::string() : " Did you mean \"" + std::string(name) + "\"?";
}

}  // namespace hw
