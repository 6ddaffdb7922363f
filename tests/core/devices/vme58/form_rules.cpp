// What several rows of the window and of the gains have in common, named in vme58.forms behind a "*". Each
// goes on with the board of the case, but for gain and axis-value, which make boards of their own.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>

#include "tests/core/devices/vme58/form_names.h"
#include "tests/core/devices/vme58/form_session.h"

namespace hw::vme58::proof {
namespace {

constexpr std::uint16_t test_pattern = 0xA5A5;

template <class Check>
void for_each_cell(const Form& form, Check check) {
  const RowPlace p = row_place(form);
  for (std::uint16_t at = p.first; at < p.last; at = static_cast<std::uint16_t>(at + 2)) check(at);
}

// example: the access that the row shows ("r32 1028") is that of its offset
void expect_example_access(Rig&, const Form& form, const Words&) {
  const auto space = form.example.find(' ');
  ASSERT_NE(space, std::string::npos);
  EXPECT_EQ(std::strtol(form.example.c_str() + space, nullptr, 0), row_place(form).first);
}

// bytes N: so many has the place
void expect_bytes(Rig&, const Form& form, const Words& w) {
  EXPECT_EQ(row_place(form).bytes, std::stoi(w.at(0)));
}

// same-in-all-widths: every width reads the same bytes
void expect_same_in_all_widths(Rig& rig, const Form& form, const Words&) {
  const RowPlace p = row_place(form);
  for (std::uint16_t at = p.first; at + 3 <= p.last; at = static_cast<std::uint16_t>(at + 4)) {
    const std::uint32_t word = rig.read32(at);
    const std::uint16_t next = static_cast<std::uint16_t>(at + 2);
    ASSERT_EQ(word, std::uint32_t{rig.read16(at)} << 16 | rig.read16(next)) << "at " << at;
    for (unsigned i = 0; i < 4; ++i)
      ASSERT_EQ(rig.read8(static_cast<std::uint16_t>(at + i)), word >> (24 - 8 * i) & 0xFF)
          << "byte " << at + i;
  }
}

// not-writable: whatever is written there, it stays as it was
void expect_not_writable(Rig& rig, const Form& form, const Words&) {
  for_each_cell(form, [&](std::uint16_t at) {
    const std::uint16_t before = rig.read16(at);
    rig.write16(at, static_cast<std::uint16_t>(~before));
    ASSERT_EQ(rig.read16(at), before) << "at " << at;
  });
}

// all-zero
void expect_all_zero(Rig& rig, const Form& form, const Words&) {
  for_each_cell(form, [&](std::uint16_t at) { ASSERT_EQ(rig.read16(at), 0) << "at " << at; });
}

// pattern-stays: what plain-memory has written there
void expect_pattern(Rig& rig, const Form& form, const Words&) {
  for_each_cell(form, [&](std::uint16_t at) { ASSERT_EQ(rig.read16(at), at ^ test_pattern) << "at " << at; });
}

// plain-memory: 0 at first; each cell keeps what is written there
void expect_plain_memory(Rig& rig, const Form& form, const Words& w) {
  expect_all_zero(rig, form, w);
  for_each_cell(form,
                [&](std::uint16_t at) { rig.write16(at, static_cast<std::uint16_t>(at ^ test_pattern)); });
  expect_pattern(rig, form, w);
}

// registers-only: nine registers at odd addresses; all else reads 0 and takes nothing
void expect_registers_only(Rig& rig, const Form& form, const Words&) {
  const RowPlace p = row_place(form);
  for (std::uint16_t at = p.first; at <= p.last; ++at) {
    if (at % 2 == 1 && at >= reg::control && at <= reg::vector) continue;
    rig.write8(at, 0xFF);
    EXPECT_EQ(rig.read8(at), 0) << at;
  }
}

// register NAME: the offset of the row is that of the register, and a byte
void expect_register(Rig&, const Form& form, const Words& w) {
  const std::string at = std::to_string(place_named(w.at(0), form));
  EXPECT_EQ(form.arg("offset"), at + ".." + at);
  EXPECT_EQ(form.arg("bytes"), "1");
  EXPECT_NE(form.example.find("0x0F"), std::string::npos);
}

// read-only NAME: of a register
void expect_read_only(Rig& rig, const Form& form, const Words& w) {
  const std::uint16_t at = place_named(w.at(0), form);
  const auto before = rig.read8(at);
  rig.write8(at, static_cast<std::uint8_t>(~before));
  EXPECT_EQ(rig.read8(at), before);
}

// axis-value NAME COMMAND VALUE: what a command gives this axis stands there, when a copy was asked for
void expect_axis_value(Rig&, const Form& form, const Words& w) {
  const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(form.id.at(12))));
  const AxisValue value = value_named(w.at(0));
  const std::string& command = w.at(1);
  const auto expected = static_cast<std::int32_t>(std::stol(w.at(2)));
  const std::uint16_t first = row_place(form).first;
  EXPECT_EQ(offset_of(static_cast<int>(axis_letters.find(letter)), value), first);
  Rig rig;
  // Another axis first: its value must not come here.
  rig.send((letter == 'X' ? "AY " : "AX ") + command + " ");
  rig.axis_value(letter, value);
  EXPECT_NE(static_cast<std::int32_t>(rig.read32(first)), expected);
  rig.send(std::string("A") + letter + " " + command + " ");
  EXPECT_FALSE(rig.command_error()) << command;
  rig.run_for(1s);
  EXPECT_NE(static_cast<std::int32_t>(rig.read32(first)), expected) << "copied without being asked";
  EXPECT_EQ(rig.axis_value(letter, value), expected);
  EXPECT_EQ(static_cast<std::int32_t>(rig.read32(first)), expected);
  expect_same_in_all_widths(rig, form, {});
  expect_not_writable(rig, form, {});
}

