#include "shabon/api/nk_yaml.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "shabon/api/nk_join.h"
#include "shabon/api/yaml_words.h"
#include "shabon/base/text.h"
#include "shabon/io/yaml.h"

namespace shabon::api {

namespace {

constexpr double nm_per_um = 1000;
// A table in micrometres that begins here knows nothing of light; one in nm does.
constexpr double longest_plausible_first_um = 100;

// What one kind of DATA entry gives, and how many numbers stand in a row of its table.
struct TableKind {
  std::string_view name;
  bool gives_n, gives_k;
  std::size_t width() const { return gives_n && gives_k ? 3 : 2; }
};

constexpr TableKind table_kinds[] = {
    {"tabulated n", true, false}, {"tabulated k", false, true}, {"tabulated nk", true, true}};
constexpr const char* known_types = "'formula 1' .. 'formula 9', 'tabulated n', 'tabulated k' or 'tabulated nk'";

// A line of a table that is not made of whole rows.
struct BrokenRow {
  std::size_t first_word = 0, words = 0;  // of the line, in the whole text
};

std::optional<BrokenRow> broken_row(std::string_view text, std::size_t width) {
  std::size_t before = 0;
  for (const std::string_view line : split(text, '\n')) {
    const std::size_t words = words_of(line).size();
    if (words % width != 0) return BrokenRow{before, words};
    before += words;
  }
  if (before == 0) return BrokenRow{};
  return {};
}

class Reader {
 public:
  explicit Reader(const io::YamlDocument& document) : document_(document) {}

  Result<optics::Medium> read(optics::MediumDescription description) {
    const io::YamlNode& root = document_.root;
    const io::YamlNode* data = root.kind == io::YamlNode::Kind::mapping ? io::find(root, "DATA") : nullptr;
    if (data == nullptr || data->kind != io::YamlNode::Kind::sequence || data->items.empty())
      return Diagnostics{at(data ? *data : root, "expected a list DATA as in a file of refractiveindex.info, got " +
                                                     (data ? io::describe(*data) : "none"))};
    for (const io::YamlNode& entry : data->items) read_entry(entry);
    if (errors_.empty() && !formula_ && n_.empty())
      errors_.push_back(at(*data, "expected an entry that gives n (a formula, 'tabulated n' or 'tabulated nk')"));
    if (!errors_.empty()) return errors_;
    return joined(*data, std::move(description));
  }

 private:
  Diagnostic at(const io::YamlNode& node, std::string message) const {
    return io::diagnostic_at(document_, node, std::move(message));
  }
  void refuse(const io::YamlNode& node, std::string message) { errors_.push_back(at(node, std::move(message))); }
  void refuse_word(const io::YamlNode& scalar, std::size_t word, std::string message) {
    errors_.push_back(diagnostic_at_word(document_, scalar, word, std::move(message)));
  }

  void read_entry(const io::YamlNode& entry) {
    if (entry.kind != io::YamlNode::Kind::mapping)
      return refuse(entry, "expected a mapping with a type, got " + io::describe(entry));
    const io::YamlNode* type = io::find(entry, "type");
    if (type == nullptr) return refuse(entry, "expected a type: " + std::string(known_types));
    const std::string name = lower(trim(type->text));
    const auto* kind = std::find_if(std::begin(table_kinds), std::end(table_kinds),
                                    [&](const TableKind& known) { return known.name == name; });
    const bool table = kind != std::end(table_kinds), formula = name.starts_with("formula ");
    if (!table && !formula)
      return refuse(*type, "expected " + std::string(known_types) + ", got '" + printable(type->text, 60) + "'");
    if ((formula || kind->gives_n) && has_n_) return refuse(*type, "expected one entry that gives n, got a second one");
    if (table && kind->gives_k && has_k_) return refuse(*type, "expected one entry that gives k, got a second one");
    has_n_ = has_n_ || formula || kind->gives_n;
    has_k_ = has_k_ || (table && kind->gives_k);
    if (formula)
      read_formula(entry, *type, name);
    else
      read_table(entry, *kind);
  }

  // The numbers of a scalar such as "0.2 1.1", or nothing and errors.
  std::optional<std::vector<double>> numbers(const io::YamlNode& entry, std::string_view key) {
    const io::YamlNode* node = io::find(entry, key);
    if (node == nullptr || node->kind != io::YamlNode::Kind::scalar) {
      refuse(node ? *node : entry, "expected numbers as " + std::string(key) + ", got " +
                                       (node ? io::describe(*node) : "an entry without it"));
      return {};
    }
    std::vector<double> values;
    const std::vector<std::string_view> words = words_of(node->text);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::optional<double> value = parse_number(words[i]);
      if (!value) {
        refuse_word(*node, i, "expected a number, got '" + printable(words[i], 60) + "'");
        return {};
      }
      values.push_back(*value);
    }
    return values;
  }

