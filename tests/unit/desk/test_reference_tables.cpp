// The reference tables, read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "shabon/base/random.h"
#include "shabon/color/illuminant.h"
#include "shabon/color/rgb.h"
#include "shabon/desk/film_spectrum.h"
#include "shabon/desk/reference_tables.h"
#include "shabon/desk/sweep.h"
#include "shabon/io/csv.h"
#include "shabon/optics/medium.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::desk {
namespace {

constexpr const char* program_version = "1.2.3";

const std::vector<ReferenceFile>& files() {
  static const std::vector<ReferenceFile> all = reference_files(program_version);
  return all;
}

const ReferenceFile& file(std::string_view name) {
  for (const ReferenceFile& one : files())
    if (one.name == name) return one;
  ADD_FAILURE() << name;
  return files().front();
}

// A table with its columns as numbers.
class Table {
 public:
  explicit Table(std::string_view name) : table_(io::parse_csv(file(name).text, std::string(name))) {
    EXPECT_TRUE(table_.ok()) << name << (table_ ? "" : to_text(table_.errors()));
  }
  const io::CsvTable& csv() const { return *table_; }
  std::vector<double> column(std::string_view name) const {
    const auto values = io::numbers(*table_, name);
    EXPECT_TRUE(values.ok()) << name;
    return values ? *values : std::vector<double>(table_->rows.size());
  }
  std::string text(std::size_t row, std::string_view name) const {
    return table_->rows[row].cells[*table_->column(name)].text;
  }

 private:
  Result<io::CsvTable> table_;
};

optics::Stack stack_of(const ReferenceFilm& film, double thickness_nm) {
  optics::Stack stack = *optics::parse_stack(film.expression);
  stack.layers[film.layer].thickness_nm = thickness_nm;
  return stack;
}

TEST(ReferenceTables, FilmsAreReadableAndNamedOnce) {
  std::set<std::string_view> names;
  for (const ReferenceFilm& film : reference_films()) {
    EXPECT_TRUE(names.insert(film.name).second) << film.name;
    const auto stack = optics::parse_stack(film.expression);
    ASSERT_TRUE(stack.ok()) << film.expression;
    ASSERT_LT(film.layer, stack->layers.size());
    EXPECT_EQ(stack->layers[film.layer].thickness_nm, 0);
    EXPECT_EQ(std::count_if(stack->layers.begin(), stack->layers.end(),
                            [](const optics::Layer& layer) { return layer.thickness_nm == 0; }),
              1);
    EXPECT_EQ(film.expression.find('"'), std::string_view::npos);
    EXPECT_EQ(film.title.find('"'), std::string_view::npos);
  }
  for (const std::string_view lamp : reference_lamps) EXPECT_NE(color::find_illuminant(lamp), nullptr) << lamp;
}

TEST(ReferenceTables, AreTheOnesListed) {
  const std::vector<ReferenceFile> list = reference_list();
  ASSERT_EQ(files().size(), list.size());
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(files()[i].name, list[i].name);
    EXPECT_EQ(files()[i].description, list[i].description);
    EXPECT_TRUE(files()[i].text.starts_with(reference_marker)) << list[i].name;
    EXPECT_NE(files()[i].text.find(program_version), std::string::npos) << list[i].name;
    EXPECT_EQ(files()[i].text.find('\r'), std::string::npos);
    EXPECT_EQ(files()[i].text.back(), '\n');
    bytes += files()[i].text.size();
    if (list[i].rows > 0) {
      EXPECT_EQ(Table(list[i].name).csv().rows.size(), list[i].rows) << list[i].name;
    }
  }
  EXPECT_LT(bytes, 8e6);
}

TEST(ReferenceTables, IndexHoldsEveryTable) {
  const Table index("index.csv");
  ASSERT_EQ(index.csv().rows.size(), files().size() - 2);
  const auto bytes = index.column("bytes"), rows = index.column("rows");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_EQ(index.text(i, "file"), files()[i].name);
    EXPECT_EQ(index.text(i, "content"), files()[i].description);
    EXPECT_EQ(bytes[i], static_cast<double>(files()[i].text.size()));
    EXPECT_EQ(rows[i], static_cast<double>(files()[i].rows));
    EXPECT_NE(file("README.md").text.find(files()[i].name), std::string::npos) << files()[i].name;
  }
}

