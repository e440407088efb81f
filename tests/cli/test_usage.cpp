// Flags, ranges, help, and what a failing standard output does: every exit code but those of a scene.
#include <gtest/gtest.h>

#include "child.h"
#include "shabon/api/version.h"
#include "shabon/base/text.h"

namespace shabon::test {
namespace {

const std::string film = "air | water 300nm | air";
const std::vector<std::string> command_names = {"render", "probe", "spectrum", "color", "chart", "media", "lamps"};

struct Case {
  std::vector<std::string> arguments;
  int exit_code;
  std::string said;  // a part of standard error
};

std::string shown(const std::vector<std::string>& arguments) {
  std::string text = "shabon";
  for (const std::string& argument : arguments) text += " '" + argument + "'";
  return text;
}

const std::vector<Case> usage_errors = {
    {{}, 2, "a command is needed"},
    {{"spectrm", film}, 2, "did you mean 'spectrum'?"},
    {{"xyzzy"}, 2, "unknown command 'xyzzy'"},
    {{"--colour"}, 2, "--colour"},
    {{"--quiet", "render"}, 2, "the options of a command stand after its name"},
    {{"spectrum"}, 2, "expected STACK: Stack expression, such as 'air | water 300nm | air'"},
    {{"spectrum", film, "--angel", "3"}, 2, "did you mean '--angle'?"},
    {{"spectrum", "air", "|", "water"}, 2, "needs quotes"},
    {{"spectrum", film, "--", "--angle", "3"}, 2, "--angle stands after '--', where no option is"},
    {{"spectrum", film, "--angle"}, 2, "--angle: expected LIST after it, got nothing"},
    {{"spectrum", film, "--angle", "90.001"}, 2, "expected a number from 0 to 90 degrees, got '90.001'"},
    {{"spectrum", film, "--angle", "-.5"}, 2, "got '-0.5'"},
    {{"spectrum", film, "--angle", "0,30,x"}, 2, "got 'x'"},
    {{"spectrum", film, "--angle", "nan"}, 2, "got 'nan'"},
    {{"spectrum", film, "--angle", ""}, 2, "got ''"},
    {{"spectrum", film, "--angle="}, 2, "--angle: expected a value after '=', got nothing"},
    {{"spectrum", film, "--angle", "0x10"}, 2, "got '0x10'"},
    {{"spectrum", film, "--angle", "45,5 "}, 0, ""},
    {{"spectrum", film, "--wavelengths", "360:830"}, 2, "A:B:STEP"},
    {{"spectrum", film, "--wavelengths", "830:360:5"}, 2, "A <= B"},
    {{"spectrum", film, "--wavelengths", "360:830:0"}, 2, "a number above 0 nm"},
    {{"spectrum", film, "--wavelengths", "360:830:-5"}, 2, "a number above 0 nm"},
    {{"spectrum", film, "--wavelengths", "0"}, 2, "got '0'"},
    {{"spectrum", film, "--wavelengths", "400,,500"}, 2, "got ''"},
    {{"spectrum", film, "--wavelengths", "1:1000000:1e-9"}, 2, "at most"},
    {{"spectrum", film, "--wavelengths", "400:500:0.0002", "--angle",
      "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17,18,19,20,21"},
     2,
     "at most"},
    {{"spectrum", film, "--wavelengths", "400", "--wavelengths", "500"},
     2,
     "--wavelengths: expected LIST once, got '400' and '500'"},
    {{"spectrum", film, "--format", "xml"}, 2, "unknown value 'xml'; known: csv, text, json, svg"},
    {{"spectrum", film, "--interference", "airi"}, 2, "did you mean 'airy'?"},
    {{"color", film, "--illuminant", "D56"}, 3, "unknown illuminant 'D56'; did you mean 'D"},
    {{"color", film, "--illuminant", "Q"}, 3, "'Q'; known: "},
    {{"color", film, "--illuminant", "candle"}, 3, "'candle'; known: "},
    {{"color", film, "--illuminant", "blackbody:0K"}, 3, "a temperature from"},
    {{"color", film, "--space", "Rec709"}, 2, "unknown colour space 'Rec709'"},
    {{"color", film, "--adapt", "bradfort"}, 2, "did you mean 'bradford'?"},
    {{"color", film, "--gamut", "clap"}, 2, "did you mean 'clip'?"},
    {{"color", film, "--observer", "1924"}, 2, "unknown value '1924'"},
    {{"color", film, "--angle", "91"}, 2, "0 to 90 degrees"},
    {{"color", film, "extra"}, 2, "unexpected argument 'extra'"},
    {{"color", film, "--format", "xml"}, 2, "unknown value 'xml'; known: text, json, csv, svg"},
    {{"media", "--format", "svg"}, 2, "unknown value 'svg'"},
    {{"probe", "--pixel"}, 2, "--pixel: expected X Y after it, got nothing"},
    {{"probe", "--pixel", "1"}, 2, "--pixel: expected X Y, got only '1'"},
    {{"probe", "--pixel", "1", "2", "--pixel", "3"}, 2, "--pixel: expected X Y once, got '1', '2' and '3'"},
    {{"probe", "--pixel", "1", "1", "--ray", "0", "0", "5", "0", "0", "-1"},
     2,
     "expected only one of --pixel and --ray, got both"},
    {{"render", "--quiet=7"}, 2, "--quiet: expected no value"},
    {{"render", "--stats", "--quiet"}, 2, "--stats: expected FILE.json, got the option '--quiet'"},
    {{"render", ""}, 2, "SCENE: expected a value, got an empty text"},
    {{"render", "--stats", ""}, 2, "--stats: expected a value, got an empty text"},
    {{"--", "render"}, 2, "a command is needed"},
    {{"spectrum", film, "--wavelengths", "400:500"}, 2, "expected A:B:STEP or L1,L2,..., got 2 numbers"},
    {{"spectrum", film, "--wavelengths", "500:400:10"}, 2, "expected A:B:STEP with A <= B, got 500:400"},
    {{"render", "--set"}, 2, "--set: expected PATH=VALUE after it, got nothing"},
    {{"render", "--seed", "9223372036854775808"}, 2, "expected a whole number of at least 0, below 2^63"},
    {{"render", "--threads", "1.5"}, 2, "expected a whole number from 1 to 1024, got '1.5'"},
    {{"render", "--size", "3x"}, 2, "expected WxH such as 800x600, got '3x'"},
    {{"render", "--size", "65536x65536"}, 2, "expected at most 2^28 pixels, got 4294967296"},
};

TEST(Usage, WrongFlagsEndWithTwo) {
  for (const Case& c : usage_errors) {
    const Outcome outcome = run(c.arguments);
    EXPECT_EQ(outcome.exit_code, c.exit_code) << shown(c.arguments) << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(c.said), std::string::npos) << shown(c.arguments) << "\n" << outcome.err;
    if (c.exit_code != 0) {
      EXPECT_EQ(outcome.out, "") << shown(c.arguments);
    }
  }
}

// What the parser of arguments says by itself names neither what came nor what was expected.
TEST(Usage, NoMessageIsThatOfTheParser) {
  const std::vector<std::string> words = {"required", "missing",       "excludes",  "At Most",  "At least",
                                          "Expected", "were expected", "Could not", "override", "cannot be understood"};
  for (const Case& c : usage_errors) {
    const std::string said = run(c.arguments).err;
    for (const std::string& word : words) EXPECT_EQ(said.find(word), std::string::npos) << shown(c.arguments) << said;
  }
}

TEST(Usage, WrongFlagsNameTheHelpOfTheirCommand) {
  EXPECT_NE(run({"color", film, "--angle", "91"}).err.find("'shabon color --help'"), std::string::npos);
  EXPECT_NE(run({"color", film, "--angle="}).err.find("'shabon color --help'"), std::string::npos);
}

const std::vector<Case> content_errors = {
    {{"spectrum", ""}, 3, "<stack>"},
    {{"spectrum", "air | watr 300nm | air"}, 3, "did you mean 'water'?"},
    {{"spectrum", "air | water | air"}, 3, "<stack>:1:"},
    {{"spectrum", "air | 1.3-0.1i 3nm | air"}, 3, "<stack>:1:"},
    {{"color", "air | water -3nm | air"}, 3, "<stack>:1:"},
    {{"spectrum", "air | water 3nm | 1.5 4nm | air", "--interference", "none"}, 3, "got 2; use airy"},
    {{"spectrum", "air | (1.5 3nm | 1.3 4nm)^5 | air", "--interference", "two-beam"}, 3, "use airy"},
    {{"color", "air | water 3nm | 1.5 4nm | air", "--interference", "two-beam"}, 3, "use airy"},
    {{"spectrum", "air | file:nothing-here.csv 3nm | air"}, 4, "nothing-here.csv"},
};

TEST(Usage, WrongStacksEndWithThree) {
  for (const Case& c : content_errors) {
    for (const char* command : {"spectrum", "color"}) {
      std::vector<std::string> arguments = c.arguments;
      arguments[0] = command;
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.exit_code, c.exit_code) << shown(arguments) << "\n" << outcome.err;
      EXPECT_NE(outcome.err.find(c.said), std::string::npos) << shown(arguments) << "\n" << outcome.err;
      EXPECT_EQ(outcome.out, "") << shown(arguments);
    }
  }
}

