// Jobs beside the frame, on real threads: whoever waits for a picture does not wait for a rehearsal.
#include "gui/model/worker.h"

#include <future>

#include <gtest/gtest.h>

namespace hw::gui {
namespace {

struct WorkerTest : testing::Test {
  /// Delivers until that is ready; each finished job says so.
  void deliver_until(const bool& ready) {
    while (!ready) {
      std::unique_lock lock(mutex);
      woken.wait(lock, [this] { return wakes > 0; });
      wakes = 0;
      lock.unlock();
      worker.deliver();
    }
  }
  std::mutex mutex;
  std::condition_variable woken;
  int wakes = 0;
  std::shared_ptr<int> alive = std::make_shared<int>(0);
  Worker worker{[this] {
                  const std::lock_guard lock(mutex);
                  ++wakes;
                  woken.notify_one();
                },
                true};
};

TEST_F(WorkerTest, AShortJobDoesNotWaitForALongOne) {
  std::promise<int> end;
  bool is_short_done = false;
  int of_long = 0;
  worker.run([of = end.get_future().share()] { return of.get(); }, [&](int value) { of_long = value; },
             alive);
  worker.run_short([] { return true; }, [&](bool value) { is_short_done = value; }, alive);
  deliver_until(is_short_done);
  EXPECT_EQ(of_long, 0) << "the long one is still at it";
  end.set_value(7);
  worker.finish();
  worker.deliver();
  EXPECT_EQ(of_long, 7);
  EXPECT_FALSE(worker.deliver()) << "nothing is left";
}

TEST_F(WorkerTest, ShortJobsKeepTheirOrder) {
  std::vector<int> order;
  for (int n = 0; n < 5; ++n)
    worker.run_short([n] { return n; }, [&](int value) { order.push_back(value); }, alive);
  worker.finish();
  worker.deliver();
  EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
}

TEST(WorkerWithoutThread, ShortJobsRunInTheirTurnToo) {
  const auto alive = std::make_shared<int>(0);
  Worker worker;
  std::vector<int> order;
  worker.run([] { return 1; }, [&](int n) { order.push_back(n); }, alive);
  worker.run_short([] { return 2; }, [&](int n) { order.push_back(n); }, alive);
  EXPECT_TRUE(worker.deliver());
  EXPECT_EQ(order, (std::vector<int>{1, 2}));
}

}  // namespace
}  // namespace hw::gui
