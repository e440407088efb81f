// n-k files written for a test, and what reading them says.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "shabon/api/nk_file.h"

namespace shabon::api {

class NkFolder {
 public:
  NkFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "shabon-nk-XXXXXX").string();
    if (const char* made = ::mkdtemp(pattern.data())) folder_ = made;
  }
  ~NkFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  NkFolder(const NkFolder&) = delete;
  NkFolder& operator=(const NkFolder&) = delete;

  Result<optics::Medium> read(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return read_nk_file(folder_ / name);
  }

 private:
  std::filesystem::path folder_;
};

// A broken file and the first thing said about it.
struct BrokenFile {
  const char* text;
  int line, column;
  const char* message;  // its beginning
};

inline void expect_refused(const NkFolder& folder, const std::string& name, const BrokenFile& broken) {
  const Result<optics::Medium> medium = folder.read(name, broken.text);
  ASSERT_FALSE(medium.ok()) << broken.text;
  const Diagnostic& error = medium.errors().front();
  EXPECT_EQ(error.line, broken.line) << broken.text << to_text(error);
  EXPECT_EQ(error.column, broken.column) << broken.text << to_text(error);
  EXPECT_EQ(error.message.rfind(broken.message, 0), 0u) << broken.text << to_text(error);
  EXPECT_EQ(error.failure, Failure::content);
  EXPECT_NE(error.source.find(name), std::string::npos);
  EXPECT_NE(error.message.find("expected"), std::string::npos) << to_text(error);
  EXPECT_FALSE(error.excerpt.empty()) << to_text(error);
}

}  // namespace shabon::api
