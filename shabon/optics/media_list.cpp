#include "shabon/optics/media_list.h"

#include <string>
#include <utility>

#include "shabon/base/table.h"
#include "shabon/base/text.h"

namespace shabon::tables {
std::span<const Table> media();
}

namespace shabon::optics {

namespace {

using Names = std::vector<std::string_view>;

// Where the numbers were taken from, for the formulas as for the tables of data/nk.
constexpr const char* through = "; through refractiveindex.info (CC0 1.0)";

struct FormulaEntry {
  std::string_view name;
  Names aliases;
  std::string_view description, source;
  DispersionFormula formula;
  WavelengthRange range;
};

class MediaList {
 public:
  void add_constant(std::string_view name, std::complex<double> index, const char* description, const char* source) {
    entries_.push_back({name, {}, Medium::constant(index, {std::string(name), description, source})});
  }

  // Absorbs by the table `name`-k of data/nk where there is one.
  void add(FormulaEntry entry) {
    std::vector<AbsorptionSample> absorption;
    if (const Table* table = find_table(entry.name))
      if (table->columns.size() == 2)
        for (std::size_t i = 0; i < table->columns[0].size(); ++i)
          absorption.push_back({table->columns[0][i], table->columns[1][i]});
    MediumDescription description = {std::string(entry.name), std::string(entry.description),
                                     std::string(entry.source) + through};
    add(entry.name, std::move(entry.aliases),
        Medium::formula(std::move(entry.formula), entry.range, std::move(description), std::move(absorption)));
  }

  void add_table(std::string_view name, Names aliases = {}) {
    const Table* table = find_table(name);
    if (table == nullptr || table->columns.size() != 3) return;
    std::vector<IndexSample> rows;
    for (std::size_t i = 0; i < table->columns[0].size(); ++i)
      rows.push_back({table->columns[0][i], table->columns[1][i], table->columns[2][i]});
    add(name, std::move(aliases),
        Medium::table(std::move(rows),
                      {std::string(name), std::string(table->description), std::string(table->source) + through}));
  }

  // Parts are media already in the list.
  void add_mixture(std::string_view name, const std::vector<std::pair<std::string_view, double>>& parts,
                   const char* description, const char* source) {
    std::vector<MixturePart> mixed;
    for (const auto& [part, fraction] : parts)
      for (const MediumEntry& entry : entries_)
        if (entry.name == part) mixed.push_back({entry.medium, fraction});
    add(name, {}, Medium::mixture(std::move(mixed), {std::string(name), description, source}));
  }

  std::vector<MediumEntry> take() { return std::move(entries_); }

 private:
  static const Table* find_table(std::string_view name) {
    for (const Table& table : tables::media())
      if (table.name == name) return &table;
    return nullptr;
  }

  // What cannot be built is left out, and a test misses it.
  void add(std::string_view name, Names aliases, const Result<Medium>& medium) {
    if (medium) entries_.push_back({name, std::move(aliases), *medium});
  }

