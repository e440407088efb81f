// A folder that lives as long as the test, and what the tests say about errors.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "shabon/base/result.h"

namespace shabon::io {

class Scratch {
 public:
  Scratch() {
    std::string pattern = (std::filesystem::temp_directory_path() / "shabon-io-XXXXXX").string();
    if (const char* made = ::mkdtemp(pattern.data())) folder_ = made;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  std::filesystem::path put(const std::string& name, std::string_view bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  std::string get(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return text.str();
  }
  std::size_t entries() const {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++count;
    return count;
  }

 private:
  std::filesystem::path folder_;
};

// The result is an error of this kind whose message holds `words`.
template <class T>
testing::AssertionResult fails(const Result<T>& result, Failure failure, const std::string& words) {
  if (result.ok()) return testing::AssertionFailure() << "no error";
  const Diagnostic& first = result.errors().front();
  if (first.failure == failure && first.message.find(words) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "failure " << static_cast<int>(first.failure) << ": " << to_text(first);
}

// A picture with as many values as its size says, or an error about its content.
template <class Image>
testing::AssertionResult is_whole_or_refused(const Result<Image>& image) {
  if (!image) return fails(image, Failure::content, "");
  if (image->rgb.size() == 3 * static_cast<std::size_t>(image->width) * static_cast<std::size_t>(image->height))
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << image->width << "x" << image->height << ": " << image->rgb.size() << " values";
}

template <class T>
std::string errors_of(const Result<T>& result) {
  return result.ok() ? "" : to_text(result.errors());
}

}  // namespace shabon::io
