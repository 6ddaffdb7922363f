#include "core/device/tool_guard.h"

#include <gtest/gtest.h>

#include "core/device/registry.h"

namespace hw {
namespace {

using Request = ToolGuard::Request;

/// An output that stays on whatever it is told.
TEST(ToolGuard, IsSwitchedOffInVainOnceForEachRun) {
  const Catalog catalog = *find_device_type("dmx-k-sa")->make_catalog({});
  const ToolOff tool{{1, false}};
  ToolGuard guard(catalog);
  Snapshot now;
  now.axis_count = 1;
  now.outputs = now.outputs_known = 1;
  const auto request_after_a_look = [&](std::uint64_t round) {
    if (const Request first = guard.watch(now, round); first != Request::look) return first;
    guard.looks_by(round + 1, now.io_seen_at);
    now.io_seen_at += std::chrono::seconds(1);
    return guard.watch(now, round + 1);
  };
  guard.pieces_begin(tool, now);
  EXPECT_EQ(request_after_a_look(1), Request::switch_off);
  StopOrder order;
  order.what = StopOrder::What::tool;
  order.tool = tool;
  order.confirmed = true;
  for (order.times_sent = 1; guard.progress(order, now).now == StopProgress::Now::again; ++order.times_sent)
    now.io_seen_at += std::chrono::seconds(1);
  EXPECT_EQ(order.times_sent, 5);
  EXPECT_EQ(guard.progress(order, now).now, StopProgress::Now::failed);
  guard.give_up();
  EXPECT_EQ(request_after_a_look(10), Request::nothing);
  EXPECT_TRUE(guard.may_be_on(now)) << "a stop takes it along all the same";
  guard.pieces_begin(tool, now);
  EXPECT_EQ(request_after_a_look(20), Request::switch_off);
}

}  // namespace
}  // namespace hw
