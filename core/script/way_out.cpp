#include "core/script/way_out.h"

namespace hw::script {
namespace {

constexpr int signal_out = SIGURG;  // ignored by default

thread_local WayOut* way_of_this_thread = nullptr;

}  // namespace

WayOut::WayOut(const std::atomic<std::uint64_t>& beat) : beat_(beat), thread_(pthread_self()) {
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
  way_of_this_thread = this;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART | SA_NODEFER;  // the handler ends in a jump
  sigaction(signal_out, &action, &before_);
}

WayOut::~WayOut() {
  way_of_this_thread = nullptr;
  sigaction(signal_out, &before_, nullptr);
}

void WayOut::take(std::uint64_t seen) {
  seen_ = seen;
  pthread_kill(thread_, signal_out);
}

void WayOut::on_signal(int) {
  WayOut* way = way_of_this_thread;
  if (way && way->closed_ == 0 && way->beat_ == way->seen_) siglongjmp(way->place_, 1);
}

}  // namespace hw::script