  void read_formula(const io::YamlNode& entry, const io::YamlNode& type, const std::string& name) {
    // Older files of that database say `range`.
    const char* range_key =
        io::find(entry, "wavelength_range") || !io::find(entry, "range") ? "wavelength_range" : "range";
    const auto range = numbers(entry, range_key);
    auto coefficients = numbers(entry, "coefficients");
    if (!range || !coefficients) return;
    if (range->size() != 2 || !((*range)[0] > 0) || !((*range)[1] > (*range)[0]))
      return refuse(*io::find(entry, range_key), "expected two rising wavelengths > 0, got '" +
                                                     printable(io::find(entry, range_key)->text, 60) + "'");
    const std::string_view digits = trim(std::string_view(name).substr(std::string_view("formula ").size()));
    const std::optional<long long> number = parse_integer(digits);
    if (!number || *number < 1 || *number > static_cast<long long>(optics::dispersion_formulas.size()))
      return refuse(type, "expected 'formula 1' .. 'formula 9', got '" + printable(type.text, 60) + "'");
    coefficients_ = io::find(entry, "coefficients");
    Result<optics::DispersionFormula> formula =
        optics::dispersion_formula(static_cast<int>(*number), *std::move(coefficients));
    if (!formula) return refuse(*coefficients_, formula.errors().front().message);
    formula_ = *formula;
    formula_range_ = {(*range)[0] * nm_per_um, (*range)[1] * nm_per_um};
  }

  void read_table(const io::YamlNode& entry, const TableKind& kind) {
    const auto values = numbers(entry, "data");
    if (!values) return;
    const std::size_t width = kind.width();
    const io::YamlNode& data = *io::find(entry, "data");
    if (const auto row = broken_row(data.text, width))
      return refuse_word(data, row->first_word,
                         "expected rows of " + std::to_string(width) +
                             " numbers (the wavelength in micrometres, then " +
                             std::string(kind.name.substr(kind.name.find(' ') + 1)) + "), got " +
                             std::to_string(row->words) + (row->words == 1 ? " number" : " numbers"));
    double previous_um = 0;
    for (std::size_t i = 0; i < values->size(); i += width) {
      const double um = (*values)[i];
      if (!(um > previous_um))
        return refuse_word(
            data, i,
            "expected rising wavelengths > 0, got " + format_number(um) + " after " + format_number(previous_um));
      if (i == 0 && um >= longest_plausible_first_um)
        return refuse_word(
            data, i,
            "expected wavelengths in micrometres, got " + format_number(um) + " as the shortest: are they nanometres?");
      previous_um = um;
      for (std::size_t j = i + 1; j < i + width; ++j)
        if (!((*values)[j] >= 0))
          return refuse_word(data, j, "expected n and k >= 0, got " + format_number((*values)[j]));
      if (width == 3 && (*values)[i + 1] == 0 && (*values)[i + 2] == 0)
        return refuse_word(data, i + 1, "expected an index other than 0");
      if (kind.gives_n) n_.push_back({um * nm_per_um, (*values)[i + 1]});
      if (kind.gives_k) k_.push_back({um * nm_per_um, (*values)[i + width - 1]});
    }
  }

  Result<optics::Medium> joined(const io::YamlNode& data, optics::MediumDescription description) const {
    const io::YamlNode& blamed = coefficients_ ? *coefficients_ : data;
    const auto placed = [&](Result<optics::Medium> medium) -> Result<optics::Medium> {
      if (medium) return medium;
      return Diagnostics{at(blamed, medium.errors().front().message)};
    };
    if (formula_) {
      std::vector<optics::AbsorptionSample> absorption;
      for (const NkSample& sample : k_) absorption.push_back({sample.wavelength_nm, sample.value});
      return placed(optics::Medium::formula(*formula_, formula_range_, std::move(description), std::move(absorption)));
    }
    return placed(joined_table(n_, k_, std::move(description)));
  }

  const io::YamlDocument& document_;
  Diagnostics errors_;
  bool has_n_ = false, has_k_ = false;
  std::optional<optics::DispersionFormula> formula_;
  optics::WavelengthRange formula_range_;
  const io::YamlNode* coefficients_ = nullptr;
  std::vector<NkSample> n_, k_;
};

}  // namespace

Result<optics::Medium> read_nk_yaml(const std::filesystem::path& path) {
  const Result<io::YamlDocument> document = io::read_yaml(path);
  if (!document) return document.errors();
  const io::YamlNode* references =
      document->root.kind == io::YamlNode::Kind::mapping ? io::find(document->root, "REFERENCES") : nullptr;
  return Reader(*document).read(
      {path.filename().string(), "n and k from a file", references ? std::string(trim(references->text)) : ""});
}

}  // namespace shabon::api
