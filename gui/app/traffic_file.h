#pragma once
// Every byte of every wire in a text file, with its time: `run --traffic`.
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "core/session/wire.h"

namespace hw::app {

class TrafficFile {
 public:
  static Result<std::shared_ptr<TrafficFile>> create(const std::string& path);
  /// Called (io thread) when it cannot be written any more.
  std::function<void(const Fault& why)> on_failure;
  ~TrafficFile();
  TrafficFile(const TrafficFile&) = delete;
  TrafficFile& operator=(const TrafficFile&) = delete;

  /// The same opener, with each wire that it opens written down under a number of its own.
  static WireOpener tap(std::shared_ptr<TrafficFile> file, WireOpener inner);

  /// "    1.234567 2 > X\r": seconds, number of the wire, sent or received, bytes.
  void write(Instant at, int wire, char way, std::string_view bytes);
  void note(Instant at, int wire, std::string_view event);
  /// Whether all that was written stands in the file now. Nobody is called from here on.
  Result<> finish();

 private:
  TrafficFile(std::FILE* file, std::string path) : file_(file), path_(std::move(path)) {}
  void put(std::string_view line);
  [[nodiscard]] Fault not_written() const;

  std::FILE* file_;
  std::string path_;
  int error_ = 0;  ///< errno of the first write that failed
  int wires_ = 0;
};

}  // namespace hw::app
