// Measured spectra from files.
#include "shabon/api/spectrum_file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "shabon/base/text.h"

namespace shabon::api {
namespace {

using desk::Quantity;

Result<desk::MeasuredSpectrum> read(const std::string& text, const SpectrumFileOptions& options = {}) {
  std::string pattern = (std::filesystem::temp_directory_path() / "shabon-spectrum-XXXXXX").string();
  const char* folder = ::mkdtemp(pattern.data());
  if (folder == nullptr) return fail(Failure::file, "no folder");
  const std::filesystem::path path = std::filesystem::path(folder) / "a.csv";
  std::ofstream(path, std::ios::binary) << text;
  Result<desk::MeasuredSpectrum> result = read_spectrum_file(path, options);
  std::filesystem::remove_all(folder);
  return result;
}

// "R,T: 400 0 0.5 0.1; 500 ..." with wavelength, angle and shares.
std::string shown(const Result<desk::MeasuredSpectrum>& spectrum) {
  if (!spectrum) return to_text(spectrum.errors().front());
  std::string text;
  for (const Quantity quantity : spectrum->quantities)
    text += (text.empty() ? "" : ",") + std::string(desk::quantities()[static_cast<std::size_t>(quantity)].name);
  for (const desk::MeasuredRow& row : spectrum->rows) {
    text += "; " + format_number(row.wavelength_nm, 6) + " " + format_number(row.incidence_deg, 6);
    for (const double share : row.shares) text += " " + format_number(share, 6);
  }
  return text;
}

TEST(SpectrumFile, ReadsWhatPeopleWrite) {
  const std::string two = "R; 400 0 0.5; 500 0 0.25";
  const char* texts[] = {
      "wavelength_nm,R\n400,0.5\n500,0.25\n",
      "# a comment\nWavelength (nm), Reflectance\n400, 0.5\n500, 0.25\n",
      "R (%),lambda_nm\n50,400\n25,500\n",
      "lambda,r_percent\n400,50\n500,25\n",
      "wavelength_um,R,remark\n0.4,0.5,7\n0.5,0.25,8\n",
      "400,0.5\n500,0.25\n",
      "# as Excel writes it, here\nWavelength (nm);R\n400;0,5\n500;0,25\n",
      "400;0,5\r\n500;0,25\r\n",
      "nm;R\n400;0.5\n500;0.25\n",
      "nm\tR (%)\n400\t50,0\n500\t25\n",
  };
  for (const char* text : texts) EXPECT_EQ(shown(read(text)), two) << text;
  EXPECT_EQ(shown(read("nm,R\n400,50\n500,25\n", {{}, true, 0})), two);
  EXPECT_EQ(shown(read("nm,T_s\n500,0.3\n400,-0.01\n", {{}, false, 55})), "T_s; 500 55 0.3; 400 55 -0.01");
  EXPECT_EQ(shown(read("400,0.5\n", {{Quantity::T}, false, 0})), "T; 400 0 0.5");
  EXPECT_EQ(shown(read("angle_deg,nm,R_s,R_p\n20,400,0.5,0.4\n60,400,0.6,0.1\n")),
            "R_s,R_p; 400 20 0.5 0.4; 400 60 0.6 0.1");
}

TEST(SpectrumFile, TellsItsDigitsAndWhetherItHasAngles) {
  EXPECT_EQ(read("nm,R\n400,0.5\n500,0.25\n")->step, 0.01);
  EXPECT_EQ(read("nm,R\n400,5e-1\n500,2.5e-1\n")->step, 0.01);
  EXPECT_DOUBLE_EQ(read("nm,R%\n400,50\n500,25.5\n")->step, 0.001);
  EXPECT_EQ(read("nm,R,T\n400,0,0.125\n500,0,0.2\n")->step, 0.001);
  EXPECT_EQ(read("nm,R\n400,0\n500,1\n")->step, 0);
  EXPECT_FALSE(read("nm,R\n400,0.5\n")->has_angles);
  EXPECT_TRUE(read("nm,R,angle_deg\n400,0.5,0\n")->has_angles);
}

TEST(SpectrumFile, CountsNothingTwice) {
  const char* text = "wavelength_nm,R,R_s,R_p,T,A_s\n400,0.45,0.5,0.4,0.1,0\n";
  EXPECT_EQ(shown(read(text)), "R_s,R_p,T; 400 0 0.5 0.4 0.1");
  EXPECT_EQ(shown(read(text, {{Quantity::T, Quantity::R}, false, 0})), "R,T; 400 0 0.45 0.1");
}

TEST(SpectrumFile, ProblemsHaveAPlace) {
  const std::pair<const char*, const char*> broken[] = {
      {"nm,I\n400,0.5\n",
       "a.csv:1:1: error: expected the columns wavelength_nm and R, R_s, R_p, T, T_s or T_p, got nm, I"},
      {"R,T\n0.1,0.5\n", "a.csv:1:1: error: expected the columns wavelength_nm and R"},
      {"400,0.5,0.4\n", "a.csv:1:1: error: expected the columns wavelength_nm and R, R_s, R_p, T, T_s or T_p, or two"},
      {"nm,R\n400,x\n", "a.csv:2:5: error: expected a number, got 'x'"},
      {"nm,R\n400,0.4\n500,41\n",
       "a.csv:3:5: error: expected a share of the incident light, 0..1, got 41: is it in per"},
      {"nm,R%\n400,4000\n", "a.csv:2:5: error: expected a share of the incident light, 0..1, got 4000 %"},
      {"nm,R\n400,-0.9\n", "a.csv:2:5: error: expected a share of the incident light"},
      {"nm,R\n-400,0.9\n", "a.csv:2:1: error: expected a wavelength > 0 nm"},
      {"nm,R,angle\n400,0.9,91\n", "a.csv:2:9: error: expected an angle of 0..90 degrees, got 91"},
      {"nm,R\n0.4,0.9\n", "a.csv:2:1: error: expected wavelengths in nm; the longest is 0.4: are they micrometres?"},
      {"nm,R,reflectance\n400,0.4,0.4\n",
       "a.csv:1:6: error: expected one column for each share, got 'reflectance' as a se"},
      {"# of a wafer\n\nnm,I\n400,0.5\n", "a.csv:3:1: error: expected the columns"},
      {"R,wavelength_um\n0.3,700\n0.2,400\n",
       "a.csv:3:5: error: expected wavelengths in micrometres; the shortest is 400"},
      {"nm;R\n400;0,5x\n", "a.csv:2:5: error: expected a number, got '0.5x'"},
      {"nm;R\n400;0;5\n", "a.csv:2:7: error: expected 2 cells, got 3"},
  };
  for (const auto& [text, message] : broken) {
    const std::string said = shown(read(text));
    EXPECT_NE(said.find(message), std::string::npos) << text << said;
  }
  std::string huge = "nm,R\n";
  for (int i = 0; i < 20'001; ++i) huge += std::to_string(400 + i) + ",0.4\n";
  EXPECT_NE(shown(read(huge.c_str())).find("a.csv:20002:1: error: expected at most 20000 rows, got 20001"),
            std::string::npos);
  EXPECT_NE(shown(read("nm,R\n400,0.4\n", {{Quantity::T}, false, 0})).find("R"), std::string::npos);
  EXPECT_NE(shown(read("nm,R,T\n400,0.4,0.1\n", {{Quantity::R, Quantity::T_s}, false, 0}))
                .find("expected a column T_s, got none"),
            std::string::npos);
  const auto gone = read_spectrum_file("/nonexistent/a.csv");
  ASSERT_FALSE(gone.ok());
  EXPECT_EQ(gone.errors().front().failure, Failure::file);
}

}  // namespace
}  // namespace shabon::api
