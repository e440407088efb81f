// The documentation agrees with the tree: links, the files that pages name, and the numbers of equations.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>

#include "markdown.h"

namespace shabon::test {
namespace {

namespace fs = std::filesystem;

const fs::path root = SHABON_SOURCE_DIR;

// Files below the root with one of the endings, leaving out hidden folders and what was built.
std::vector<fs::path> files(const std::set<std::string>& endings) {
  std::vector<fs::path> found;
  for (fs::recursive_directory_iterator at(root), end; at != end; ++at) {
    const std::string name = at->path().filename().string();
    if (at->is_directory() && (name.starts_with(".") || name.starts_with("build"))) at.disable_recursion_pending();
    if (at->is_regular_file() && endings.contains(at->path().extension().string())) found.push_back(at->path());
  }
  return found;
}

TEST(Docs, EveryLinkLeadsSomewhere) {
  const std::vector<fs::path> pages = files({".md"});
  std::size_t links = 0;
  for (const fs::path& page : pages) {
    links += links_in(text_of(page)).size();
    for (const std::string& broken : broken_links(page)) ADD_FAILURE() << broken;
  }
  EXPECT_GT(pages.size(), 5u);
  EXPECT_GT(links, 50u);
}

TEST(Docs, ABrokenLinkIsFound) {
  const fs::path folder = fs::path(testing::TempDir()) / "shabon_docs";
  fs::create_directories(folder);
  std::ofstream(folder / "other.md") << "# A heading, with `code`\n";
  std::ofstream(folder / "page.md") << "[a](other.md) [b](other.md#a-heading-with-code) [c](https://example.org/x)\n"
                                       "[![d](gone.png)](other.md)\n[e](other.md#gone) `[f](code.md)`\n"
                                       "```\n[g](code.md)\n```\n[h](#gone)\n";
  const std::string page = (folder / "page.md").string();
  EXPECT_EQ(broken_links(page),
            (std::vector<std::string>{page + ":2: there is no gone.png", page + ":3: other.md has no heading #gone",
                                      page + ":7:  has no heading #gone"}));
  fs::remove_all(folder);
}

// `optics/reference/airy.h` and the like. The other pages also name files that the reader is to write.
TEST(Docs, FilesNamedInThePagesExist) {
  static const std::regex named("`((?:[a-z0-9_]+/)*[a-z0-9_]+\\.(?:h|cpp|py|cmake))`");
  std::set<std::string> names;
  for (const fs::path& file : files({".h", ".cpp", ".py", ".cmake"})) names.insert(file.filename().string());
  std::size_t count = 0;
  for (const char* page :
       {"docs/physics.md", "docs/architecture.md", "docs/paper.md", "docs/conventions.md", "README.md"}) {
    const std::string text = text_of(root / page);
    for (std::sregex_iterator at(text.begin(), text.end(), named), end; at != end; ++at, ++count) {
      const std::string name = (*at)[1];
      const bool path = name.find('/') != std::string::npos;
      EXPECT_TRUE(path ? fs::exists(root / name) || fs::exists(root / "shabon" / name) : names.contains(name))
          << page << " names " << name;
    }
  }
  EXPECT_GT(count, 20u);
}

int equations() {
  const std::string text = text_of(root / "docs/physics.md");
  static const std::regex tag(R"(\\tag\{(\d+)\})");
  int last = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), tag), end; at != end; ++at)
    EXPECT_EQ(std::stoi((*at)[1]), ++last) << "docs/physics.md numbers its equations in order";
  return last;
}

TEST(Docs, CitedEquationsExist) {
  const int last = equations();
  ASSERT_GE(last, 28);
  static const std::regex cited(R"([Ee]quations? \((\d+)\)(?:(?:,| and| to) \((\d+)\))*)"), number(R"(\((\d+)\))");
  std::size_t count = 0;
  for (const fs::path& file : files({".h", ".cpp", ".md"})) {
    const std::string text = text_of(file);
    for (std::sregex_iterator at(text.begin(), text.end(), cited), end; at != end; ++at) {
      const std::string numbers = at->str();
      for (std::sregex_iterator n(numbers.begin(), numbers.end(), number); n != end; ++n, ++count)
        EXPECT_LE(std::stoi((*n)[1]), last) << file << ": " << numbers;
    }
  }
  EXPECT_GT(count, 20u);
}

}  // namespace
}  // namespace shabon::test
