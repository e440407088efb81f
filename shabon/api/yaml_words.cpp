#include "shabon/api/yaml_words.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "shabon/base/text.h"

namespace shabon::api {

namespace {

constexpr std::string_view blanks = " \t\r\n";

// The file's lines from a scalar's place on, word by word.
class WordPlaces {
 public:
  WordPlaces(const std::vector<std::string>& lines, int line, int column) : lines_(lines) {
    line_ = static_cast<std::size_t>(std::max(line, 1)) - 1;
    const std::string_view text = current();
    int characters = 1;
    for (; at_ < text.size() && characters < column; ++at_)
      characters += at_ + 1 < text.size() && (static_cast<unsigned char>(text[at_ + 1]) & 0xC0) != 0x80;
    // A block scalar begins on the line below its | or >, which may carry more: |- or >2.
    const std::size_t first = text.find_first_not_of(blanks, at_);
    if (first != std::string_view::npos && (text[first] == '|' || text[first] == '>')) next_line();
  }

  // The next word, without quotes around the scalar; its place is line() and column().
  std::optional<std::string_view> next() {
    for (; line_ < lines_.size(); next_line()) {
      const std::string_view text = current();
      begin_ = std::min(text.find_first_not_of(" \t\r\"'", at_), text.size());
      if (begin_ == text.size()) continue;
      at_ = std::min(text.find_first_of(" \t\r\"'", begin_), text.size());
      return text.substr(begin_, at_ - begin_);
    }
    return {};
  }

  int line() const { return static_cast<int>(line_) + 1; }
  int column() const { return static_cast<int>(utf8_characters(current().substr(0, begin_)).size()) + 1; }

 private:
  std::string_view current() const { return line_ < lines_.size() ? std::string_view(lines_[line_]) : ""; }
  void next_line() {
    ++line_;
    at_ = begin_ = 0;
  }

  const std::vector<std::string>& lines_;
  std::size_t line_ = 0, at_ = 0, begin_ = 0;
};

}  // namespace

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; (begin = text.find_first_not_of(blanks, begin)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end;
  }
  return words;
}

Diagnostic diagnostic_at_word(const io::YamlDocument& document, const io::YamlNode& scalar, std::size_t word,
                              std::string message) {
  const std::vector<std::string_view> words = words_of(scalar.text);
  WordPlaces places(document.lines, scalar.line, scalar.column);
  io::YamlNode place = scalar;
  for (std::size_t i = 0; i <= word && i < words.size(); ++i) {
    const auto shown = places.next();
    if (shown != words[i]) break;
    if (i < word) continue;
    place.line = places.line();
    place.column = places.column();
  }
  return io::diagnostic_at(document, place, std::move(message));
}

}  // namespace shabon::api