TEST(Usage, HelpHasExamplesAndGoesToStandardOutput) {
  const Outcome top = run({"--help"});
  EXPECT_EQ(top.exit_code, 0);
  EXPECT_EQ(top.err, "");
  for (const std::string& name : command_names) {
    EXPECT_NE(top.out.find(name), std::string::npos) << name;
    const Outcome help = run({name, "--help"});
    EXPECT_EQ(help.exit_code, 0) << name;
    EXPECT_EQ(help.err, "") << name;
    EXPECT_NE(help.out.find("Example"), std::string::npos) << name;
    EXPECT_NE(help.out.find("shabon " + name), std::string::npos) << name;
    EXPECT_EQ(run({name, "-h"}).out, help.out) << name;
  }
}

TEST(Usage, VersionIsThatOfTheLibrary) {
  const Outcome outcome = run({"--version"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, "shabon " + std::string(version()) + "\n");
}

TEST(Usage, StandardOutputThatTakesNothingEndsWithFour) {
  const std::vector<std::vector<std::string>> printing = {
      {"--help"}, {"--version"}, {"spectrum", film}, {"color", film}, {"media"}, {"lamps"}, {"spectrum", "--help"}};
  using Output = Setting::Output;
  for (const std::vector<std::string>& arguments : printing) {
    for (const Output output : {Output::device_full, Output::closed_pipe, Output::closed}) {
      Setting setting;
      setting.output = output;
      const Outcome outcome = run(arguments, setting);
      EXPECT_EQ(outcome.exit_code, 4) << shown(arguments) << static_cast<int>(output);
      EXPECT_NE(outcome.err.find("cannot write to standard output"), std::string::npos) << shown(arguments);
    }
  }
}

TEST(Usage, NumbersIgnoreTheLocale) {
  Setting setting;
  setting.environment = {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE.UTF-8"}};
  EXPECT_EQ(run({"spectrum", film}, setting).out, run({"spectrum", film}).out);
}

}  // namespace
}  // namespace shabon::test
