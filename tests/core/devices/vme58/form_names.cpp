#include "tests/core/devices/vme58/form_names.h"

#include <cctype>
#include <cstdlib>

namespace hw::vme58::proof {
namespace {

constexpr std::pair<std::string_view, std::uint16_t> window_places[] = {
    {"control", reg::control},
    {"status", reg::status},
    {"io_low", reg::io_low},
    {"io_high", reg::io_high},
    {"slip", reg::slip},
    {"done", reg::done},
    {"limit", reg::limit},
    {"home", reg::home},
    {"vector", reg::vector},
    {"input_put_index", at::input_put_index},
    {"output_get_index", at::output_get_index},
    {"input_buffer", at::input_buffer},
    {"output_put_index", at::output_put_index},
    {"input_get_index", at::input_get_index},
    {"output_buffer", at::output_buffer},
    {"reserved1", at::reserved1},
    {"mailbox", at::mailbox},
};
constexpr std::pair<std::string_view, std::uint8_t> status_names[] = {
    {"command_error", status::command_error},
    {"initialized", status::initialized},
    {"slip", status::slip},
    {"overtravel", status::overtravel},
    {"done", status::done},
    {"board_interrupted", status::board_interrupted},
    {"direct_interrupt", 1 << 6},  // unused (decision M30)
    {"interrupt", status::interrupt},
};
constexpr std::string_view value_names[] = {"encoder_position",      "command_position",
                                            "command_velocity",      "acceleration",
                                            "maximum_velocity",      "base_velocity",
                                            "proportional_gain",     "differential_gain",
                                            "integral_gain",         "acceleration_feed_forward",
                                            "velocity_feed_forward", "offset"};
static_assert(std::size(value_names) == axis_values);

template <class T, std::size_t N>
T named(const std::pair<std::string_view, T> (&names)[N], const std::string& name) {
  for (const auto& [known, value] : names)
    if (known == name) return value;
  ADD_FAILURE() << "there is no " << name;
  return {};
}

}  // namespace

RowPlace row_place(const Form& form) {
  RowPlace place;
  const std::string range = form.arg("offset");
  place.first = static_cast<std::uint16_t>(std::atoi(range.c_str()));
  place.last = static_cast<std::uint16_t>(std::atoi(range.substr(range.find("..") + 2).c_str()));
  place.bytes = std::atoi(form.arg("bytes").c_str());
  EXPECT_EQ(place.bytes, place.last - place.first + 1) << "the table contradicts itself";
  EXPECT_EQ(place.first, std::strtol(form.arg("hex").c_str(), nullptr, 16)) << "the table contradicts itself";
  return place;
}

std::uint16_t place_named(const std::string& name, const Form& form) {
  const auto sign = name.find_first_of("+-");
  const std::string base = name.substr(0, sign);
  const int offset = sign == name.npos ? 0 : std::stoi(name.substr(sign));
  const bool is_number = std::isdigit(static_cast<unsigned char>(base.at(0))) != 0;
  const int place = is_number         ? std::stoi(base, nullptr, 0)
                    : base == "first" ? row_place(form).first
                                      : named(window_places, base);
  return static_cast<std::uint16_t>(place + offset);
}

std::uint8_t status_bit_named(const std::string& name) { return named(status_names, name); }

AxisValue value_named(const std::string& name) {
  for (std::size_t i = 0; i < std::size(value_names); ++i)
    if (value_names[i] == name) return static_cast<AxisValue>(i);
  ADD_FAILURE() << "nobody can see " << name;
  return {};
}

std::string letters_of(unsigned bits) {
  std::string letters;
  for (const char letter : axis_letters)
    if ((bits & bit_of(letter)) != 0) letters += letter;
  return letters.empty() ? "none" : letters;
}

std::string characters_in(std::string text) {
  constexpr std::pair<std::string_view, char> marks[] = {{"<cr>", '\r'}, {"<lf>", '\n'}, {"<sp>", ' '}};
  for (const auto& [mark, character] : marks)
    for (auto at = text.find(mark); at != text.npos; at = text.find(mark, at + 1))
      text.replace(at, mark.size(), 1, character);
  return text;
}

}  // namespace hw::vme58::proof
