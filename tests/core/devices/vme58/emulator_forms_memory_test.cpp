// Rows of the memory of the window: each place by its own offset, width and access, with what it has to hold.
#include <cctype>
#include <cstdlib>

#include "tests/core/devices/vme58/form_case.h"

namespace hw::vme58::proof {
namespace {

struct Place {
  std::uint16_t first = 0, last = 0;
  int bytes = 0;
  bool writable = false;
};

Place place_of(const Form& f) {
  Place p;
  const std::string range = f.arg("offset");
  p.first = static_cast<std::uint16_t>(std::atoi(range.c_str()));
  p.last = static_cast<std::uint16_t>(std::atoi(range.substr(range.find("..") + 2).c_str()));
  p.bytes = std::atoi(f.arg("bytes").c_str());
  p.writable = f.arg("access") == "Read/Write";
  EXPECT_EQ(p.first, std::strtol(f.arg("hex").c_str(), nullptr, 16)) << "the table contradicts itself";
  EXPECT_EQ(p.bytes, p.last - p.first + 1) << "the table contradicts itself";
  return p;
}

/// "r32 1028": the access that the row shows, at the offset of the row.
void expect_example_access(const Form& f, const Place& p) {
  const auto space = f.example.find(' ');
  ASSERT_NE(space, std::string::npos);
  EXPECT_EQ(std::strtol(f.example.c_str() + space, nullptr, 0), p.first);
}

/// Every width reads the same bytes.
void expect_same_in_all_widths(Rig& rig, const Place& p) {
  for (std::uint16_t at = p.first; at + 3 <= p.last; at = static_cast<std::uint16_t>(at + 4)) {
    const std::uint32_t word = rig.read32(at);
    const std::uint16_t next = static_cast<std::uint16_t>(at + 2);
    ASSERT_EQ(word, std::uint32_t{rig.read16(at)} << 16 | rig.read16(next)) << "at " << at;
    for (unsigned i = 0; i < 4; ++i)
      ASSERT_EQ(rig.read8(static_cast<std::uint16_t>(at + i)), word >> (24 - 8 * i) & 0xFF)
          << "byte " << at + i;
  }
}

void expect_not_writable(Rig& rig, const Place& p) {
  for (std::uint16_t at = p.first; at < p.last; at = static_cast<std::uint16_t>(at + 2)) {
    const std::uint16_t before = rig.read16(at);
    rig.write16(at, static_cast<std::uint16_t>(~before));
    ASSERT_EQ(rig.read16(at), before) << "at " << at;
  }
}

void expect_plain_memory(Rig& rig, const Place& p) {
  for (std::uint16_t at = p.first; at < p.last; at = static_cast<std::uint16_t>(at + 2)) {
    ASSERT_EQ(rig.read16(at), 0) << "at " << at;
    rig.write16(at, static_cast<std::uint16_t>(at ^ 0xA5A5));
  }
  for (std::uint16_t at = p.first; at < p.last; at = static_cast<std::uint16_t>(at + 2))
    ASSERT_EQ(rig.read16(at), at ^ 0xA5A5) << "at " << at;
}

// --- axis data ---------------------------------------------------------------------------------------------

struct Field {
  std::string_view name;
  AxisValue value;
  std::string_view command;  ///< that gives it `expected`
  std::int32_t expected;
};

constexpr Field fields[] = {
    {"encoder_position", AxisValue::encoder_position, "LP-123456", -123456},
    {"command_position", AxisValue::command_position, "LP33500000", 33'500'000},
    {"command_velocity", AxisValue::command_velocity, "JG-4321", 4321},  // magnitude (decision M10)
    {"acceleration", AxisValue::acceleration, "AC7000001", 7'000'001},
    {"maximum_velocity", AxisValue::maximum_velocity, "VL1044000", 1'044'000},
    {"base_velocity", AxisValue::base_velocity, "VB515", 515},
    {"proportional_gain", AxisValue::proportional_gain, "KP12.9", 12},  // integer part (decision M27)
    {"differential_gain", AxisValue::differential_gain, "KD70000", 70'000},
    {"integral_gain", AxisValue::integral_gain, "KI3", 3},
    {"acceleration_feed_forward", AxisValue::acceleration_feed_forward, "KA41.5", 41},
    {"velocity_feed_forward", AxisValue::velocity_feed_forward, "KV6", 6},
    {"offset", AxisValue::offset, "KO-17.9", -17},
};

void check_axis_value(const Form& f) {
  const Place p = place_of(f);
  expect_example_access(f, p);
  const std::string rest = f.id.substr(std::string("vme58.dpram.").size());
  const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(rest[0])));
  const int axis = static_cast<int>(axis_letters.find(letter));
  for (const Field& field : fields) {
    if (rest.substr(2) != field.name) continue;
    EXPECT_EQ(offset_of(axis, field.value), p.first);
    Rig rig;
    const std::string select = std::string("A") + letter + " ";
    // Another axis first: its value must not come here.
    rig.send(std::string(letter == 'X' ? "AY " : "AX ") + std::string(field.command) + " ");
    rig.axis_value(letter, field.value);
    EXPECT_NE(static_cast<std::int32_t>(rig.read32(p.first)), field.expected);
    rig.send(select + std::string(field.command) + " ");
    EXPECT_FALSE(rig.command_error()) << field.command;
    rig.run_for(1s);
    EXPECT_NE(static_cast<std::int32_t>(rig.read32(p.first)), field.expected) << "copied without being asked";
    EXPECT_EQ(rig.axis_value(letter, field.value), field.expected);
    EXPECT_EQ(static_cast<std::int32_t>(rig.read32(p.first)), field.expected);
    expect_same_in_all_widths(rig, p);
    expect_not_writable(rig, p);
    return;
  }
  ADD_FAILURE() << "no such value: " << f.id;
}

// --- the rest ----------------------------------------------------------------------------------------------

void check_read_only_reserve(const Form& f) {
  const Place p = place_of(f);
  expect_example_access(f, p);
  Rig rig;
  rig.send("AX LP1000 WY ");
  rig.axis_value('X', AxisValue::encoder_position);
  for (std::uint16_t at = p.first; at < p.last; at = static_cast<std::uint16_t>(at + 2))
    ASSERT_EQ(rig.read16(at), 0);
  expect_not_writable(rig, p);
}

void check_writable_reserve(const Form& f) {
  const Place p = place_of(f);
  expect_example_access(f, p);
  Rig rig;
  expect_plain_memory(rig, p);
  expect_same_in_all_widths(rig, p);
  rig.send("AX MR100 GO WY ");
  rig.run_for(1s);
  EXPECT_EQ(rig.read16(p.first), p.first ^ 0xA5A5) << "the board has nothing to do there";
  rig.send("RS");
  EXPECT_EQ(rig.read16(p.first), 0) << "hosts see by it that the board was reset";
}

/// A test for each row of axis data and reserved memory.
const bool memory_rows_registered = [] {
  for (const Form& f : form_table()) {
    const std::string prefix = "vme58.dpram.";
    if (f.id.compare(0, prefix.size(), prefix) != 0) continue;
    const std::string rest = f.id.substr(prefix.size());
    if (rest == "reserved1" || rest == "reserved2") {
      register_form(f.id, check_writable_reserve, __FILE__, __LINE__);
    } else if (rest.find("reserved") != std::string::npos) {
      register_form(f.id, check_read_only_reserve, __FILE__, __LINE__);
    } else if (rest.size() > 2 && rest[1] == '.') {
      register_form(f.id, check_axis_value, __FILE__, __LINE__);
    }
  }
  return true;
}();

}  // namespace

