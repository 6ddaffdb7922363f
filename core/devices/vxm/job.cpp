#include "core/devices/vxm/job.h"

namespace hw::vxm {

Job Job::jog(Leg leg) {
  Job job;
  job.jog_ = true;
  job.add(std::move(leg));
  return job;
}

bool Job::concerns(const StopOrder& order) const {
  if (!active()) return false;
  if (order.what == StopOrder::What::jog && leg().activity != Activity::jogging) return false;
  return order.axis < 0 || leg().is_of(order.axis);
}

void Job::note_stop() {
  if (!active()) return;
  if (ended_by_ == EndedBy::nothing) cut_whole_ = leg().second_axis < 0 && legs_.size() == 1;
  drop_rest();
  if (!leg_over_ && ended_by_ == EndedBy::nothing) ended_by_ = EndedBy::stop;
}

void Job::drop_rest() {
  if (legs_.size() > 1) legs_.resize(1);
  jog_ = false;
}

std::vector<Leg> Job::drop_later_legs(int axis) {
  std::vector<Leg> dropped;
  for (std::size_t i = 1; i < legs_.size();) {
    if (axis >= 0 && !legs_[i].is_of(axis)) {
      ++i;
      continue;
    }
    dropped.push_back(std::move(legs_[i]));
    legs_.erase(legs_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return dropped;
}

void Job::go_on(EndedBy ended_by, std::optional<Leg> again) {
  legs_.pop_front();
  if (again) legs_.push_back(std::move(*again));
  if (ended_by != EndedBy::target) legs_.clear();
}

}  // namespace hw::vxm
