#pragma once
// Asio's names for TCP on the io thread's executor.
#include <boost/asio/ip/tcp.hpp>

#include "core/base/asio.h"

namespace hw::tcp {

using Tcp = asio::ip::tcp;
using Socket = asio::basic_stream_socket<Tcp, Executor>;
using Error = boost::system::error_code;

}  // namespace hw::tcp