VME58_FORM("vme58.dpram.input_put_index") {
  const Place p = place_of(form);
  Rig rig;
  EXPECT_EQ(rig.read16(p.first), 0);
  rig.send("WY");
  EXPECT_EQ(rig.read16(p.first), framed("VME58 ver 2.24-8S").size());
  expect_not_writable(rig, p);
  // It wraps at 256 cells.
  for (int i = 0; i < 12; ++i) EXPECT_EQ(rig.value("WY"), "VME58 ver 2.24-8S");
  EXPECT_EQ(rig.read16(p.first), 13 * framed("VME58 ver 2.24-8S").size() % ring_cells);
}

VME58_FORM("vme58.dpram.output_get_index") {
  const Place p = place_of(form);
  Rig rig;
  EXPECT_EQ(rig.read16(p.first), 0);
  rig.send("AX EF ");
  EXPECT_EQ(rig.read16(p.first), 6) << "taken at once";
  expect_not_writable(rig, p);
  rig.send(std::string(260, ' '));
  EXPECT_EQ(rig.read16(p.first), (6 + 260) % ring_cells);
}

VME58_FORM("vme58.dpram.input_buffer") {
  const Place p = place_of(form);
  EXPECT_EQ(p.bytes, ring_bytes);
  Rig rig;
  rig.send("AX RP");
  const std::string expected = framed("0");
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(rig.read16(static_cast<std::uint16_t>(p.first + 2 * i)), expected[i]) << "cell " << i;
  expect_same_in_all_widths(rig, p);
  expect_not_writable(rig, p);
  // A reply over the end of the buffer goes on at its begin.
  while (rig.read16(at::input_put_index) < 250) rig.ask("RP");
  const std::uint16_t put = rig.read16(at::input_put_index);
  rig.send("WY");
  const std::string who = framed("VME58 ver 2.24-8S");
  for (std::size_t i = 0; i < who.size(); ++i)
    EXPECT_EQ(rig.read16(static_cast<std::uint16_t>(p.first + 2 * ((put + i) % ring_cells))), who[i]);
}

