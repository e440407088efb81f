#include "shabon/io/yaml.h"

#include <gtest/gtest.h>

#include "scratch.h"

namespace shabon::io {
namespace {

using Kind = YamlNode::Kind;

YamlDocument parsed(std::string_view text) {
  auto document = parse_yaml(text, "t");
  EXPECT_TRUE(document) << errors_of(document);
  return document ? *document : YamlDocument{};
}

// "line:column message" of every error, one below the other.
std::string complaints(std::string_view text) {
  const auto document = parse_yaml(text, "t");
  if (document) return "none";
  std::string all;
  for (const Diagnostic& error : document.errors()) {
    EXPECT_EQ(error.failure, Failure::content);
    EXPECT_EQ(error.source, "t");
    all += (all.empty() ? "" : "\n") + std::to_string(error.line) + ":" + std::to_string(error.column) + " " +
           error.message;
  }
  return all;
}

std::string repeat(std::string_view text, std::size_t count) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

TEST(Yaml, KeepsTextAndPlaces) {
  const YamlDocument document = parsed("camera:\n  up: [0, \"1\", -.5e3]\n  name: a b # comment\nnone:\nlast: ~\n");
  const YamlNode& root = document.root;
  ASSERT_EQ(root.kind, Kind::mapping);
  ASSERT_EQ(root.entries.size(), 3u);
  const YamlNode* up = find(*find(root, "camera"), "up");
  ASSERT_TRUE(up);
  EXPECT_EQ(up->line, 2);
  EXPECT_EQ(up->column, 7);
  ASSERT_EQ(up->items.size(), 3u);
  EXPECT_EQ(up->items[1].text, "1");
  EXPECT_TRUE(up->items[1].quoted);
  EXPECT_FALSE(up->items[2].quoted);
  EXPECT_EQ(up->items[2].column, 16);
  EXPECT_EQ(find(*find(root, "camera"), "name")->text, "a b");
  EXPECT_EQ(find(root, "none")->kind, Kind::null);
  EXPECT_EQ(find(root, "none")->line, 4);
  EXPECT_EQ(find(root, "last")->kind, Kind::null);
  EXPECT_EQ(find(root, "nothing"), nullptr);
  EXPECT_EQ(document.lines[2], "  name: a b # comment");
}

TEST(Yaml, ReadsJson) {
  const YamlDocument document = parsed("{\r\n\t\"a\":[1,2.5e-3,true,null],\r\n\t\"\xC3\xA9\":\"\\u00e9\\n\\/\"}");
  ASSERT_EQ(document.root.entries.size(), 2u);
  EXPECT_EQ(document.root.entries[0].second.items[1].text, "2.5e-3");
  EXPECT_EQ(document.root.entries[0].second.items[3].kind, Kind::null);
  EXPECT_EQ(document.root.entries[1].second.text, "\xC3\xA9\n/");
}

TEST(Yaml, CountsColumnsInCharacters) {
  const YamlDocument document = parsed("[\xE3\x81\x97\xE3\x82\x83, \xC3\xA9, x, {k: y}]");
  EXPECT_EQ(document.root.items[1].column, 6);
  EXPECT_EQ(document.root.items[2].column, 9);
  EXPECT_EQ(document.root.items[3].entries[0].second.column, 16);
}

TEST(Yaml, EveryKindOfLineEndCounts) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const YamlDocument document = parsed("a: 1" + std::string(end) + "b: 2" + end);
    EXPECT_EQ(find(document.root, "b")->line, 2);
    EXPECT_EQ(document.lines, (std::vector<std::string>{"a: 1", "b: 2"}));
  }
}

TEST(Yaml, ExpandsAliases) {
  const YamlDocument document = parsed("film: &f {medium: water}\nb: *f\nlist: [*f, *f]\n");
  const YamlNode* b = find(document.root, "b");
  EXPECT_EQ(find(*b, "medium")->text, "water");
  EXPECT_EQ(b->line, 1);  // the place of what it repeats
  EXPECT_EQ(find(document.root, "list")->items.size(), 2u);
}

TEST(Yaml, KnowsTheCoreTags) {
  const YamlDocument document = parsed("[!!str 5, !!int 5, !!float \"1.5\", !!seq [], !!map {}, !!null ~, ! 7]");
  EXPECT_TRUE(document.root.items[0].quoted);
  EXPECT_FALSE(document.root.items[1].quoted);
  EXPECT_FALSE(document.root.items[2].quoted);
  EXPECT_EQ(document.root.items[5].kind, Kind::null);
  EXPECT_TRUE(document.root.items[6].quoted);
}

struct Refusal {
  std::string text, complaint;
};

