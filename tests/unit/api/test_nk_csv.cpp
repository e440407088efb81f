#include <complex>

#include "nk_case.h"

namespace shabon::api {
namespace {

using Complex = std::complex<double>;

TEST(NkCsv, ColumnsByNameInAnyOrder) {
  const NkFolder folder;
  const char* texts[] = {
      "wavelength_nm,n,k\n400,1.5,0\n600,1.7,0.2\n",
      "k,n,lambda_nm\n0,1.5,400\n0.2,1.7,600\n",
      "# a comment\n\nWavelength (nm), N , K\n400, 1.5, 0\n600, 1.7, 0.2\n",
      "\"wavelength [nm]\",refractive_index,extinction coefficient\r\n400,1.5,0\r\n600,1.7,0.2\r\n",
      "wavelength_um,n,k\n0.4,1.5,0\n0.6,1.7,0.2\n",
      "wl_um,n,k\n0.4,1.5,0\n0.6,1.7,0.2\n",
      "wl,n,k\n0.4,1.5,0\n0.6,1.7,0.2\n",
      "\xEF\xBB\xBFwavelength (\u00B5m),n,k\n0.4,1.5,0\n0.6,1.7,0.2\n",
      "lambda,n,k\n400,1.5,0\n600,1.7,0.2\n",
      "400,1.5,0\n600,1.7,0.2\n",
  };
  for (const char* text : texts) {
    const auto medium = folder.read("a.csv", text);
    ASSERT_TRUE(medium.ok()) << text << to_text(medium.errors());
    EXPECT_NEAR(std::abs(medium->index(500) - Complex(1.6, 0.1)), 0, 1e-12) << text;
    EXPECT_EQ(medium->name(), "a.csv");
  }
  const auto transparent = folder.read("b.txt", "# whose: mine\nnm,n\n400,1.5\n600,1.7\n");
  ASSERT_TRUE(transparent.ok());
  EXPECT_TRUE(transparent->is_lossless());
  EXPECT_EQ(transparent->source(), "whose: mine");
  EXPECT_EQ(transparent->range_nm(), (optics::WavelengthRange{400, 600}));
}

// As spreadsheets of many countries write tables; what stands in them can mean one thing only.
TEST(NkCsv, OtherSeparatorsAndDecimalCommas) {
  const NkFolder folder;
  const char* texts[] = {
      "wavelength_nm;n;k\n400;1,5;0\n600;1,7;0,2\n",
      "wavelength_nm;n;k\n400;1.5;0\n600;1.7;0.2\n",
      "# mine; not yours\nWavelength, nm; n; k\r\n400,0; 1,5; 0,0\r\n600,0; 1,7; 2,0E-1\r\n",
      "400;1,5;0\n600;1,7;0,2\n",
      "wl\tn\tk\n0,4\t1,5\t0\n0,6\t1,7\t0,2\n",
      "nm\t\tn\t\tk\n400\t\t1.5\t\t0\n600\t\t1.7\t\t0.2\n",
      "nm,\tn,\tk\n400,\t1.5,\t0\n600,\t1.7,\t0.2\n",
      "nm,n,k\n400,1,0\n600,2,0\n",  // whole numbers, told by a header
      "400,1,0\n600,2,0\n",
  };
  for (const char* text : texts) {
    const auto medium = folder.read("a.csv", text);
    ASSERT_TRUE(medium.ok()) << text << to_text(medium.errors());
    const bool whole = std::string_view(text).find(",2,0\n") != std::string_view::npos;
    EXPECT_NEAR(std::abs(medium->index(500) - (whole ? Complex(1.5) : Complex(1.6, 0.1))), 0, 1e-12) << text;
  }
  // An error shows the line as it stands in the file.
  EXPECT_EQ(folder.read("a.csv", "nm;n\n400;1,5\n500;x\n").errors().front().excerpt, "500;x");
  EXPECT_EQ(folder.read("a.csv", "nm;n\n400;1,5\n300;1,5\n").errors().front().excerpt, "300;1,5");
}

// The export of refractiveindex.info: n, and below it k at wavelengths of its own.
TEST(NkCsv, ATableOfNAndOneOfK) {
  const NkFolder folder;
  for (const char* text : {"wl,n\n0.4,1.5\n0.6,1.7\n0.7,1.1\n\nwl,k\n0.45,0.1\n0.5,0.3\n0.8,0.0\n",
                           "wl,k\n0.45,0.1\n0.5,0.3\n0.8,0.0\nwl,n\n0.4,1.5\n0.6,1.7\n0.7,1.1\n",
                           "wl;n\n0,4;1,5\n0,6;1,7\n0,7;1,1\nnm;k\n450;0,1\n500;0,3\n800;0,0\n"}) {
    const auto medium = folder.read("Ag.csv", text);
    ASSERT_TRUE(medium.ok()) << text << to_text(medium.errors());
    EXPECT_NEAR(std::abs(medium->index(475) - Complex(1.575, 0.2)), 0, 1e-12) << text;
    EXPECT_NEAR(std::abs(medium->index(650) - Complex(1.4, 0.15)), 0, 1e-12) << text;
    EXPECT_EQ(medium->range_nm(), (optics::WavelengthRange{450, 700}));
  }
}

TEST(NkCsv, ProblemsHaveAPlace) {
  const NkFolder folder;
  const BrokenFile broken[] = {
      {"# of mine\nwavelength_nm,m,k\n400,1,0\n", 2, 15,
       "expected the columns wavelength_nm (or wavelength_um), n and"},
      {"\nnm,n,k,temperature\n400,1,0,20\n", 2, 8,
       "expected the columns wavelength_nm (or wavelength_um), n and perhaps "
       "k, got 'temperature'"},
      {"nm, lambda, n\n400,400,1\n", 1, 5,
       "expected the columns wavelength_nm (or wavelength_um), n and perhaps k, got "
       "'lambda' as a second one"},
      {"n,k\n1,0\n", 1, 1,
       "expected the columns wavelength_nm (or wavelength_um), n and perhaps k, got no column of wave"},
      {"nm,k\n1,0\n", 1, 1,
       "expected the columns wavelength_nm (or wavelength_um), n and perhaps k, got no column of n"},
      {"400\n500\n", 1, 1, "expected 2 or 3 columns (wavelength in nm, n and perhaps k), got 1"},
      {"400,1,0,3\n", 1, 9, "expected 2 or 3 columns (wavelength in nm, n and perhaps k), got 4"},
      {"nm,n\n400,1\n500,x\n", 3, 5, "expected a number, got 'x'"},
      {"nm,n\n400,1\n500\n", 3, 1, "expected 2 cells, got 1"},
      {"nm,n\n500,1\n400,1\n", 3, 1, "expected rising wavelengths, got 400 nm after 500 nm"},
      {"nm,n\n500,1\n500,1\n", 3, 1, "expected rising wavelengths"},
      {"n,nm\n1,0\n", 2, 3, "expected a wavelength > 0, got 0"},
      {"nm,n\n500,-1\n", 2, 5, "expected n >= 0, got -1"},
      {"nm,n,k\n500,1,-0.5\n", 2, 7, "expected k >= 0 (n + ik absorbs), got -0.5"},
      {"nm,n,k\n500,0,0\n", 2, 5, "expected an index other than 0"},
      {"nm,n\n0.4,1\n0.7,1\n", 3, 1, "expected wavelengths in nm, got 0.7 nm as the longest"},
      {"wavelength_um,n\n400,1.5\n700,1.6\n", 2, 1, "expected wavelengths in micrometres, got 400 as the shortest"},
      {"wl,n\n400,1.5\n700,1.6\n", 2, 1, "expected wavelengths in micrometres, got 400 as the shortest"},
      {"400,1,52\n500,1,51\n", 1, 5, "expected decimal points, or ';' between the columns where ',' is the decimal"},
      {"nm,n\n400,1,52\n", 2, 7, "expected 2 cells, got 3"},
      {"nm;n\n400;1,5\n500;1.5\n", 3, 5, "expected ',' as the decimal sign, as above, got '1.5'"},
      {"nm;n\n1.400,5;1,5\n", 2, 1, "expected a number with one decimal sign, got '1.400,5'"},
      {"nm;n\n400;1,5\n500;x\n", 3, 5, "expected a number, got 'x'"},
      {"nm;n\n400;1,5;2\n", 2, 9, "expected 2 cells, got 3"},
      {"wl,n\n0.4,1.5\nwl,n\n0.4,1.5\n", 3, 1, "expected one table, or one of n and one of k below it, got names"},
      {"wl,n\n0.4,1.5\nwl,k\n", 3, 1, "expected one table, or one of n and one of k below it, got names"},
      {"wl,n\n0.4,1.5\nwl,k\n0.4,-1\n", 4, 5, "expected k >= 0 (n + ik absorbs), got -1"},
      {"wl,n\n0.4,1.5\nk,wl\n0.1,0.5\n0.1,0.4\n", 5, 5, "expected rising wavelengths, got 400 nm after 500 nm"},
      {"wl,n\nwl,k\n0.4,1\n", 2, 1, "expected rows of numbers below the names, got names"},
      {"nm,n\n400,nan\n", 2, 5, "expected a number, got 'nan'"},
      {"nm,n\n400,1e999\n", 2, 5, "expected a number, got '1e999'"},
  };
  for (const BrokenFile& one : broken) expect_refused(folder, "a.csv", one);
  EXPECT_EQ(read_nk_file("/nowhere/a.csv").errors().front().failure, Failure::file);
}

}  // namespace
}  // namespace shabon::api
