#include "shabon/optics/medium.h"

#include <utility>
#include <variant>

#include "shabon/base/text.h"
#include "shabon/optics/medium_index.h"
#include "shabon/optics/range_note.h"

namespace shabon::optics {

struct Medium::Content {
  MediumDescription description;
  MediumIndex index;
};

namespace {

// Of the volume of a mixture. A continued formula is rarely off by 0.01, which moves the mixture's index by 2e-4 then.
constexpr double too_little_to_tell = 0.02;

// A medium of its own has one source; a mixture is told part by part.
template <class Asked>
std::string note_of(const Medium& medium, const MediumIndex& index, const Asked& asked) {
  const auto range = medium.range_nm();
  if (!range) return {};
  if (const auto* mixture = std::get_if<MixtureIndex>(&index)) {
    std::string text;
    for (const MixturePart& part : mixture->parts) {
      if (part.fraction <= too_little_to_tell) continue;
      const std::string note = part.medium.outside_range_note(asked);
      if (!note.empty()) text += (text.empty() ? medium.name() + ": " : ", and ") + note;
    }
    return text;
  }
  const AskedOutside outside = asked_outside(*range, asked);
  if (!outside.below && !outside.above) return {};
  std::string text = medium.name() + ": its source covers " + format_number(range->first_nm, 6) + ".." +
                     format_number(range->last_nm, 6) + " nm";
  const auto add = [&](const auto& form) {
    if (outside.below) text += "; " + note_below(form, *outside.below);
    if (outside.above) text += "; " + note_above(form, *outside.above);
  };
  if (const auto* formula = std::get_if<FormulaIndex>(&index)) add(*formula);
  if (const auto* table = std::get_if<TableIndex>(&index)) add(*table);
  return text;
}

}  // namespace

Medium::Medium(std::shared_ptr<const Content> content) : content_(std::move(content)) {}

Medium::Medium() {
  static const Medium vacuum = constant(1, {"vacuum", "vacuum", "exactly 1 by definition"});
  content_ = vacuum.content_;
}

Medium Medium::constant(std::complex<double> index) {
  std::string name = format_number(index.real());
  if (index.imag() != 0) name = (index.real() == 0 ? "" : name + "+") + format_number(index.imag()) + "i";
  return constant(index, {std::move(name), "constant index", "given by the user"});
}

Medium Medium::constant(std::complex<double> index, MediumDescription description) {
  return Medium(std::make_shared<const Content>(Content{std::move(description), ConstantIndex{index}}));
}

Result<Medium> Medium::formula(DispersionFormula formula, WavelengthRange range, MediumDescription description,
                               std::vector<AbsorptionSample> absorption) {
  Result<FormulaIndex> index = formula_index(std::move(formula), range, std::move(absorption));
  if (!index) return index.errors();
  return Medium(std::make_shared<const Content>(Content{std::move(description), std::move(*index)}));
}

Result<Medium> Medium::table(std::vector<IndexSample> rows, MediumDescription description,
                             std::optional<WavelengthRange> range) {
  Result<TableIndex> index = table_index(std::move(rows), range);
  if (!index) return index.errors();
  return Medium(std::make_shared<const Content>(Content{std::move(description), std::move(*index)}));
}

Result<Medium> Medium::mixture(std::vector<MixturePart> parts, MediumDescription description) {
  Result<MixtureIndex> index = mixture_index(std::move(parts));
  if (!index) return index.errors();
  return Medium(std::make_shared<const Content>(Content{std::move(description), std::move(*index)}));
}

std::complex<double> Medium::index(double wavelength_nm) const {
  return std::visit([&](const auto& index) { return index_at(index, wavelength_nm); }, content_->index);
}

std::string_view Medium::form() const {
  return std::visit([](const auto& index) { return form_of(index); }, content_->index);
}

bool Medium::is_constant() const { return std::holds_alternative<ConstantIndex>(content_->index); }

bool Medium::is_lossless() const {
  return std::visit([](const auto& index) { return lossless(index); }, content_->index);
}

bool Medium::is_clear() const {
  if (is_lossless()) return true;
  for (double nm = rendered_range_nm.first_nm; nm <= rendered_range_nm.last_nm; ++nm)
    if (!(index(nm).imag() <= most_k_of_clear)) return false;
  return true;
}

Medium Medium::without_absorption() const {
  if (is_lossless()) return *this;
  return Medium(std::make_shared<const Content>(
      Content{content_->description,
              std::visit([](const auto& index) { return MediumIndex(lossless_form(index)); }, content_->index)}));
}

const std::string& Medium::name() const { return content_->description.name; }
const std::string& Medium::description() const { return content_->description.description; }
const std::string& Medium::source() const { return content_->description.source; }

std::optional<WavelengthRange> Medium::range_nm() const {
  return std::visit([](const auto& index) { return range_of(index); }, content_->index);
}

bool Medium::covers(double wavelength_nm) const {
  const auto range = range_nm();
  return !range || (wavelength_nm >= range->first_nm && wavelength_nm <= range->last_nm);
}

std::string Medium::outside_range_note(std::span<const double> wavelengths_nm) const {
  return note_of(*this, content_->index, wavelengths_nm);
}

std::string Medium::outside_range_note(WavelengthRange asked) const { return note_of(*this, content_->index, asked); }

bool operator==(const Medium& a, const Medium& b) {
  return a.content_ == b.content_ || a.content_->index == b.content_->index;
}

}  // namespace shabon::optics
