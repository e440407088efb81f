// chart: what it refuses, and that nothing is left behind.
#include <gtest/gtest.h>

#include "chart_calls.h"
#include "shabon/io/image.h"

namespace shabon::test {
namespace {

struct Refused {
  Arguments arguments;
  int exit_code;
  std::string said;
};

const std::vector<Refused> refused = {
    {{}, 2, "expected KIND"},
    {{"newtn"}, 2, "did you mean 'newton'?"},
    {{"newton", "-o", "x.jpg"}, 2, "--output: expected a file ending in .png, .svg or .csv, got 'x.jpg'"},
    {{"newton", "-o", "x"}, 2, "--output"},
    {{"newton", "-o", "x.csv", "-o", "./x.csv"}, 2, "twice"},
    {{"newton", "-o", "none/x.png"}, 4, "none/x.png"},
    {{"newton", "-o", "x.csv", "--format", "csv"}, 2, "--format: expected without --output"},
    {{"newton", "--format", "gif"}, 2, "unknown value 'gif'"},
    {{"newton", "--dpi", "100", "--width", "500"}, 2, "--width: expected without --dpi"},
    {{"newton", "--dpi", "1e9"}, 2, "--dpi"},
    {{"newton", "--width", "1e3"}, 2, "--width"},
    {{"newton", "--retardation", "0:1um"}, 2, "--retardation: expected with michel-levy only, got it with newton"},
    {{"michel-levy", "--layer", "1"}, 2, "--layer: expected with newton, angle and profile only"},
    {{"michel-levy", "--side", "both"}, 2, "--side: expected with newton, angle and profile only"},
    {{"michel-levy", "air | water 1nm | air"}, 2, "STACK: expected with newton, angle and profile only"},
    {{"michel-levy", "--retardation", "0:1um:1mm"}, 2, "--retardation: expected at least two values"},
    {{"michel-levy", "--birefringence", "0"}, 2, "--birefringence: expected a number above 0"},
    {{"newton", "air | water"}, 2, "STACK: expected a layer"},
    {{"newton", "air | water 1nm | 1.5 2nm | air"}, 2, "--layer: expected which of the 2 layers"},
    {{"newton", "--layer", "2"}, 2, "--layer: expected a whole number from 1 to 1, got '2'"},
    {{"newton", "--layer", "0"}, 2, "--layer"},
    {{"newton", "--thickness", "5"}, 2, "--thickness: expected A:B or A:B:STEP in nm, got '5'"},
    {{"newton", "--thickness", "5:5nm"}, 2, "--thickness: expected A:B with A < B"},
    {{"newton", "--thickness", "0:5furlong"}, 2, "--thickness: expected a number"},
    {{"newton", "--thickness", "-1:5nm"}, 2, "--thickness: expected a number from 0"},
    {{"newton", "--thickness", "0:5nm:0"}, 2, "--thickness: expected a number above 0 nm"},
    {{"newton", "--thickness", "0:1m"}, 2, "--thickness"},
    {{"newton", "--thickness", "0:1cm:1nm"}, 2, "--thickness: expected at most"},
    {{"newton", "--angle", "91"}, 2, "--angle: expected a number from 0 to 90 degrees"},
    {{"newton", "--angle", "0:90:1"}, 2, "--angle: expected at most 24 strips"},
    {{"angle", "--angle", "0,30"}, 2, "--angle: expected A:B or A:B:STEP"},
    {{"angle", "--thickness", "0:2000nm:0.1nm", "--angle", "0:90:0.1"}, 2, "at most 1000000 colours"},
    {{"newton", "--model", "constant_nm: 500"}, 2, "--model: expected with profile only, got it with newton"},
    {{"angle", "--time", "3"}, 2, "--time: expected with profile only"},
    {{"profile", "--thickness", "0:1um"}, 2, "--thickness: expected with newton, angle and michel-levy only"},
    {{"profile", "--curves"}, 2, "--curves: expected with newton and angle only"},
    {{"profile", "--angle", "0,30"}, 2, "--angle: expected one angle with profile"},
    {{"profile", "--time", "-1"}, 2, "--time: expected a number from 0"},
    {{"profile", "--time", "1,2,3,4,5,6,7,8,9,10,11,12,13", "--side", "both"}, 2, "--time: expected at most 24 strips"},
    {{"profile", "--model", "{linaer: {top_nm: 1}}"}, 3, "--model:1:2: error: linaer: unknown key"},
    {{"profile", "--model", "{linear: {top_nm: -1, bottom_nm: 2}}"}, 3, "--model:1:19: error: linear.top_nm"},
    {{"profile", "--model", "{linear: {top_nm: 1}}"}, 3, "linear.bottom_nm: required key is missing"},
    {{"profile", "--model", "{linear: "}, 3, "--model:1:1: error: not valid YAML"},
    {{"profile", "--model", "linear"}, 3, "expected a mapping with keys, got linear"},
    {{"profile", "--model", "flow: {preset: drain}"}, 3, "a simulated film has to run first"},
    {{"profile", "--model", "map: {file: none.exr}"}, 4, "map.file: none.exr: cannot read"},
    {{"profile", "air | water"}, 2, "STACK: expected a layer"},
    {{"newton", "--exposure", "bright"}, 2, "--exposure: expected each, one or a number of stops"},
    {{"newton", "--adaptation", "bradfrod"}, 2, "did you mean 'bradford'?"},
    {{"newton", "--exposure", "eahc"}, 2, "did you mean 'each'?"},
    {{"newton", "--gamut", "x"}, 2, "--gamut"},
    {{"newton", "--illuminant", "D56"}, 3, "--illuminant: unknown illuminant 'D56'"},
    {{"newton", "air | watr 0nm | air"}, 3, "did you mean 'water'?"},
    {{"newton", "air | (MgF2 1nm | 1.5 0nm)^2 | air", "--layer", "1", "--interference", "two-beam"}, 3, "airy"},
};

TEST(ChartRefusals, RefusalsLeaveNothingBehind) {
  const TemporaryFolder folder;
  for (const Refused& c : refused) {
    const Outcome outcome = run(Arguments{"chart"} + c.arguments, in(folder));
    std::string shown;
    for (const std::string& argument : c.arguments) shown += " '" + argument + "'";
    EXPECT_EQ(outcome.exit_code, c.exit_code) << shown << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find(c.said), std::string::npos) << shown << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << shown;
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(ChartRefusals, DoesNotOverwriteWhatItReads) {
  const TemporaryFolder folder;
  const std::string film = "wavelength_nm,n,k\n360,1.5,0\n830,1.49,0\n", lamp = "wavelength_nm,power\n360,1\n830,2\n";
  folder.write("film.csv", film);
  folder.write("lamp.csv", lamp);
  const Arguments arguments = {"chart",        "newton",        "air | file:film.csv 0nm | air",
                               "--illuminant", "file:lamp.csv", "--thickness",
                               "0:100nm:10nm"};
  for (const char* name : {"film.csv", "lamp.csv"}) {
    const Outcome outcome = run(arguments + Arguments{"-o", name}, in(folder));
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("is an input"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(run(arguments + Arguments{"-o", "colours.csv"}, in(folder)).exit_code, 0);
  EXPECT_EQ(read_all(folder.path() / "film.csv"), film);
  EXPECT_EQ(read_all(folder.path() / "lamp.csv"), lamp);
}

TEST(ChartRefusals, DoesNotOverwriteAMapOfThickness) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> rgb = {10, 10, 10, 20, 20, 20};
  for (const char* name : {"film.0000.png", "film.0001.png"}) folder.write(name, *io::encode_png(2, 1, rgb, {}));
  const std::string before = read_all(folder.path() / "film.0001.png");
  const Arguments arguments = {
      "chart",   "profile",
      "--model", "map: {file: 'film.####.png', low_nm: 0, high_nm: 900, first_frame: 0, last_frame: 1}",
      "--time",  "0,1"};
  const Outcome outcome = run(arguments + Arguments{"-o", "film.0001.png"}, in(folder));
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("is an input"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_all(folder.path() / "film.0001.png"), before);
  EXPECT_EQ(run(arguments + Arguments{"-o", "colours.csv"}, in(folder)).exit_code, 0);
}

TEST(ChartRefusals, AFullDiskLeavesNoPartOfAFile) {
  for (const std::string& kind : kinds()) {
    const TemporaryFolder folder;
    Setting setting = in(folder);
    setting.most_file_bytes = 1000;
    EXPECT_EQ(run(quick(kind) + Arguments{"-o", "a.png"}, setting).exit_code, 4) << kind;
    EXPECT_TRUE(folder.files().empty()) << kind;
  }
}

}  // namespace
}  // namespace shabon::test
