#include "shabon/optics/stack_expression.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <string>
#include <vector>

#include "shabon/optics/media.h"

namespace shabon::optics {
namespace {

using Complex = std::complex<double>;

// Files are media too; `bad.csv` is one with an error in its second line, `gone.csv` one that cannot be opened.
Result<Medium> resolve(std::string_view name, bool is_file) {
  if (!is_file) return resolve_from_library(name, false);
  if (name == "gone.csv") return fail(Failure::file, "cannot open gone.csv");
  if (name == "bad.csv") {
    Diagnostics errors = fail(Failure::content, "expected a number");
    errors[0].source = "bad.csv";
    errors[0].line = 2;
    return errors;
  }
  return Medium::constant(9, {std::string(name), "", ""});
}

// A stack in canonical form: "1 | 1.38 99.6 | 2+0.1i 5 incoherent | 1.52".
std::string canonical(const Stack& stack) {
  std::string text = stack.incidence.name();
  for (const Layer& layer : stack.layers) {
    text += " | " + layer.medium.name() + " " + std::to_string(layer.thickness_nm);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    if (!layer.coherent) text += " incoherent";
  }
  return text + " | " + stack.exit.name();
}

struct Good {
  const char* text;
  const char* expected;
};

const Good good_expressions[] = {
    {"air | water 300nm | air", "air | water 300 | air"},
    {"1 | 1.38 99.6nm | 1.52", "1 | 1.38 99.6 | 1.52"},
    {"air|water 300nm|air", "air | water 300 | air"},
    {"  air\t|\nwater   300   nm |\r\n air ", "air | water 300 | air"},
    {"AIR | Water 300nm | vacuum", "air | water 300 | vacuum"},
    {"air | 1.5", "air | 1.5"},
    {"air | 2.4+0.01i 0.2um | 3i", "air | 2.4+0.01i 200 | 3i"},
    {"air | 2.4 + 0.01i 0.2um | 1", "air | 2.4+0.01i 200 | 1"},
    {"1 | .5+1e-3i 2e2nm | 1.5e0", "1 | 0.5+0.001i 200 | 1.5"},
    {"1 | 5.E-1+.1E+1i 1.e1nm | +1", "1 | 0.5+1i 10 | 1"},
    {"1 | 0+2i 1nm | 1.5+0i", "1 | 2i 1 | 1.5"},
    {"1 | 1.5-0i 1nm | 1", "1 | 1.5 1 | 1"},
    {"1 | 2 1um | 2 1\u00B5m | 2 1\u03BCm | 2 1mm | 2 1cm | 1",
     "1 | 2 1000 | 2 1000 | 2 1000 | 2 1000000 | 2 10000000 | 1"},
    {"air | 1.5 1 mm incoherent | air", "air | 1.5 1000000 incoherent | air"},
    {"air | 1.5 1mm Incoherent|air", "air | 1.5 1000000 incoherent | air"},
    {"1 | 1.5 0nm | 1", "1 | 1.5 0 | 1"},
    {"1 | 1.5 -0nm | 1", "1 | 1.5 0 | 1"},
    {"1 | 1.5 +3nm | 1", "1 | 1.5 3 | 1"},
    {"1 | (2 1nm | 3 2nm)^2 | 1", "1 | 2 1 | 3 2 | 2 1 | 3 2 | 1"},
    {"1 | ( 2 1nm ) ^ 3 | 1", "1 | 2 1 | 2 1 | 2 1 | 1"},
    {"1|((2 1nm)^2|3 1nm)^2|1", "1 | 2 1 | 2 1 | 3 1 | 2 1 | 2 1 | 3 1 | 1"},
    {"1|4 1nm|(2 1nm|(3 1nm)^1)^1|5 1nm incoherent|1", "1 | 4 1 | 2 1 | 3 1 | 5 1 incoherent | 1"},
    {"1|(2 1mm incoherent)^2|1", "1 | 2 1000000 incoherent | 2 1000000 incoherent | 1"},
    {"air | file:a.csv 3nm | file:\"a b.csv\"", "air | a.csv 3 | a b.csv"},
    {"air | File:/x/a(1)^2.csv 3nm | FILE:\"|)(.csv\"", "air | /x/a(1)^2.csv 3 | |)(.csv"},
    {"air | mix(water 70%, glycerol 30%) 3nm | air", "air | mix(water 70%, glycerol 30%) 3 | air"},
    {"MIX ( water 25 % ,1.5+0.1i\t75%)|( mix(file:a.csv 50%,2) 3nm)^2|1",
     "mix(water 25%, 1.5+0.1i 75%) | mix(a.csv 50%, 2 50%) 3 | mix(a.csv 50%, 2 50%) 3 | 1"},
    {"1 | mix(file:\"a, b).csv\" 33.3%, 2 33.3%, 3) 1nm | 1", "1 | mix(a, b).csv 33.3%, 2 33.3%, 3 33.4%) 1 | 1"},
    {"air | (file:a.csv 3nm)^2 | file:\u00E9.csv", "air | a.csv 3 | a.csv 3 | \u00E9.csv"},
};

TEST(StackExpression, ReadsGoodOnes) {
  for (const Good& good : good_expressions) {
    const auto stack = parse_stack(good.text, resolve);
    ASSERT_TRUE(stack.ok()) << good.text << "\n" << to_text(stack.errors());
    EXPECT_EQ(canonical(stack.value()), good.expected) << good.text;
  }
}

struct Problem {
  int column;
  const char* message;  // its beginning
};

struct Bad {
  const char* text;
  std::vector<Problem> problems;
};

constexpr const char* medium_expected = "expected a medium (a number, a name, file:PATH or mix(...)), got ";
constexpr const char* thickness_expected = "expected a thickness such as 300nm";

const std::vector<Bad> bad_expressions = {
    // the whole
    {"", {{1, "expected a stack such as 'air | water 300nm | air', got the end"}}},
    {"  \t ", {{1, "expected a stack such as"}}},
    {"air", {{4, "expected '|' and a second medium"}}},
    {"|", {{1, medium_expected}}},
    {"||||", {{1, medium_expected}}},
    {"air | | | water 3nm | | air", {{7, medium_expected}, {23, medium_expected}}},
    {"air |", {{6, "expected a medium (a number, a name, file:PATH or mix(...)), got the end"}}},
    {"air || air", {{6, "expected a medium (a number, a name, file:PATH or mix(...)), got '|'"}}},
    {"air | water 300nm | ", {{21, medium_expected}}},
    {"air | water 300nm air", {{19, "expected '|' or 'incoherent', got 'air'"}}},
    {"air water | air", {{5, "expected a thickness such as 300nm, got 'water'"}}},
    // outer media
    {"air 100nm | air", {{5, "expected no thickness: the first medium"}}},
    {"air | air 100nm", {{11, "expected no thickness: the last medium"}}},
    {"air incoherent | air", {{5, "expected a thickness such as 300nm, got 'incoherent'"}}},
    {"(1.3 1nm)^2 | air", {{1, "expected a first medium without thickness before a group"}}},
    {"air | (1.3 1nm)^2", {{18, "expected '|' and a last medium without thickness after the group, got the end"}}},
    {"2i | 1", {{1, "expected a first medium that lets light travel (n > 0), got '2i'"}}},
    // media
    {"air | watr 300nm | air", {{7, "unknown medium 'watr'; did you mean 'water'?"}}},
    {"air | watr 300nm | watr 300nm | air", {{7, "unknown medium 'watr'"}}},
    {"air | w\u00E4sser 300nm | airr", {{7, "unknown medium 'w\u00E4sser'"}, {22, "unknown medium 'airr'"}}},
    {"\u00E9 | 1", {{1, "unknown medium"}}},
    {"air | 300nm | air",
     {{7, "expected a medium (a number, a name, file:PATH or mix(...)) before the thickness, got '300nm'"}}},
    {"air | incoherent | air",
     {{7, "expected a medium (a number, a name, file:PATH or mix(...)) and a thickness before"}}},
    {"air | % 3nm | air", {{7, "expected a medium (a number, a name, file:PATH or mix(...)), got '%'"}}},
    {"air | \"a b.csv\" 3nm | air", {{7, "expected file: before a quoted path"}}},
    {"air | nan 3nm | Inf", {{7, "expected a finite index, got 'nan'"}, {17, "expected a finite index, got 'Inf'"}}},
    // numbers
    {"air | 1.5x 3nm | air", {{7, "expected a number such as 1.38 or 2.4+0.01i, got '1.5x'"}}},
    {"air | 1.2.3 3nm | air", {{7, "expected a number such as 1.38 or 2.4+0.01i, got '1.2.3'"}}},
    {"air | 0x10 3nm | air", {{7, "expected a number such as"}}},
    {"air | . 3nm | air", {{7, medium_expected}}},
    {"air | -inf 3nm | air", {{7, medium_expected}}},
    {"air | -1.5 3nm | air", {{7, "expected an index n >= 0, got '-1.5'"}}},
    {"air | 1.5-0.1i 3nm | air", {{10, "expected k >= 0 in n+ki (k > 0 absorbs), got '-0.1i'"}}},
    {"air | 1.5 - 0.1i 3nm | air", {{11, "expected k >= 0 in n+ki (k > 0 absorbs), got '-'"}}},
    {"air | -0.1i 3nm | air", {{7, "expected k >= 0 in ki (k > 0 absorbs), got '-0.1i'"}}},
    {"air | 1.5+0.1 3nm | air", {{10, "expected an imaginary part such as +0.01i, got '+0.1'"}}},
    {"air | 1.5+i 3nm | air", {{10, "expected an imaginary part such as +0.01i, got '+i'"}}},
    {"air | 1.5+-2i 3nm | air", {{10, "expected an imaginary part"}}},
    {"air | 1.5+0.1j 3nm | air", {{10, "expected an imaginary part such as +0.01i, got '+0.1j'"}}},
    {"air | 0 3nm | air", {{7, "expected an index of magnitude 0.0001..10000, got '0'"}}},
    {"air | 1e5 3nm | 1e-9", {{7, "expected an index of magnitude"}, {17, "expected an index of magnitude"}}},
    {"air | 1e999 3nm | 1+1e999i", {{7, "expected a finite number, got '1e999'"}, {20, "expected a finite number"}}},
    // thicknesses
    {"air | water | air", {{12, "expected a thickness such as 300nm after the medium"}}},
    {"air | 1.3 | air", {{10, thickness_expected}}},
    {"air | water incoherent | air", {{13, "expected a thickness such as 300nm, got 'incoherent'"}}},
    {"air | water 300 | air", {{17, "expected a unit of length (nm, um, \u00B5m, mm or cm) after 300, got '|'"}}},
    {"air | water 300 m | air", {{17, "expected a unit of length (nm, um, \u00B5m, mm or cm) after 300, got 'm'"}}},
    {"air | water 300NM | air", {{16, "expected a unit of length"}}},
    {"air | water 300", {{16, "expected a unit of length (nm, um, \u00B5m, mm or cm) after 300, got the end"}}},
    {"air | water -3nm | air", {{13, "expected a thickness >= 0, got '-3nm'"}}},
    {"air | 1.3 -3nm | air", {{11, "expected a thickness >= 0, got '-3nm'"}}},
    {"air | water nan nm | air", {{13, "expected a thickness such as 300nm, got 'nan'"}}},
    {"air | water inf | air", {{13, "expected a thickness such as 300nm, got 'inf'"}}},
    {"air | water 1e999nm | air", {{13, "expected a finite thickness, got '1e999nm'"}}},
    {"air | water 101cm | air", {{13, "expected a thickness of at most 1 m"}}},
    {"air | water 1e300cm | air", {{13, "expected a thickness of at most 1 m"}}},
    {"air | water 1e308cm | air", {{13, "expected a thickness of at most 1 m"}}},
    {"air | water + | air", {{13, thickness_expected}}},
    {"air | water 300nm2 | air", {{18, "expected '|', got '2'"}}},
    {"air | water 300nm incoherently | air", {{19, "expected '|' or 'incoherent', got 'incoherently'"}}},
    {"air | water 300nm incoherent twice | air", {{30, "expected '|', got 'twice'"}}},
    // groups
    {"air | (1.3 1nm) | air", {{17, "expected '^' and a count 1..1000 after ')', got '|'"}}},
    {"air | (1.3 1nm)^ | air", {{18, "expected a whole number 1..1000 after '^', got '|'"}}},
    {"air | (1.3 1nm)^0 | air", {{17, "expected a whole number 1..1000 after '^', got '0'"}}},
    {"air | (1.3 1nm)^1001 | air", {{17, "expected a whole number 1..1000"}}},
    {"air | (1.3 1nm)^-2 | air", {{17, "expected a whole number 1..1000"}}},
    {"air | (1.3 1nm)^2.5 | air", {{17, "expected a whole number 1..1000 after '^', got '2.5'"}}},
    {"air | (1.3 1nm)^99999999999999999999 | air", {{17, "expected a whole number 1..1000"}}},
    {"air | (1.3)^2 | air", {{11, thickness_expected}}},
    {"air | ()^2 | air", {{8, "expected a medium (a number, a name, file:PATH or mix(...)), got ')'"}}},
    {"air | (1.3 1nm | )^2 | air", {{18, medium_expected}}},
    {"air | (1.3 1nm | air", {{7, "expected ')' to close this '('"}, {21, thickness_expected}}},
    {"air | ((((1.3 1nm | air", {{7, "expected ')' to close this '(' and 3 more within it"}, {24, thickness_expected}}},
    {"((((((1.33 300nm))))))",
     {{1, "expected a first medium without thickness before a group"},
      {18, "expected '^' and a count 1..1000 after ')'"}}},
    {"air | ((1.3 1nm)) | (1.4 1nm) | air", {{17, "expected '^' and a count"}, {31, "expected '^' and a count"}}},
    {"air | 1.3 1nm)))) | air", {{14, "expected '(' before this ')'"}}},
    {"air | 1.3 1nm)^2 | air", {{14, "expected '(' before this ')'"}}},
    {"air | (1.3 1nm)^2 1.4 1nm | air", {{19, "expected '|', got '1.4'"}}},
    {"air | 1.4 1nm (1.3 1nm)^2 | air", {{15, "expected '|', got '('"}}},
    {"air | 1.4^2 1nm | air", {{10, "expected a thickness such as 300nm, got '^'"}}},
    {"air | ((1.3 1nm)^1000)^11 | air", {{23, "expected at most 10000 layers, got 11000"}}},
    // files
    {"air | file: 3nm | air", {{12, "expected a path after file:"}}},
    {"air | file:\"\" 3nm | air", {{12, "expected a path after file:"}}},
    {"air | file:\"a b.csv 3nm | air", {{12, "expected '\"' to close the path that starts here"}}},
    {"air | file:\"a\"b 3nm | air", {{15, "expected white space or '|' after the path, got 'b'"}}},
    {"air | file:gone.csv 3nm | air", {{12, "cannot open gone.csv"}}},
    // mixtures
    {"air | mix(water 70%, glycerol 20%) 3nm | air",
     {{7, "expected shares that make up 100%, got 90%; the last part may leave its share out"}}},
    {"air | mix(water 70%, glycerol 40%, 1.5) 3nm | air", {{7, "expected shares that make up 100%, got 110%"}}},
    {"air | mix(water 70%, glycerl 30%) 3nm | air", {{22, "unknown medium 'glycerl'; did you mean 'glycerol'?"}}},
    {"air | mix(watr 70%, glycerl 30%) 3nm | air", {{11, "unknown medium 'watr'"}, {21, "unknown medium 'glycerl'"}}},
    {"air | mix(water, glycerol 30%) 3nm | air", {{16, "expected a share of the volume such as 70%, got ','"}}},
    {"air | mix(water) 3nm | air", {{16, "expected a share of the volume such as 70%, got ')'"}}},
    {"air | mix(water 70, glycerol 30%) 3nm | air", {{19, "expected '%' after the share, got ','"}}},
    {"air | mix(water 170%, 1.5 -70%) 3nm | air", {{17, "expected a share of 0..100%, got '170%'"}}},
    {"air | mix() 3nm | air", {{11, "expected a medium (a number, a name, file:PATH or mix(...)), got ')'"}}},
    {"air | mix(water 70% glycerol 30%) 3nm | air", {{21, "expected ',' or ')', got 'glycerol'"}}},
    {"air | mix(water 70%, glycerol 30% 3nm | air", {{35, "expected ',' or ')', got '3nm'"}}},
    {"air | mix(water 70%, glycerol 30%", {{10, "expected ')' to close the mixture that starts here"}}},
    {"air | mix(water 50%, mix(water 50%, 1.5) ) 3nm | air", {{22, "expected no mixture within a mixture"}}},
    {"air | mix(water 70%, glycerol 30%) | air", {{35, thickness_expected}}},
    {"air | mix 3nm | air", {{7, "unknown medium 'mix'"}}},
    {"Q | 1", {{1, "unknown medium 'Q'; known: vacuum, air,"}}},
    // several at once
    {"air | watr 300 | -1 5nm | 1.3 | air 4nm",
     {{7, "unknown medium"},
      {16, "expected a unit"},
      {18, "expected an index n >= 0"},
      {30, thickness_expected},
      {37, "expected no thickness"}}},
};

TEST(StackExpression, PlacesEveryProblem) {
  for (const Bad& bad : bad_expressions) {
    const auto stack = parse_stack(bad.text, resolve);
    ASSERT_FALSE(stack.ok()) << bad.text;
    const Diagnostics& errors = stack.errors();
    ASSERT_EQ(errors.size(), bad.problems.size()) << bad.text << "\n" << to_text(errors);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      EXPECT_EQ(errors[i].column, bad.problems[i].column) << to_text(errors);
      EXPECT_EQ(errors[i].message.rfind(bad.problems[i].message, 0), 0u) << to_text(errors);
      EXPECT_EQ(errors[i].source, "<stack>");
      EXPECT_EQ(errors[i].line, 1);
      EXPECT_EQ(errors[i].excerpt, bad.text);
    }
  }
}

TEST(StackExpression, ProblemsOfFilesKeepTheirPlaceAndKind) {
  const auto bad = parse_stack("air | file:bad.csv 3nm | watr", resolve);
  ASSERT_EQ(bad.errors().size(), 2u);
  EXPECT_EQ(bad.errors()[0].source, "bad.csv");
  EXPECT_EQ(bad.errors()[0].line, 2);
  EXPECT_EQ(bad.errors()[1].column, 26);
  EXPECT_EQ(parse_stack("air | file:gone.csv", resolve).errors()[0].failure, Failure::file);
  EXPECT_FALSE(parse_stack("air | file:a.csv").ok());  // the library alone knows no files
}

TEST(StackExpression, AsksForEachNameOnce) {
  int calls = 0;
  const auto counting = [&](std::string_view name, bool is_file) {
    ++calls;
    return resolve(name, is_file);
  };
  ASSERT_TRUE(parse_stack("air | (water 1nm | file:a.csv 2nm | file:water 1nm)^3 | water 1nm | air", counting).ok());
  EXPECT_EQ(calls, 4);
}

TEST(StackExpression, TenThousandLayers) {
  EXPECT_EQ(parse_stack("1 | ((2 1nm | 3 1nm)^1000)^5 | 1")->layers.size(), 10'000u);
  EXPECT_FALSE(parse_stack("1 | ((2 1nm | 3 1nm)^1000)^5 | 2 1nm | 1").ok());
}

std::string repeated(std::string_view part, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += part;
  return text;
}

// Nothing a stranger sends takes long, exhausts memory or the call stack, or lists problems without end.
TEST(StackExpression, HostileTexts) {
  const std::vector<std::string> texts = {
      std::string(100'000'000, '('),
      std::string(1'000'000, '('),
      std::string(1'000'000, ')'),
      std::string(1'000'000, '|'),
      std::string(1'000'000, '^'),
      std::string(1'000'000, '9') + " | 1",
      std::string(1'000'000, 'a'),
      std::string(1'000'000, '\xFF'),
      std::string(1'000'000, '\0'),
      repeated("1|", 500'000),
      repeated("1 1nm|", 150'000),
      repeated("1 |", 300'000) + "x",
      "1|" + repeated("(", 100) + "2 1nm" + repeated(")^1000", 100) + "|1",
      "1|" + repeated("(", 101) + "2 1nm" + repeated(")^1", 101) + "|1",
      "1|" + repeated("(1 1nm|", 90) + "2 1nm" + repeated(")^1000", 90) + "|1",
      "1|file:\"" + std::string(1'000'000, 'x'),
      "1|" + repeated("a 1nm|b 1nm|", 80'000) + "1",
      "1e" + std::string(1'000'000, '9') + " | 1",
  };
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& text : texts) {
    const auto stack = parse_stack(text);
    ASSERT_FALSE(stack.ok()) << text.substr(0, 40);
    EXPECT_LE(stack.errors().size(), 21u);
    for (const Diagnostic& error : stack.errors()) EXPECT_LT(error.message.size(), 300u) << text.substr(0, 40);
  }
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 10);
}

// Every prefix and every text with one character replaced gives a stack or placed problems.
TEST(StackExpression, MutilatedTexts) {
  const std::string text = "air | (2.4+0.01i 0.2um | file:\"a b\" 3 nm incoherent)^10 | water";
  const std::string characters = std::string("|()^+-.0e i\"\xC2n", 14) + '\0';
  const auto check = [](const std::string& mutilated) {
    const auto stack = parse_stack(mutilated, resolve);
    if (stack.ok()) return;
    ASSERT_FALSE(stack.errors().empty());
    for (const Diagnostic& error : stack.errors()) {
      EXPECT_GE(error.column, 1) << mutilated;
      EXPECT_LE(error.column, static_cast<int>(mutilated.size()) + 1) << mutilated;
    }
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    check(text.substr(0, i));
    for (char c : characters) {
      std::string mutilated = text;
      mutilated[i] = c;
      check(mutilated);
    }
  }
}

// Random changes, several at a time: always a stack or at least one placed problem, never many for a short text.
TEST(StackExpression, RandomlyMutatedTexts) {
  const std::vector<std::string> texts = {
      "air | (2.4+0.01i 0.2um | file:\"a b\" 3 nm incoherent)^10 | water",
      "air | mix(water 70%, glycerol 30%) 300nm | mix(1.5+0.1i 20%, file:a.csv 30%, SiO2) 1mm incoherent | N-BK7",
      "1 | ((ZnS 58nm | MgF2 99nm)^3 | mix(water 50%, 2i) 1nm)^2 | Al2O3"};
  const std::string pool = "|()^+-.0159eEi \t\",%:nmuwatrmixfile\xC2\xB5\xFF";
  std::mt19937 random(20240511);
  const auto below = [&](std::size_t n) { return random() % n; };
  int good = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string text = texts[below(texts.size())];
    for (std::size_t change = 1 + below(4); change > 0 && !text.empty(); --change) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text.erase(at, 1 + below(5));
          break;
        case 1:
          text.insert(at, 1, pool[below(pool.size())]);
          break;
        case 2:
          text[at] = pool[below(pool.size())];
          break;
        default:
          text.insert(at, text.substr(below(text.size()), 1 + below(12)));
      }
    }
    const auto stack = parse_stack(text, resolve);
    if (stack.ok()) {
      ++good;
      continue;
    }
    ASSERT_FALSE(stack.errors().empty()) << text;
    EXPECT_LE(stack.errors().size(), 20u) << text << "\n" << to_text(stack.errors());
    for (const Diagnostic& error : stack.errors()) {
      EXPECT_GE(error.column, 1) << text;
      EXPECT_LE(error.column, static_cast<int>(text.size()) + 1) << text;
    }
  }
  EXPECT_GT(good, 200);
}

TEST(StackExpression, OneMediumAlone) {
  EXPECT_EQ(parse_medium(" Water ")->name(), "water");
  EXPECT_EQ(parse_medium("2.4 + 0.1i")->index(500), Complex(2.4, 0.1));
  EXPECT_EQ(parse_medium("mix(water 70%, glycerol)")->name(), "mix(water 70%, glycerol 30%)");
  EXPECT_EQ(parse_medium("file:\"a b\"", resolve)->name(), "a b");
  for (const char* text : {"", "  ", "watr", "water 300nm", "water | air", "mix(water", "%", "1.5x", "file:gone.csv"}) {
    const auto medium = parse_medium(text, resolve);
    ASSERT_FALSE(medium.ok()) << text;
    EXPECT_EQ(medium.errors().size(), 1u) << text << "\n" << to_text(medium.errors());
  }
}

}  // namespace
}  // namespace shabon::optics