// gain LETTERS VALUE: the gain can be read in the window; negative ones are refused; an ideal axis does not
// care
void expect_gain(Rig&, const Form&, const Words& w) {
  const std::string& gain = w.at(0);
  const AxisValue value = value_named(w.at(1));
  Rig rig;
  rig.send("AX " + gain + "12.5 ");
  EXPECT_EQ(rig.axis_value('X', value), 12) << "the whole part (decision M27)";
  rig.send(gain + "-1 ");
  EXPECT_TRUE(rig.command_error());
  EXPECT_EQ(rig.axis_value('X', value), 12);
  rig.send("MR1000 GO ID ");
  rig.run_until_done("X");
  EXPECT_EQ(rig.value("AX RE"), "1000");
  Rig steps = Rig::model("8");
  steps.send("AX " + gain + "1 ");
  EXPECT_TRUE(steps.command_error()) << "servo axes only";
}

using BoardRule = void (*)(Rig&, const Form&, const Words&);
const std::map<std::string, BoardRule> board_rules = {
    {"all-zero", expect_all_zero},
    {"axis-value", expect_axis_value},
    {"bytes", expect_bytes},
    {"example", expect_example_access},
    {"gain", expect_gain},
    {"not-writable", expect_not_writable},
    {"pattern-stays", expect_pattern},
    {"plain-memory", expect_plain_memory},
    {"read-only", expect_read_only},
    {"register", expect_register},
    {"registers-only", expect_registers_only},
    {"same-in-all-widths", expect_same_in_all_widths},
};

}  // namespace

bool follow_rule(const std::string& text, Rig& rig, const Form& form) {
  const Words words = words_in(text);
  const auto rule = board_rules.find(words.at(0));
  if (rule == board_rules.end()) return false;
  rule->second(rig, form, {words.begin() + 1, words.end()});
  return true;
}

}  // namespace hw::vme58::proof
