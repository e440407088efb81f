#include "shabon/api/nk_yaml.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "shabon/base/text.h"
#include "shabon/io/yaml.h"

namespace shabon::api {

namespace {

constexpr double nm_per_um = 1000;
// Where a formula for n meets a table for k, both are tabulated this finely: linear interpolation then misses the
// formulas of transparent media by less than 1e-6.
constexpr double joint_step_nm = 1;
constexpr double longest_joint_nm = 1e5;  // bounds that table

struct Sample {
  double wavelength_nm = 0, value = 0;
};

// What the DATA entries say, before n and k are joined.
struct Content {
  std::optional<optics::DispersionFormula> formula;
  optics::WavelengthRange formula_range;
  std::vector<Sample> n, k;
};

class Reader {
 public:
  explicit Reader(const io::YamlDocument& document) : document_(document) {}

  Result<Content> read() {
    const io::YamlNode* data =
        document_.root.kind == io::YamlNode::Kind::mapping ? io::find(document_.root, "DATA") : nullptr;
    if (data == nullptr || data->kind != io::YamlNode::Kind::sequence || data->items.empty())
      return Diagnostics{
          at(data ? *data : document_.root, "expected a list DATA as in a file of refractiveindex.info")};
    for (const io::YamlNode& entry : data->items) read_entry(entry);
    if (errors_.empty() && !content_.formula && content_.n.empty())
      errors_.push_back(at(*data, "expected an entry that gives n"));
    if (!errors_.empty()) return errors_;
    return content_;
  }

 private:
  Diagnostic at(const io::YamlNode& node, std::string message) const {
    return io::diagnostic_at(document_, node, std::move(message));
  }

  void read_entry(const io::YamlNode& entry) {
    const bool mapping = entry.kind == io::YamlNode::Kind::mapping;
    const io::YamlNode* type = mapping ? io::find(entry, "type") : nullptr;
    if (type == nullptr) return errors_.push_back(at(entry, "expected an entry with a type"));
    const std::string name = lower(trim(type->text));
    const bool gives_n = name != "tabulated k", gives_k = name == "tabulated k" || name == "tabulated nk";
    if ((gives_n && (content_.formula || !content_.n.empty())) || (gives_k && !content_.k.empty()))
      return errors_.push_back(at(entry, "n or k is given twice"));
    if (name.starts_with("formula ")) return read_formula(entry, *type, name);
    if (name != "tabulated n" && !gives_k)
      return errors_.push_back(at(*type, "expected 'formula 1', 'tabulated n', 'tabulated k' or 'tabulated nk', got '" +
                                             printable(type->text, 60) + "'"));
    read_table(entry, gives_n, gives_k);
  }

  // The numbers of a scalar such as "0.2 1.1", or nothing and an error.
  std::optional<std::vector<double>> numbers(const io::YamlNode& entry, std::string_view key) {
    const io::YamlNode* node = io::find(entry, key);
    if (node == nullptr) {
      errors_.push_back(at(entry, "expected " + std::string(key)));
      return {};
    }
    std::vector<double> values;
    for (const std::string_view word : words(node->text)) {
      const std::optional<double> value = parse_number(word);
      if (!value) {
        errors_.push_back(at(*node, "expected numbers, got '" + printable(word, 60) + "'"));
        return {};
      }
      values.push_back(*value);
    }
    return values;
  }

  static std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> result;
    for (std::size_t begin = 0; (begin = text.find_first_not_of(" \t\r\n", begin)) != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
      result.push_back(text.substr(begin, end - begin));
      begin = end;
    }
    return result;
  }

  void read_formula(const io::YamlNode& entry, const io::YamlNode& type, const std::string& name) {
    // Older files of that database say `range`.
    const char* range_key =
        io::find(entry, "wavelength_range") == nullptr && io::find(entry, "range") ? "range" : "wavelength_range";
    const auto range = numbers(entry, range_key);
    auto coefficients = numbers(entry, "coefficients");
    if (!range || !coefficients) return;
    if (range->size() != 2 || !((*range)[0] > 0) || !((*range)[1] > (*range)[0]))
      return errors_.push_back(at(entry, "expected a wavelength_range of two rising numbers > 0"));
    const std::optional<long long> number = parse_integer(trim(std::string_view(name).substr(8)));
    if (!number || *number < 0 || *number > 99) return errors_.push_back(at(type, "expected the number of a formula"));
    Result<optics::DispersionFormula> formula =
        optics::dispersion_formula(static_cast<int>(*number), *std::move(coefficients));
    if (!formula) {
      for (const Diagnostic& error : formula.errors()) errors_.push_back(at(type, error.message));
      return;
    }
    content_.formula = *formula;
    content_.formula_range = {(*range)[0] * nm_per_um, (*range)[1] * nm_per_um};
  }

