#include "core/devices/vme58/emulator_window.h"

namespace hw::vme58 {
namespace {

constexpr std::uint16_t last_cell = ring_cells - 1;

constexpr std::uint16_t cell_of(std::uint16_t buffer, std::uint16_t index) {
  return static_cast<std::uint16_t>(buffer + 2 * index);
}
constexpr std::uint16_t after(std::uint16_t index) {
  return static_cast<std::uint16_t>((index + 1) % ring_cells);
}

}  // namespace

std::uint16_t Window::cell(std::uint16_t offset) const {
  return static_cast<std::uint16_t>(bytes_[offset] << 8 | bytes_[offset + 1u]);
}

void Window::set_cell(std::uint16_t offset, std::uint16_t value) {
  bytes_[offset] = static_cast<std::uint8_t>(value >> 8);
  bytes_[offset + 1u] = static_cast<std::uint8_t>(value);
}

bool Window::indexes_make_sense() const {
  return cell(at::output_put_index) <= last_cell && cell(at::input_get_index) <= last_cell;
}

std::optional<char> Window::take() {
  const std::uint16_t get = cell(at::output_get_index), put = cell(at::output_put_index);
  if (put > last_cell || get == put) return std::nullopt;
  set_cell(at::output_get_index, after(get));
  return static_cast<char>(cell(cell_of(at::output_buffer, get)) & 0xFF);
}

bool Window::put(char c) {
  const std::uint16_t put = cell(at::input_put_index), get = cell(at::input_get_index);
  if (get > last_cell || after(put) == get) return false;
  set_cell(cell_of(at::input_buffer, put), static_cast<std::uint8_t>(c));
  set_cell(at::input_put_index, after(put));
  return true;
}

void Window::set_axis_value(int axis, AxisValue value, std::int32_t to) {
  const std::uint16_t offset = offset_of(axis, value);
  const auto bits = static_cast<std::uint32_t>(to);
  set_cell(offset, static_cast<std::uint16_t>(bits >> 16));
  set_cell(static_cast<std::uint16_t>(offset + 2), static_cast<std::uint16_t>(bits));
}

void Window::empty_rings() {
  for (const std::uint16_t index :
       {at::input_put_index, at::output_get_index, at::output_put_index, at::input_get_index})
    set_cell(index, 0);
}

}  // namespace hw::vme58
