// A round of status at rest takes nothing from the heap. What Asio takes for the frames of coroutines and for
// its handlers is not counted: it asks for whole words and one byte (its recycler's mark), as nothing of
// ours does here. With a sanitizer the heap is not ours to count.
#include <atomic>
#include <cstdlib>
#include <new>

#include "tests/core/devices/vme58/driver_rig.h"

#ifndef HW_SANITIZED

namespace {
std::atomic<bool> counting{false};
std::atomic<int> taken{0};
std::atomic<std::size_t> largest{0};

void* take(std::size_t size) {
  constexpr std::size_t word = 4;
  if (counting && size % word != 1) {
    ++taken;
    largest = std::max(largest.load(), size);
  }
  if (void* p = std::malloc(size ? size : 1)) return p;
  throw std::bad_alloc();
}
}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace hw {
namespace {

class Vme58Heap : public test::Vme58Rig {
 protected:
  /// What a second of rounds takes, once all memory that is kept has been taken.
  int taken_in_a_second() {
    session->traffic().drain([](const TrafficEntry&) {});
    // Each slot of the ring of traffic takes memory once: as if it had gone round.
    const auto fill = [](TrafficEntry& entry) { entry.bytes.assign(200, ' '); };
    while (session->traffic().push_in_place(fill)) continue;
    session->traffic().drain([](const TrafficEntry&) {});
    run(std::chrono::seconds(5));
    taken = 0, largest = 0;
    counting = true;
    run(std::chrono::seconds(1));
    counting = false;
    return taken;
  }
};

TEST_F(Vme58Heap, TheCounterCounts) {
  counting = true;
  taken = 0;
  delete new std::uint64_t(7);
  std::vector<BusCycle> cycles(3);
  counting = false;
  EXPECT_EQ(taken, 2);
}

TEST_F(Vme58Heap, RoundsAtRestTakeNothing) {
  for (int i = 0; i < 8; ++i) ASSERT_TRUE(query("A" + std::string(1, "XYZTUVRS"[i]) + " LP-1234567"));
  EXPECT_EQ(taken_in_a_second(), 0) << "the largest of " << largest << " bytes";
}

TEST_F(Vme58Heap, RoundsWhileAxesMoveTakeNothing) {
  // What others have set going is asked for its queues too, which takes strings: these are the console's own.
  std::vector<AxisTarget> far;
  for (std::uint8_t i = 0; i < 8; ++i) far.push_back({AxisId{i}, Steps(1000000 + i)});
  session->send(intent::MoveTo(std::move(far), Pps{2000}));
  run(std::chrono::seconds(1));
  EXPECT_EQ(taken_in_a_second(), 0) << "the largest of " << largest << " bytes";
  EXPECT_GT(axis(7).position, Steps(100));
}

}  // namespace
}  // namespace hw

#endif
