#pragma once
// Writes all bytes of all wires to a text file, with their times: `run --traffic`.
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "core/session/wire.h"

namespace hw::app {

class TrafficFile {
 public:
  static Result<std::shared_ptr<TrafficFile>> create(const std::string& path);
  /// Called when writing fails. Io thread.
  std::function<void(const Fault& why)> on_failure;
  ~TrafficFile();
  TrafficFile(const TrafficFile&) = delete;
  TrafficFile& operator=(const TrafficFile&) = delete;

  /// Returns an opener that records each wire which `inner` opens, under a number of its own.
  static WireOpener tap(std::shared_ptr<TrafficFile> file, WireOpener inner);

  /// Writes "    1.234567 2 > X\r": seconds, number of the wire, sent or received, bytes.
  void write(Instant at, int wire, char way, std::string_view bytes);
  void note(Instant at, int wire, std::string_view event);
  /// Closes the file. A fault means that a part is missing in it. The callback is not called any more.
  Result<> finish();

 private:
  TrafficFile(std::FILE* file, std::string path) : file_(file), path_(std::move(path)) {}
  void put(std::string_view line);
  [[nodiscard]] Fault not_written() const;

  std::FILE* file_;  ///< null: finished

  std::string path_;
  int error_ = 0;  ///< errno of the first write that failed
  int wires_ = 0;
};

}  // namespace hw::app