VME58_FORM("vme58.dpram.output_put_index") {
  const Place p = place_of(form);
  Rig rig;
  const std::string text = "AX LP77 ";
  for (std::size_t i = 0; i < text.size(); ++i)
    rig.write16(static_cast<std::uint16_t>(at::output_buffer + 2 * i), static_cast<std::uint8_t>(text[i]));
  EXPECT_EQ(rig.read16(at::output_get_index), 0) << "nothing is taken before it is published";
  rig.write16(p.first, static_cast<std::uint16_t>(text.size()));
  EXPECT_EQ(rig.read16(p.first), text.size());
  EXPECT_EQ(rig.read16(at::output_get_index), text.size());
  EXPECT_EQ(rig.position('X'), 77);
}

VME58_FORM("vme58.dpram.input_get_index") {
  const Place p = place_of(form);
  Rig rig;
  rig.send("WY");
  rig.write16(p.first, 3);
  EXPECT_EQ(rig.read16(p.first), 3) << "it is the host's";
  EXPECT_EQ(rig.output(), framed("VME58 ver 2.24-8S").substr(3));
  // While replies find no room the board takes no further command: nothing is lost.
  for (int i = 0; i < 15; ++i) rig.send("WY");
  EXPECT_GT(rig.waiting(), 0);
  std::string all;
  for (int i = 0; i < 4; ++i) all += rig.output();
  std::string expected;
  for (int i = 0; i < 15; ++i) expected += framed("VME58 ver 2.24-8S");
  EXPECT_EQ(all, expected);
  EXPECT_EQ(rig.waiting(), 0);
}

VME58_FORM("vme58.dpram.output_buffer") {
  const Place p = place_of(form);
  EXPECT_EQ(p.bytes, ring_bytes);
  Rig rig;
  expect_plain_memory(rig, p);
  // The character is the low byte, whatever stands in the high one; the ring goes round.
  const std::string text = std::string(254, ' ') + "LP42 ";
  rig.send(text.substr(0, 250));
  std::uint16_t put = rig.read16(at::output_put_index);
  for (const char c : text.substr(250)) {
    rig.write16(static_cast<std::uint16_t>(p.first + 2 * put), static_cast<std::uint16_t>(0xBE00 | c));
    put = static_cast<std::uint16_t>((put + 1) % ring_cells);
  }
  rig.write16(at::output_put_index, put);
  EXPECT_EQ(rig.position('X'), 42);
}

VME58_FORM("vme58.dpram.mailbox") {
  const Place p = place_of(form);
  Rig rig;
  expect_plain_memory(rig, p);
  rig.write32(p.first, 5439553);  // 'S' and 'A', one in each cell
  EXPECT_EQ(rig.read16(p.first), 'S');
  EXPECT_EQ(rig.read16(static_cast<std::uint16_t>(p.first + 2)), 'A');
  EXPECT_EQ(rig.read8(reg::control), 0) << "nothing happens before control bit 5";
}

VME58_FORM("vme58.dpram.registers") {
  const Place p = place_of(form);
  Rig rig;
  // Nine registers at odd addresses; all else reads 0 and takes nothing.
  for (std::uint16_t at = p.first; at <= p.last; ++at) {
    const bool is_register = at % 2 == 1 && at >= reg::control && at <= reg::vector;
    if (is_register) continue;
    rig.write8(at, 0xFF);
    EXPECT_EQ(rig.read8(at), 0) << at;
  }
  // A cycle of 16 bits has the register in its low byte.
  rig.write16(reg::vector - 1, 0x12B4);
  EXPECT_EQ(rig.read8(reg::vector), 0xB4);
  EXPECT_EQ(rig.read16(reg::vector - 1), 0x00B4);
}

}  // namespace hw::vme58::proof
