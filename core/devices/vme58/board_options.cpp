#include "core/devices/vme58/board_options.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "core/base/number_text.h"

namespace hw::vme58 {
namespace {

tl::unexpected<Fault> wrong_option(std::string what, std::string advice) {
  return fail(FaultKind::text, std::move(what), "Nothing was opened.", std::move(advice));
}

Result<> read_variant(const std::string& value, BoardOptions& board) {
  board.variant = find_variant(value);
  if (board.variant) return {};
  std::string known;
  for (const Variant& v : variants) known += fmt::format("{}{}", known.empty() ? "" : ", ", v.name);
  return wrong_option(fmt::format("variant={} is not a model of the VME58.", value),
                      fmt::format("Give one of these models, in capital or small letters: {}.", known));
}

/// IIO: one letter for each group of four lines; the last two lines are always outputs.
Result<> read_jumpers(const std::string& value, BoardOptions& board) {
  constexpr std::size_t groups = first_fixed_output / lines_of_a_group;
  unsigned outputs = ((1u << io_lines) - 1) & ~((1u << first_fixed_output) - 1);
  bool sense = value.size() == groups;
  for (std::size_t g = 0; sense && g < groups; ++g) {
    const char c = value[g];
    if (c == 'O' || c == 'o') outputs |= ((1u << lines_of_a_group) - 1) << (g * lines_of_a_group);
    sense = c == 'O' || c == 'o' || c == 'I' || c == 'i';
  }
  board.outputs = static_cast<std::uint16_t>(outputs);
  if (sense) return {};
  return wrong_option(fmt::format("jumpers={} is not possible.", value),
                      "Give three letters for the lines 0-3, 4-7 and 8-11: I for input, O for output, for "
                      "example jumpers=IIO.");
}

Result<> read_firmware(const std::string& value, BoardOptions& board) {
  constexpr std::size_t longest = 8;
  board.firmware = value;
  if (!value.empty() && value.size() <= longest &&
      value.find_first_not_of("0123456789.") == std::string::npos)
    return {};
  return wrong_option(fmt::format("firmware={} is not a revision.", value), "Give a number like 2.24.");
}

constexpr struct {
  std::string_view name;
  bool BoardOptions::*set;
} quirks[] = {{"padded", &BoardOptions::padded},
              {"oms-kk", &BoardOptions::oms_kk},
              {"deaf-mailbox", &BoardOptions::ignores_mail}};

/// Reads quirks, joined by +.
Result<> read_quirks(const std::string& value, BoardOptions& board) {
  for (std::string_view rest = value; !rest.empty();) {
    const auto end = std::min(rest.find('+'), rest.size());
    const std::string_view name = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const auto found = std::find_if(std::begin(quirks), std::end(quirks),
                                    [name](const auto& quirk) { return quirk.name == name; });
    if (found == std::end(quirks))
      return wrong_option(fmt::format("A VME58 has no quirk \"{}\".", name),
                          "Give padded, oms-kk or deaf-mailbox.");
    board.*found->set = true;
  }
  return {};
}

struct NumberOption {
  std::string_view key;
  std::int64_t least, most;
  void (*set)(BoardOptions&, std::int64_t);
};
constexpr NumberOption number_options[] = {
    {"velocity", 0, velocity_max, [](BoardOptions& b, std::int64_t n) { b.velocity = n; }},
    {"acceleration", 1, acceleration_max, [](BoardOptions& b, std::int64_t n) { b.acceleration = n; }},
    {"base_velocity", 0, velocity_max, [](BoardOptions& b, std::int64_t n) { b.base_velocity = n; }},
    {"contour_size", 1, 65'535,
     [](BoardOptions& b, std::int64_t n) { b.contour_size = static_cast<int>(n); }},
    {"servo_update_us", 50, 100'000,
     [](BoardOptions& b, std::int64_t n) { b.servo_update = std::chrono::microseconds(n); }},
};

struct WordOption {
  std::string_view key;
  Result<> (*read)(const std::string&, BoardOptions&);
};
constexpr WordOption word_options[] = {{"variant", read_variant},
                                       {"jumpers", read_jumpers},
                                       {"firmware", read_firmware},
                                       {"quirk", read_quirks}};

}  // namespace

bool is_board_option(std::string_view key) {
  const auto same = [key](const auto& o) { return o.key == key; };
  return std::any_of(std::begin(word_options), std::end(word_options), same) ||
         std::any_of(std::begin(number_options), std::end(number_options), same);
}

std::string board_option_names() {
  std::string all;
  for (const WordOption& w : word_options) all += fmt::format("{}{}", all.empty() ? "" : ", ", w.key);
  for (const NumberOption& n : number_options) all += fmt::format(", {}", n.key);
  return all;
}

Result<BoardOptions> read_board_options(const std::map<std::string, std::string>& given) {
  BoardOptions board;
  for (const auto& [key, value] : given) {
    for (const WordOption& word : word_options)
      if (word.key == key)
        if (auto read = word.read(value, board); !read) return fail(read.error());
    for (const NumberOption& number : number_options) {
      if (number.key != key) continue;
      const auto n = whole_number<std::int64_t>(value);
      if (!n || *n < number.least || *n > number.most)
        return wrong_option(fmt::format("{}={} is not possible.", key, value),
                            fmt::format("Give a whole number from {} to {}.", number.least, number.most));
      number.set(board, *n);
    }
  }
  return board;
}

}  // namespace hw::vme58
