// The mixture of a stack expression: mix(water 70%, glycerol 30%).
#include <cmath>
#include <string>

#include "shabon/base/text.h"
#include "shabon/optics/stack_element.h"

namespace shabon::optics {

namespace {

constexpr std::size_t most_parts = 16;
constexpr double percent = 100;
constexpr double largest_gap = 1e-4;  // percent by which shares may miss 100
constexpr const char* share_form = "a share of the volume such as 70%";

}  // namespace

// At the '(' after `mix`, which begins at `begin`. After a problem the rest of the mixture is skipped.
std::optional<Medium> StackElementParser::parse_mixture(std::size_t begin) {
  if (reader_.in_list()) {
    reader_.problem(begin, "expected no mixture within a mixture");
    reader_.skip_element();
    if (reader_.at(')')) reader_.advance();
    return {};
  }
  const std::size_t bracket = reader_.offset();
  reader_.advance();
  reader_.set_in_list(true);
  std::vector<MixturePart> parts;
  std::optional<std::size_t> without_share;
  bool understood = true;
  while (understood && parse_part(parts, without_share)) {
    if (reader_.at(')')) break;
    if (reader_.at(',')) {
      reader_.advance();
      continue;
    }
    if (reader_.at_end() || reader_.at('|'))
      reader_.problem(bracket, "expected ')' to close the mixture that starts here");
    else
      reader_.expected("',' or ')'", reader_.offset());
    understood = false;
  }
  understood = understood && reader_.at(')') && !reader_.has_problems_since(begin);
  if (!understood) reader_.skip_element();
  if (reader_.at(')')) reader_.advance();
  reader_.set_in_list(false);
  if (!understood) return {};
  return mixed(begin, std::move(parts), without_share);
}

// A medium and its share, up to the ',' or ')' that follows. False when the rest cannot be read.
bool StackElementParser::parse_part(std::vector<MixturePart>& parts, std::optional<std::size_t>& without_share) {
  reader_.skip_space();
  const std::size_t begin = reader_.offset();
  if (parts.size() == most_parts) {
    reader_.problem(begin, "expected at most " + std::to_string(most_parts) + " parts of a mixture");
    return false;
  }
  const std::optional<Medium> medium = parse_medium();
  if (!medium && !reader_.at_delimiter()) return false;
  parts.push_back({medium.value_or(Medium()), 0});
  reader_.skip_space();
  if (reader_.at_number()) {
    if (!parse_share(parts.back().fraction)) return false;
  } else if (reader_.at(')') && parts.size() > 1) {
    without_share = parts.size() - 1;
  } else {
    // A medium that was not understood has said what is wrong.
    if (medium) reader_.expected(share_form, reader_.offset());
    return false;
  }
  reader_.skip_space();
  return true;
}

bool StackElementParser::parse_share(double& fraction) {
  const std::size_t begin = reader_.offset();
  const std::string_view digits = reader_.take_number();
  const auto value = parse_number(digits);
  reader_.skip_space();
  if (!reader_.at('%')) {
    reader_.expected(value ? "'%' after the share" : share_form, value ? reader_.offset() : begin);
    return false;
  }
  reader_.advance();
  if (!value || !(*value >= 0 && *value <= percent)) {
    reader_.expected("a share of 0..100%", begin);
    return false;
  }
  fraction = *value / percent;
  return true;
}

std::optional<Medium> StackElementParser::mixed(std::size_t begin, std::vector<MixturePart> parts,
                                                std::optional<std::size_t> without_share) {
  double sum = 0;
  for (const MixturePart& part : parts) sum += part.fraction * percent;
  if (without_share ? sum > percent + largest_gap : !(std::abs(sum - percent) <= largest_gap)) {
    reader_.problem(begin, "expected shares that make up 100%, got " + format_number(sum, 6) + "%" +
                               (without_share ? "" : "; the last part may leave its share out"));
    return {};
  }
  if (without_share) parts[*without_share].fraction = std::max(0.0, 1 - sum / percent);
  std::string name = "mix(";
  for (std::size_t i = 0; i < parts.size(); ++i)
    name += (i ? ", " : "") + parts[i].medium.name() + " " + format_number(parts[i].fraction * percent, 6) + "%";
  const Result<Medium> medium = Medium::mixture(
      std::move(parts), {name + ")", "mixture by volume", "the rule of Lorentz and Lorenz, from its parts"});
  if (medium) return *medium;
  reader_.problems(begin, medium.errors());
  return {};
}

}  // namespace shabon::optics