TEST(ReferenceTables, AreTheSameBytesAgain) {
  const std::vector<ReferenceFile> again = reference_files(program_version);
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_TRUE(again[i].text == files()[i].text) << again[i].name;
}

TEST(ReferenceTables, HeadsNameTheSourceOfEveryMedium) {
  for (const ReferenceFilm& film : reference_films()) {
    const optics::Stack stack = stack_of(film, 0);
    std::vector<optics::Medium> media = {stack.incidence, stack.exit};
    for (const optics::Layer& layer : stack.layers) media.push_back(layer.medium);
    for (const char* kind : {"-spectra.csv", "-colors.csv"})
      for (const optics::Medium& medium : media)
        if (!medium.is_constant()) {
          EXPECT_NE(file(std::string(film.name) + kind).text.find(medium.source()), std::string::npos)
              << film.name << kind << " " << medium.name();
        }
  }
}

// Rows at random, evaluated one by one.
TEST(ReferenceTables, SpectraAreThoseOfTheReference) {
  Pcg32 random(1);
  for (const ReferenceFilm& film : reference_films()) {
    const Table table(std::string(film.name) + "-spectra.csv");
    const auto nm = table.column("wavelength_nm"), angle = table.column("angle_deg"),
               thickness = table.column("thickness_nm");
    const std::vector<double> columns[] = {table.column("R_s"), table.column("R_p"), table.column("T_s"),
                                           table.column("T_p")};
    for (int k = 0; k < 200; ++k) {
      const auto i = static_cast<std::size_t>(random.uniform() * static_cast<double>(nm.size()));
      const optics::Powers powers = film_powers(stack_of(film, thickness[i]), optics::Interference::airy,
                                                optics::incidence_from(Degrees(angle[i])), nm[i]);
      EXPECT_EQ(columns[0][i], powers.R_s) << film.name << " row " << i;
      EXPECT_EQ(columns[1][i], powers.R_p) << film.name << " row " << i;
      EXPECT_EQ(columns[2][i], powers.T_s) << film.name << " row " << i;
      EXPECT_EQ(columns[3][i], powers.T_p) << film.name << " row " << i;
    }
  }
}

// The colours come from one code, those of a sweep from another.
TEST(ReferenceTables, ColoursAreThoseOfASweep) {
  Pcg32 random(2);
  for (const ReferenceFilm& film : reference_films()) {
    const Table table(std::string(film.name) + "-colors.csv");
    const auto angle = table.column("angle_deg"), thickness = table.column("thickness_nm");
    const auto x = table.column("X"), y = table.column("Y"), z = table.column("Z");
    const auto r = table.column("linear_r"), g = table.column("linear_g"), b = table.column("linear_b");
    std::set<std::string> sides;
    for (std::size_t i = 0; i < angle.size(); ++i) sides.insert(table.text(i, "side"));
    EXPECT_EQ(sides.size(), film.transmits ? 2u : 1u) << film.name;
    for (int k = 0; k < 40; ++k) {
      const auto i = static_cast<std::size_t>(random.uniform() * static_cast<double>(angle.size()));
      SCOPED_TRACE(testing::Message() << film.name << " row " << i);
      Sweep sweep{stack_of(film, 0), film.layer, {thickness[i]}, optics::incidence_from(Degrees(angle[i]))};
      sweep.side = table.text(i, "side") == "reflected" ? Side::reflected : Side::transmitted;
      const auto colors = swept_colors(sweep, *color::find_illuminant(table.text(i, "lamp")));
      ASSERT_TRUE(colors.ok());
      EXPECT_NEAR(x[i], colors->front().x, 1e-11);
      EXPECT_NEAR(y[i], colors->front().y, 1e-11);
      EXPECT_NEAR(z[i], colors->front().z, 1e-11);
      const color::LinearRgb linear = color::xyz_to_linear_srgb({x[i], y[i], z[i]});
      EXPECT_EQ(r[i], linear.r);
      EXPECT_EQ(g[i], linear.g);
      EXPECT_EQ(b[i], linear.b);
      EXPECT_EQ(table.text(i, "hex"), color::to_hex(color::encode_srgb(linear)));
    }
  }
}