TEST(Yaml, RefusesWithAPlace) {
  const std::string bell = "a: 1\nb: \"\xC3\xA9 \a\"";
  const std::vector<Refusal> refusals{
      {"a: 1\nb: 2\na: 3", "3:1 duplicate key 'a', first on line 1"},
      {"{\"a\": 1, a: 2}", "1:10 duplicate key 'a', first on line 1"},
      {"a: &x {b: 1}\nc:\n  <<: *x", "3:3 the merge key '<<' is not supported; write the keys out"},
      {"a: &x [1, *x]", "1:11 an alias inside the value it stands for"},
      {"&x {a: {b: *x}}", "1:12 an alias inside the value it stands for"},
      {"a: *none", "1:4 unknown alias: no anchor of this name comes before it"},
      {"a: 1\n---\nb: 2", "2:1 a second document begins; expected one only"},
      {"a: 1\n---\n", "2:1 a second document begins; expected one only"},
      {"{a: 1} b", "1:8 text after the end of the document"},
      {"a: !custom 1", "1:4 tag '!custom' is not supported here"},
      {"a: !!binary aa==", "1:4 tag 'tag:yaml.org,2002:binary' is not supported here"},
      {"a: !thing {b: 1}", "1:4 tag '!thing' is not supported here"},
      {"a: !!map 1", "1:4 tag 'tag:yaml.org,2002:map' is not supported here"},
      {"a: !!seq {}", "1:4 tag 'tag:yaml.org,2002:seq' is not supported here"},
      {"? [a]\n: 1", "1:3 a key must be text, got a list"},
      {"? {a: 1}\n: 1", "1:3 a key must be text, got a mapping"},
      {"~: 1", "1:1 a key must be text, got nothing"},
      {"", "1:1 the document is empty"},
      {"# only a comment\n", "1:1 the document is empty"},
      {"---\n", "1:1 the document is empty"},
      {"~", "1:1 the document is empty"},
      {"a: [1, 2", "1:4 not valid YAML: the closing ']' is missing"},
      {"a:\n  {b: 1,\n   c: 2", "2:3 not valid YAML: the closing '}' is missing"},
      {"[\"a\" \"b\"]", "1:6 not valid YAML: end of sequence flow not found"},
      {"a: 'x", "1:6 not valid YAML: illegal EOF in scalar"},
      {std::string("a: 1\nb\0", 7), "2:2 a NUL byte; this is not a text file"},
      {bell, "2:7 control character 0x07"},
      {"a: \x04 b", "1:4 control character 0x04"},  // yaml-cpp takes this one for the end of the file
      {"a: \xFF", "1:4 byte 0xFF is not UTF-8 text"},
      {"a: \xC0\x80", "1:4 byte 0xC0 is not UTF-8 text"},
      {"a: \xED\xA0\x80", "1:4 byte 0xED is not UTF-8 text"},
      {"a: \xF4\x90\x80\x80", "1:4 byte 0xF4 is not UTF-8 text"},
      {"a: \xE3\x81", "1:4 byte 0xE3 is not UTF-8 text"},
  };
  for (const Refusal& refusal : refusals) EXPECT_EQ(complaints(refusal.text), refusal.complaint) << refusal.text;
}

TEST(Yaml, ReportsSeveralProblemsAtOnce) {
  EXPECT_EQ(complaints("a: 1\na: 2\nb: !x 3\nc: [1"),
            "2:1 duplicate key 'a', first on line 1\n"
            "3:4 tag '!x' is not supported here\n"
            "4:4 not valid YAML: the closing ']' is missing");
  EXPECT_EQ(parse_yaml(repeat("a: 1\n", 5000), "t").errors().size(), 100u);
}

TEST(Yaml, ReadsOnPastFlaws) {
  Diagnostics flaws;
  const auto document = parse_yaml("a: 1\na: 2\nb: !x 3\n<<: {c: 4}\nd: 5", "t", flaws);
  ASSERT_TRUE(document.ok());
  EXPECT_EQ(flaws.size(), 3u);
  EXPECT_EQ(document->root.entries.size(), 3u);
  EXPECT_EQ(find(document->root, "a")->text, "1");
  EXPECT_EQ(find(document->root, "d")->text, "5");
  EXPECT_EQ(parse_yaml("a: 1\na: [", "t", flaws).errors().size(), 2u);  // nothing to read on
  EXPECT_EQ(flaws.size(), 3u);
}

TEST(Yaml, ShowsTheLine) {
  EXPECT_EQ(errors_of(parse_yaml("a: 1\n\xC3\xA9: *b", "s.yaml")),
            "s.yaml:2:4: error: unknown alias: no anchor of this name comes before it\n    \xC3\xA9: *b\n       ^\n");
}

