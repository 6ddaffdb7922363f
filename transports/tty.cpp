#include "transports/tty.h"

namespace hw {
namespace {
struct Rate {
  int baud;
  speed_t constant;
};
constexpr Rate rates[] = {
    {300, B300},       {600, B600},       {1200, B1200},     {2400, B2400},   {4800, B4800},
    {9600, B9600},     {19200, B19200},   {38400, B38400},   {57600, B57600}, {115200, B115200},
    {230400, B230400}, {460800, B460800}, {921600, B921600},
};
}  // namespace

std::optional<speed_t> speed_constant(int baud) {
  for (const Rate& rate : rates)
    if (rate.baud == baud) return rate.constant;
  return std::nullopt;
}

int baud_of(speed_t constant) {
  for (const Rate& rate : rates)
    if (rate.constant == constant) return rate.baud;
  return 0;
}

void make_raw_8n1(termios& settings) {
  ::cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSIZE | PARENB | CSTOPB | CRTSCTS | HUPCL);
  settings.c_cflag |= CS8 | CLOCAL | CREAD;
  settings.c_iflag |= IGNBRK;
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
}

}  // namespace hw