  void read_table(const io::YamlNode& entry, bool gives_n, bool gives_k) {
    const auto values = numbers(entry, "data");
    if (!values) return;
    const std::size_t width = gives_n && gives_k ? 3 : 2;
    const io::YamlNode& data = *io::find(entry, "data");
    if (values->empty() || values->size() % width != 0)
      return errors_.push_back(at(data, "expected rows of " + std::to_string(width) + " numbers"));
    double previous_nm = 0;
    for (std::size_t i = 0; i < values->size(); i += width) {
      const double wavelength_nm = (*values)[i] * nm_per_um;
      if (!(wavelength_nm > previous_nm)) {
        const std::string row = "row " + std::to_string(i / width + 1) + ": ";
        return errors_.push_back(at(data, row + "expected rising wavelengths > 0"));
      }
      previous_nm = wavelength_nm;
      if (gives_n) content_.n.push_back({wavelength_nm, (*values)[i + 1]});
      if (gives_k) content_.k.push_back({wavelength_nm, (*values)[i + width - 1]});
    }
  }

  const io::YamlDocument& document_;
  Content content_;
  Diagnostics errors_;
};

// Linear in wavelength; beyond its ends a table holds its end value.
double interpolated(const std::vector<Sample>& table, double wavelength_nm) {
  const auto next = std::lower_bound(table.begin(), table.end(), wavelength_nm,
                                     [](const Sample& sample, double nm) { return sample.wavelength_nm < nm; });
  if (next == table.begin()) return table.front().value;
  if (next == table.end()) return table.back().value;
  const Sample &a = *(next - 1), &b = *next;
  return a.value + (b.value - a.value) * ((wavelength_nm - a.wavelength_nm) / (b.wavelength_nm - a.wavelength_nm));
}

// The wavelengths at which n and k are joined: all of both tables, or a fine grid of the formula with those of k.
std::vector<double> joint_wavelengths_nm(const Content& content) {
  std::vector<double> wavelengths_nm;
  for (const Sample& sample : content.n) wavelengths_nm.push_back(sample.wavelength_nm);
  for (const Sample& sample : content.k) wavelengths_nm.push_back(sample.wavelength_nm);
  if (content.formula) {
    const double last_nm = std::min(content.formula_range.last_nm, longest_joint_nm);
    for (double nm = std::ceil(content.formula_range.first_nm); nm < last_nm; nm += joint_step_nm)
      wavelengths_nm.push_back(nm);
    wavelengths_nm.push_back(content.formula_range.first_nm);
    wavelengths_nm.push_back(content.formula_range.last_nm);
    // A formula says nothing beyond its range, whatever k's table covers.
    std::erase_if(wavelengths_nm,
                  [&](double nm) { return nm < content.formula_range.first_nm || nm > content.formula_range.last_nm; });
  }
  std::sort(wavelengths_nm.begin(), wavelengths_nm.end());
  wavelengths_nm.erase(std::unique(wavelengths_nm.begin(), wavelengths_nm.end()), wavelengths_nm.end());
  return wavelengths_nm;
}

Result<optics::Medium> joined(const Content& content, optics::MediumDescription description) {
  if (content.formula && content.k.empty())
    return optics::Medium::formula(*content.formula, content.formula_range, std::move(description));
  std::vector<optics::IndexSample> rows;
  for (const double nm : joint_wavelengths_nm(content)) {
    const double n = content.formula ? content.formula->index(nm) : interpolated(content.n, nm);
    rows.push_back({nm, n, content.k.empty() ? 0 : interpolated(content.k, nm)});
  }
  return optics::Medium::table(std::move(rows), std::move(description));
}

}  // namespace

Result<optics::Medium> read_nk_yaml(const std::filesystem::path& path) {
  const Result<io::YamlDocument> document = io::read_yaml(path);
  if (!document) return document.errors();
  const Result<Content> content = Reader(*document).read();
  if (!content) return content.errors();
  const io::YamlNode* references = io::find(document->root, "REFERENCES");
  return joined(*content, {path.filename().string(), "n and k from a file", references ? references->text : ""});
}

}  // namespace shabon::api
