#include "core/device/stop.h"

#include <algorithm>

namespace hw {

StopOrder& StopDesk::ask(StopOrder order) {
  ++epoch_;
  order.number = ++asked_;
  const bool may_escalate = order.what == StopOrder::What::everything;
  const bool again = std::any_of(orders_.begin(), orders_.end(), [&](const StopOrder& open) {
    return open.intent != 0 && open.same_scope(order);
  });
  if (may_escalate && again) order.at_once = true;
  orders_.push_back(std::move(order));
  return orders_.back();
}

StopOrder& StopDesk::ask_tool(const ToolOff& tool) {
  const auto is_tool = [](const StopOrder& o) { return o.what == StopOrder::What::tool; };
  const auto open = std::find_if(orders_.begin(), orders_.end(), is_tool);
  StopOrder& order = open == orders_.end() ? orders_.emplace_back() : *open;
  order.what = StopOrder::What::tool;
  order.tool = tool;
  order.sent = order.confirmed = false;
  order.times_sent = 0;
  order.number = ++asked_;
  return order;
}

bool StopDesk::has_tool() const {
  return std::any_of(orders_.begin(), orders_.end(),
                     [](const StopOrder& o) { return o.what == StopOrder::What::tool; });
}

bool StopDesk::only_tool() const { return orders_.size() == 1 && has_tool(); }

bool StopDesk::stops_all() const {
  return std::any_of(orders_.begin(), orders_.end(), [](const StopOrder& o) { return o.stops_all(); });
}

StopOrder* StopDesk::due() {
  StopOrder* next = nullptr;
  for (StopOrder& order : orders_)
    if (!order.sent && (!next || (!next->outlasts(order) && order.times_sent <= next->times_sent)))
      next = &order;
  return next;
}

bool StopDesk::another_waits(const StopOrder& order) const {
  return std::any_of(orders_.begin(), orders_.end(), [&](const StopOrder& other) {
    const bool goes_first = other.times_sent == 0 || other.outlasts(order);
    return &other != &order && !other.sent && goes_first && !order.outlasts(other);
  });
}

bool StopDesk::all_were_sent(int times) const {
  return std::all_of(orders_.begin(), orders_.end(),
                     [times](const StopOrder& order) { return order.times_sent >= times; });
}

bool StopDesk::uses_the_wire() const {
  return sending_ != 0 || std::any_of(orders_.begin(), orders_.end(), [](const StopOrder& order) {
           return !order.sent && order.times_sent == 0;
         });
}

void StopDesk::send_all_again() {
  for (StopOrder& order : orders_) {
    order.sent = order.confirmed = false;
    if (order.what == StopOrder::What::words)
      order.what = StopOrder::What::everything;  // a typed text is sent once
  }
}

StopOrder* StopDesk::find(std::uint64_t number) {
  for (StopOrder& order : orders_)
    if (order.number == number) return &order;
  return nullptr;
}

void StopDesk::close(const StopOrder& order) {
  orders_.remove_if([&](const StopOrder& open) { return &open == &order; });
}

std::optional<StopOrder> stop_order_of(const Intent& intent) {
  StopOrder order;
  order.intent = intent.id;
  order.asked_at = intent.asked_at;
  if (const auto* s = std::get_if<intent::Stop>(&intent.body)) {
    order.axis = s->axis;
    order.by = s->by;
  } else if (const auto* a = std::get_if<intent::Abort>(&intent.body)) {
    order.axis = a->axis;
    order.by = a->by;
    order.at_once = true;
  } else if (const auto* j = std::get_if<intent::JogStop>(&intent.body)) {
    order.what = StopOrder::What::jog;
    order.axis = j->axis;
    order.by = j->by;
  } else if (const auto* h = std::get_if<intent::HaltProgram>(&intent.body)) {
    order.what = StopOrder::What::program;
    order.thread = h->thread;
    order.by = h->by;
  } else {
    return std::nullopt;
  }
  return order;
}

}  // namespace hw