TEST(Yaml, BoundsDepth) {
  const auto nested = [](std::size_t depth) { return repeat("[", depth) + repeat("]", depth); };
  EXPECT_EQ(complaints(nested(yaml_max_depth)), "none");
  EXPECT_EQ(complaints(nested(yaml_max_depth + 1)), "1:65 nested more than 64 deep");
  // That many brackets must not reach the end of the stack.
  for (const char* opening : {"[", "{a: ", "- ", "? ", "[{", "{? ", "a:\n "})
    EXPECT_NE(complaints(repeat(opening, 200'000)), "none") << opening;
  // Depth that only an alias brings.
  EXPECT_EQ(complaints("a: &x " + nested(40) + "\nb: " + repeat("[", 40) + "*x" + repeat("]", 40)),
            "2:44 nested more than 64 deep");
}

TEST(Yaml, BoundsWhatAliasesExpandTo) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 10; ++i) {
    const std::string before = "*a" + std::to_string(i - 1), name = "a" + std::to_string(i);
    bomb += name + ": &" + name + " [" + repeat(before + ", ", 9) + before + "]\n";
  }
  EXPECT_EQ(complaints(bomb), "6:45 more than 1000000 values (aliases count as what they repeat)");
  EXPECT_EQ(complaints("a: &a [" + repeat("x,", 999) + "x]\nb: [" + repeat("*a,", 1000) + "*a]"),
            "2:2996 more than 1000000 values (aliases count as what they repeat)");
  EXPECT_EQ(complaints("a: &a [x, y]\nb: [" + repeat("*a,", 1000) + "*a]"), "none");
  const std::string text(1 << 20, 'x');
  EXPECT_NE(complaints("a: &a " + text + "\nb: [" + repeat("*a,", 1000) + "*a]").find("aliases repeat too much text"),
            std::string::npos);
  EXPECT_NE(complaints(repeat("&a [", 50) + repeat("x,", 100'000) + repeat("]", 50)).find("anchors hold more than"),
            std::string::npos);
}

TEST(Yaml, BoundsSize) {
  EXPECT_EQ(complaints("[" + repeat("x,", 1'000'001) + "]"),
            "1:2000000 more than 1000000 values (aliases count as what they repeat)");
  EXPECT_EQ(complaints(repeat("[", 3'000'001)), "1:3000001 more than 3000000 brackets and commas");
  EXPECT_EQ(complaints(std::string(yaml_max_bytes + 1, ' ')), "0:0 larger than 16777216 bytes");
  EXPECT_EQ(complaints(std::string(2'000'000, '\n')), "1000001:1 more than 1000000 lines");
}

TEST(Yaml, SurvivesEveryPrefixAndManySlips) {
  const std::string text =
      "%YAML 1.2\n---\na: &x [1, \"two\\u00e9\", 'th''ree', {b: c, ? d : e}]\nf: |\n  block\n   text\ng: >-\n  folded\n"
      "h: !!str 5\ni: *x\n? j\n: - k\n  - - l\n# end\n...\n";
  ASSERT_EQ(complaints(text), "none");
  for (std::size_t length = 0; length < text.size(); ++length) (void)complaints(text.substr(0, length));
  for (std::size_t at = 0; at < text.size(); ++at)
    for (char slip : {' ', '\n', '\t', '[', '}', ':', '-', '?', '&', '*', '!', '|', '"', '\'', '%', ',', '#'}) {
      std::string slipped = text;
      slipped[at] = slip;
      (void)complaints(slipped);
    }
}

TEST(YamlValues, SayWhatTheyExpect) {
  const YamlDocument document =
      parsed("[1.5, \"1.5\", .nan, -.inf, nan, 1e999, abc, [1], {a: 1}, ~, 12, true, yes, -.5]");
  const auto& items = document.root.items;
  EXPECT_EQ(*as_number(document, items[0]), 1.5);
  EXPECT_EQ(*as_number(document, items[13]), -0.5);
  EXPECT_EQ(*as_integer(document, items[10]), 12);
  EXPECT_EQ(*as_text(document, items[1]), "1.5");
  EXPECT_EQ(*as_text(document, items[10]), "12");
  EXPECT_TRUE(*as_bool(document, items[11]));
  const std::vector<std::string> got{"the text \"1.5\"", ".nan",      "-.inf",  "nan", "1e999", "abc",
                                     "a list",           "a mapping", "nothing"};
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_TRUE(fails(as_number(document, items[i + 1]), Failure::content, "expected a number, got " + got[i]));
    EXPECT_TRUE(fails(as_integer(document, items[i + 1]), Failure::content, "expected a whole number, got " + got[i]));
    EXPECT_TRUE(fails(as_bool(document, items[i + 1]), Failure::content, "expected true or false, got " + got[i]));
  }
  EXPECT_TRUE(fails(as_text(document, items[7]), Failure::content, "expected text, got a list"));
  EXPECT_TRUE(fails(as_bool(document, items[12]), Failure::content, "got yes"));
  const Diagnostic error = as_number(document, items[2], "a.b").errors()[0];
  EXPECT_EQ(error.key, "a.b");
  EXPECT_EQ(error.line, 1);
  EXPECT_EQ(error.column, 14);
  EXPECT_EQ(error.excerpt, document.lines[0]);
}

TEST(Yaml, ReadsFiles) {
  const Scratch scratch;
  EXPECT_TRUE(read_yaml(scratch.put("a.yaml",
                                    "\xEF\xBB\xBF"
                                    "a: 1")));
  EXPECT_TRUE(fails(read_yaml(scratch / "none.yaml"), Failure::file, "No such file"));
  EXPECT_TRUE(fails(read_yaml(scratch.put("b.yaml", "a: [")), Failure::content, "not valid YAML"));
}

}  // namespace
}  // namespace shabon::io
