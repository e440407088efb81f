// Whatever is done to an n-k file: a medium that can be asked, or a problem; quickly.
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

#include "nk_case.h"

namespace shabon::api {
namespace {

constexpr int rounds = 800;

const char* yaml_text =
    "REFERENCES: x\nDATA:\n  - type: formula 4\n    wavelength_range: 0.43 1.53\n"
    "    coefficients: 5.913 0.2441 0 0.0803 1 0 0 0 1\n  - type: tabulated k\n    data: |\n"
    "        0.4 1e-3\n        0.5 2e-3\n        0.7 0\nCONDITIONS: {temperature: 293}\n";
const char* csv_text = "# mine\nwavelength_nm,n,k\n380,1.50,0.1\n410,1.55,0.2\n700.5,2e0,1e-4\n830,1.25,0\n";

void mutate(std::string& text, std::mt19937& random) {
  const std::string pool = "0123456789.-+eE ,:|#\n\t\"'[]{}&*\xC3\xA9nkwl";
  const auto below = [&](std::size_t n) { return random() % n; };
  for (std::size_t change = 1 + below(4); change > 0 && !text.empty(); --change) {
    const std::size_t at = below(text.size());
    switch (below(5)) {
      case 0:
        text.erase(at, 1 + below(9));
        break;
      case 1:
        text.insert(at, 1, pool[below(pool.size())]);
        break;
      case 2:
        text[at] = pool[below(pool.size())];
        break;
      case 3:
        text[at] = static_cast<char>(below(256));
        break;
      default:
        text.insert(at, text.substr(below(text.size()), 1 + below(40)));
    }
  }
}

void expect_sane(const Result<optics::Medium>& medium, const std::string& text) {
  if (!medium) {
    ASSERT_FALSE(medium.errors().empty());
    EXPECT_LT(to_text(medium.errors()).size(), 30'000u);
    return;
  }
  for (const double nm : {1e-3, 200.0, 360.0, 430.0, 555.5, 700.0, 830.0, 1e6}) {
    const std::complex<double> index = medium->index(nm);
    EXPECT_TRUE(std::isfinite(index.real()) && index.real() >= 0) << text;
    EXPECT_TRUE(std::isfinite(index.imag()) && index.imag() >= 0) << text;
  }
}

TEST(NkMutations, MediumOrProblem) {
  const NkFolder folder;
  std::mt19937 random(7);
  const auto start = std::chrono::steady_clock::now();
  int good = 0;
  for (int round = 0; round < rounds; ++round)
    for (const bool yaml : {true, false}) {
      std::string text = yaml ? yaml_text : csv_text;
      mutate(text, random);
      const auto medium = folder.read(yaml ? "a.yml" : "a.csv", text);
      good += medium.ok();
      expect_sane(medium, text);
    }
  EXPECT_GT(good, rounds / 20);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 60);
}

// Coefficients of any size: what is not an index is refused or held, never handed on.
TEST(NkMutations, AnyCoefficients) {
  const NkFolder folder;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> exponent(-6, 3);
  for (int number = 1; number <= 9; ++number)
    for (int round = 0; round < 60; ++round) {
      const std::size_t count = number == 4 ? 9 : number == 7 || number == 9 ? 6 : number == 8 ? 4 : 5;
      std::string text =
          "DATA:\n  - type: formula " + std::to_string(number) + "\n    range: 0.4 0.7\n    coefficients:";
      for (std::size_t i = 0; i < count; ++i)
        text += " " + std::to_string((random() % 4 ? 1 : -1) * std::pow(10, exponent(random)));
      expect_sane(folder.read("a.yml", text + "\n"), text);
    }
}

TEST(NkMutations, HostileFiles) {
  const NkFolder folder;
  const auto repeated = [](std::string_view part, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += part;
    return text;
  };
  const std::string formula = "DATA:\n  - type: formula 5\n    wavelength_range: 1e-300 1e300\n    coefficients: ";
  const std::string table = "DATA:\n  - type: tabulated n\n    data: |\n";
  const auto start = std::chrono::steady_clock::now();
  for (const std::string& text :
       {formula + "1.5\n", formula + repeated("1 ", 1'000'000) + "\n", formula + "1.5 1e308 308\n",
        table + repeated("        0.4 1.5\n", 200'000), table + "        " + repeated("x", 2'000'000) + "\n",
        "DATA: " + repeated("[", 10'000), std::string("\0\0\0", 3), std::string()})
    expect_sane(folder.read("a.yml", text), text.substr(0, 100));
  for (const std::string& text : {repeated("1,", 100'000), repeated("400,1\n", 200'000), repeated("\"", 99'999),
                                  "nm,n\n" + repeated("9", 1'000'000) + ",1\n", std::string()})
    expect_sane(folder.read("a.csv", text), text.substr(0, 100));
  // Under sanitizers and beside other work up to 30; a time that grows with the square of the size takes an hour.
  constexpr double most_s = 120;
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), most_s);
}

}  // namespace
}  // namespace shabon::api
