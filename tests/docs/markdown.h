// What the documentation's tests need of a Markdown page.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace shabon::test {

struct Link {
  std::string target;  // as written, without an anchor; empty: a place on the same page
  std::string anchor;  // without '#'; empty: the page itself
  int line = 0;        // counted from 1
};

// The links and pictures [text](target) of a page, outside of code.
std::vector<Link> links_in(const std::string& page);

// The anchors of a page's headings, as GitHub forms them: lower case, blanks to '-', punctuation left out.
std::set<std::string> anchors_in(const std::string& page);

// Every broken link of the page `path`, one line each; empty when all is well. Addresses on the web are not followed.
std::vector<std::string> broken_links(const std::filesystem::path& path);

std::string text_of(const std::filesystem::path& path);

}  // namespace shabon::test
