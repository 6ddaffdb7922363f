#pragma once
// Counts what this program takes from the heap: operator new of every kind and ImGui's own allocator.
#include <cstdint>

namespace hw {

std::uint64_t allocations();
/// Before any ImGui context is made.
void count_imgui_allocations();

}  // namespace hw