// As a reader would do it, from the files alone: indices, Airy, lamp and observer.
TEST(ReferenceTables, CanBeComputedAgainFromTheFilesAlone) {
  const Table media("media.csv"), light("light.csv"), colors("soap-film-colors.csv");
  const auto n = media.column("n_water"), k = media.column("k_water"), lamp = light.column("A"),
             x = light.column("xbar"), y = light.column("ybar");
  const auto angle = colors.column("angle_deg"), thickness = colors.column("thickness_nm");
  std::size_t compared = 0;
  for (std::size_t i = 0; i < angle.size(); i += 7) {
    if (angle[i] != 0 || colors.text(i, "lamp") != "A" || colors.text(i, "side") != "reflected") continue;
    double sum_x = 0, sum_y = 0, perfect = 0;
    for (std::size_t w = 0; w < n.size(); ++w) {
      EXPECT_EQ(k[w], 0);
      const double rho = std::pow((n[w] - 1) / (n[w] + 1), 2);
      const double half = std::sin(2 * std::numbers::pi * n[w] * thickness[i] / (360 + static_cast<double>(w)));
      const double R = 4 * rho * half * half / (std::pow(1 - rho, 2) + 4 * rho * half * half);
      sum_x += lamp[w] * x[w] * R, sum_y += lamp[w] * y[w] * R, perfect += lamp[w] * y[w];
    }
    EXPECT_NEAR(colors.column("X")[i], sum_x / perfect, 1e-12);
    EXPECT_NEAR(colors.column("Y")[i], sum_y / perfect, 1e-12);
    ++compared;
  }
  EXPECT_GT(compared, 10u);
}

TEST(ReferenceTables, LoseNothingWhereNothingAbsorbs) {
  for (const char* name : {"free-film-1.333", "soap-film", "oil-on-water"}) {
    const Table table(std::string(name) + "-spectra.csv");
    const auto R_s = table.column("R_s"), R_p = table.column("R_p"), T_s = table.column("T_s"),
               T_p = table.column("T_p");
    for (std::size_t i = 0; i < R_s.size(); ++i) {
      ASSERT_NEAR(R_s[i] + T_s[i], 1, 1e-13);
      ASSERT_NEAR(R_p[i] + T_p[i], 1, 1e-13);
    }
  }
}

// Newton's colours of a free film, n = 1.333, D65, from independent programs.
TEST(ReferenceTables, FreeFilmIsThatOfAnIndependentProgram) {
  const auto newton = io::read_csv(SHABON_TEST_DATA "/color/newton_d65.csv");
  ASSERT_TRUE(newton.ok());
  const auto of = [&](const char* name) { return *io::numbers(*newton, name); };
  const auto d = of("d_nm"), theta = of("theta_deg"), X = of("X"), Y = of("Y"), Z = of("Z"), red = of("linDR");
  const Table table("free-film-1.333-colors.csv");
  const auto angle = table.column("angle_deg"), thickness = table.column("thickness_nm");
  const auto x = table.column("X"), y = table.column("Y"), z = table.column("Z"), r = table.column("linear_r");
  std::size_t compared = 0;
  for (std::size_t i = 0; i < angle.size(); ++i) {
    if (table.text(i, "lamp") != "D65" || table.text(i, "side") != "reflected") continue;
    for (std::size_t j = 0; j < d.size(); ++j) {
      if (d[j] != thickness[i] || theta[j] != angle[i]) continue;
      EXPECT_NEAR(x[i], X[j], 1e-10) << d[j];
      EXPECT_NEAR(y[i], Y[j], 1e-10) << d[j];
      EXPECT_NEAR(z[i], Z[j], 1e-10) << d[j];
      EXPECT_NEAR(r[i], red[j], 1e-10) << d[j];
      ++compared;
    }
  }
  EXPECT_EQ(compared, d.size());
}

}  // namespace
}  // namespace shabon::desk