  std::vector<MediumEntry> entries_;
};

void add_gases(MediaList& list) {
  list.add_constant("vacuum", 1, "vacuum", "exactly 1 by definition");
  list.add_constant("air", 1, "air as an ideal, index exactly 1", "by convention");
  list.add({"air-ciddor",
            {},
            "dry air at 15 C, 101.325 kPa, 450 ppm CO2",
            "P. E. Ciddor, Refractive index of air: new equations for the visible and near infrared, Appl. Opt. 35, "
            "1566-1573 (1996)",
            {6, {0, 0.05792105, 238.0185, 0.00167917, 57.362}},
            {230, 1690}});
}

void add_liquids(MediaList& list) {
  list.add({"water",
            {"H2O"},
            "distilled water at 20.0 C",
            "M. Daimon, A. Masumura, Measurement of the refractive index of distilled water from the near-infrared "
            "region to the ultraviolet region, Appl. Opt. 46, 3811-3820 (2007)",
            {2,
             {0, 0.5684027565, 0.005101829712, 0.1726177391, 0.01821153936, 0.02086189578, 0.02620722293, 0.1130748688,
              10.69792721}},
            {182, 1129}});
  list.add_table("water-hale");
  list.add_table("water-segelstein");
  list.add({"glycerol",
            {"glycerine"},
            "glycerol at 25 C",
            "J. Rheims, J. Koeser, T. Wriedt, Refractive-index measurements in the near-IR using an Abbe "
            "refractometer, Meas. Sci. Technol. 8, 601-605 (1997)",
            {5, {1.45797, 0.00598, -2, -0.00036, -4}},
            {589.3, 1050}});
}

void add_oils(MediaList& list) {
  list.add({"oleic-acid",
            {"olive-oil", "oil"},
            "oleic acid, the main part of olive oil",
            "S. H. Jones, M. D. King, A. D. Ward, Atmospherically relevant core-shell aerosol studied using optical "
            "trapping and Mie scattering, Chem. Commun. 51, 4914-4917 (2015)",
            {5, {1.4554, 0.004565, -2, 0.0001, -4}},
            {495, 670}});
  list.add({"octane",
            {},
            "n-octane at 20 C, a light part of petrol",
            "K. Kerl, H. Varchmin, Refractive index dispersion (RID) of some liquids in the UV/VIS between 20 C and 60 "
            "C, J. Mol. Struct. 349, 257-260 (1995)",
            {5, {1.39260498, -0.00448963, -1, 0.00479591, -2}},
            {326, 644}});
  list.add({"toluene",
            {},
            "toluene at 27 C",
            "K. Moutzouris et al., Refractive, dispersive and thermo-optic properties of twelve organic solvents in "
            "the visible and near-infrared, Appl. Phys. B 116, 617-622 (2013)",
            {3, {2.161659124, 0.000495188, 2, 0.02138179, -2, 5.8838e-05, -4, 8.7632e-05, -6}},
            {450, 1551}});
  list.add({"PDMS",
            {"silicone"},
            "polydimethylsiloxane, silicone RTV 615",
            "F. Schneider, J. Draheim, R. Kamberger, U. Wallrabe, Process and material properties of "
            "polydimethylsiloxane (PDMS) for Optical MEMS, Sens. Actuators A 151, 95-99 (2009)",
            {2, {0, 1.0057, 0.013217}},
            {350, 700}});
  list.add_table("biodiesel");
}

// Nobody has published the dispersion of a soap solution. The soap itself is counted as oleic acid, whose salt it is.
void add_soaps(MediaList& list) {
  list.add_mixture("soap", {{"water", 0.976}, {"glycerol", 0.012}, {"oleic-acid", 0.012}},
                   "bubble solution of the kitchen, an estimate by the mixing rule",
                   "recipe of Idaho State University, physics demonstrations, thin film interference (2/3 cup of dish "
                   "liquid, 1 gallon of water, 3 tablespoons of glycerine), the liquid taken as 30 % soap; index by "
                   "the rule of Lorentz and Lorenz");
  list.add_mixture("soap-glycerol", {{"water", 0.585}, {"glycerol", 0.4}, {"oleic-acid", 0.015}},
                   "long-lived bubble solution rich in glycerol, an estimate by the mixing rule",
                   "recipe of A. A. Michelson, Light Waves and Their Uses (1903), p. 14 (three parts of soap in 40 "
                   "parts of water, two parts of glycerine); index by the rule of Lorentz and Lorenz");
}

void add_glasses(MediaList& list) {
  list.add({"SiO2",
            {"fused-silica", "silica"},
            "fused silica at 20 C",
            "I. H. Malitson, Interspecimen comparison of the refractive index of fused silica, J. Opt. Soc. Am. 55, "
            "1205-1208 (1965)",
            {1, {0, 0.6961663, 0.0684043, 0.4079426, 0.1162414, 0.8974794, 9.896161}},
            {210, 6700}});
  list.add({"N-BK7",
            {"glass", "BK7"},
            "borosilicate crown glass N-BK7",
            "Schott, Zemax catalogue of 2017-01-20",
            {2, {0, 1.03961212, 0.00600069867, 0.231792344, 0.0200179144, 1.01046945, 103.560653}},
            {300, 2500}});
  list.add({"soda-lime",
            {"window-glass"},
            "clear soda-lime silica window glass",
            "M. Rubin, Optical properties of soda lime silica glasses, Sol. Energy Mater. 12, 275-288 (1985)",
            {5, {1.513, -0.003169, 2, 0.003962, -2}},
            {310, 4600}});
}

void add_coatings(MediaList& list) {
  constexpr const char* dodge =
      "M. J. Dodge, Refractive properties of magnesium fluoride, Appl. Opt. 23, 1980-1985 (1984)";
  constexpr const char* devore =
      "J. R. DeVore, Refractive indices of rutile and sphalerite, J. Opt. Soc. Am. 41, 416-419 (1951)";
  list.add({"MgF2",
            {},
            "magnesium fluoride crystal at 19 C, ordinary ray",
            dodge,
            {1, {0, 0.48755108, 0.04338408, 0.39875031, 0.09461442, 2.3120353, 23.793604}},
            {200, 7000}});
  list.add({"MgF2-e",
            {},
            "magnesium fluoride crystal at 19 C, extraordinary ray",
            dodge,
            {1, {0, 0.41344023, 0.03684262, 0.50497499, 0.09076162, 2.4904862, 23.771995}},
            {200, 7000}});
  list.add_table("MgF2-film");
  list.add({"ZnS",
            {},
            "cubic zinc sulfide at 20 C",
            "M. Debenham, Refractive indices of zinc sulfide in the 0.405-13-um wavelength range, Appl. Opt. 23, "
            "2238-2239 (1984); C. A. Klein, Room-temperature dispersion equations for cubic zinc sulfide, Appl. Opt. "
            "25, 1873-1875 (1986)",
            {4, {8.393, 0.14383, 0, 0.2421, 2, 4430.99, 0, 36.71, 2}},
            {405, 13000}});
  list.add_table("TiO2");
  list.add_table("TiO2-sarkar");
  list.add({"TiO2-rutile",
            {"rutile", "TiO2-crystal"},
            "rutile crystal, ordinary ray",
            devore,
            {4, {5.913, 0.2441, 0, 0.0803, 1}},
            {430, 1530}});
  list.add({"TiO2-rutile-e",
            {},
            "rutile crystal, extraordinary ray",
            devore,
            {4, {7.197, 0.3322, 0, 0.0843, 1}},
            {430, 1530}});
  list.add({"Al2O3",
            {"sapphire"},
            "synthetic sapphire at 20 C, ordinary ray",
            "I. H. Malitson, M. J. Dodge, Refractive index and birefringence of synthetic sapphire, J. Opt. Soc. Am. "
            "62, 1405 (1972); M. J. Dodge in Handbook of Laser Science and Technology IV, CRC Press (1986)",
            {1, {0, 1.4313493, 0.0726631, 0.65054713, 0.1193242, 5.3414021, 18.028251}},
            {200, 5000}});
  list.add({"Si3N4",
            {},
            "silicon nitride film",
            "H. R. Philipp, Optical properties of silicon nitride, J. Electrochem. Soc. 120, 295-300 (1973); T. Baak, "
            "Silicon oxynitride; a material for GRIN optics, Appl. Opt. 21, 1069-1072 (1982)",
            {1, {0, 2.8939, 0.13967}},
            {207, 1240}});
}

void add_absorbing(MediaList& list) {
  list.add_table("Si", {"silicon"});
  list.add_table("Si-aspnes");
  list.add_table("Ag", {"silver"});
  list.add_table("Al", {"aluminium", "aluminum"});
  list.add_table("Au", {"gold"});
  list.add_table("Cu", {"copper"});
  list.add_table("Cr", {"chromium"});
  list.add_table("Fe", {"iron"});
  list.add_table("Ti", {"titanium"});
  list.add_table("Fe2O3", {"hematite"});
  list.add_table("Fe3O4", {"magnetite"});
}

}  // namespace

std::vector<MediumEntry> make_media_list() {
  MediaList list;
  add_gases(list);
  add_liquids(list);
  add_oils(list);
  add_soaps(list);
  add_glasses(list);
  add_coatings(list);
  add_absorbing(list);
  return list.take();
}

}  // namespace shabon::optics
