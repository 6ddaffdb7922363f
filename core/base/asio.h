#pragma once
// The core's only access to Boost.Asio: coroutines and the executor. Sockets and serial ports belong to
// transports/. (<utility> first: Boost 1.74's awaitable.hpp uses std::exchange without it.)
// clang-format off
#include <optional>
#include <utility>

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/async_result.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
// clang-format on

namespace hw {

namespace asio = boost::asio;
using IoContext = asio::io_context;
using Executor = IoContext::executor_type;

/// The return type of an asynchronous procedure. For g++ 12: no braces and no capturing lambda inside a
/// co_await expression; build the value on the line before.
template <class T = void>
using Task = asio::awaitable<T, Executor>;

/// Completion token for Task: `co_await async_something(..., use_task)`.
inline constexpr asio::use_awaitable_t<Executor> use_task{};

/// A suspended Task, held by the caller that will resume it. Resuming goes through the executor, never
/// inline.
class Suspended {
 public:
  [[nodiscard]] bool waiting() const { return handler_.has_value(); }
  void resume(const Executor& executor) {
    if (!handler_) return;
    Handler handler = std::move(*handler_);
    handler_.reset();
    asio::post(executor, std::move(handler));
  }
  /// Suspends the calling Task until resume(). One at a time.
  Task<> here() {
    return asio::async_initiate<const asio::use_awaitable_t<Executor>, void()>(
        [this](Handler handler) { handler_.emplace(std::move(handler)); }, use_task);
  }

 private:
  using Handler = asio::async_result<asio::use_awaitable_t<Executor>, void()>::handler_type;
  std::optional<Handler> handler_;
};

}  // namespace hw
