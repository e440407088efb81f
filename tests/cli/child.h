// Runs the built program as a child process and keeps what it said.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shabon::test {

struct Outcome {
  int exit_code = -1;  // 128 + the signal when one ended it
  std::string out, err;
  double processor_seconds = 0;  // of the program, whatever the clock says
};

struct Setting {
  std::filesystem::path folder;  // the working folder; empty: that of the test
  std::vector<std::pair<std::string, std::string>> environment;
  enum class Output { kept, device_full, closed_pipe, closed } output = Output::kept;
  std::optional<std::size_t> most_file_bytes;  // no file may grow larger, as on a full disk
  // These signals, each after its pause.
  std::vector<std::pair<std::chrono::milliseconds, int>> signals;
};

// `arguments` without the program's name.
Outcome run(const std::vector<std::string>& arguments, const Setting& setting = {});

// A fresh folder, removed with all it holds at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::vector<std::string> files() const;  // names, sorted
  std::filesystem::path write(const std::string& name, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

std::string read_all(const std::filesystem::path& path);

// "a 'b c' d" as a shell takes it apart.
std::vector<std::string> words(const std::string& line);

}  // namespace shabon::test
