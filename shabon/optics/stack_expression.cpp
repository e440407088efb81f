#include "shabon/optics/stack_expression.h"

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shabon/base/text.h"
#include "shabon/optics/expression_reader.h"
#include "shabon/optics/media.h"
#include "shabon/optics/stack_element.h"

namespace shabon::optics {

namespace {

constexpr std::size_t most_bytes = 1 << 20;
constexpr std::size_t most_nested_groups = 100;
constexpr int most_repeats = 1000;
constexpr std::string_view count_form = "'^' and a count 1..1000 after ')'";

// Elements, bars and groups. Groups lie on a stack of their own, so that no input makes the parser recurse.
class StackParser {
 public:
  StackParser(std::string_view text, const MediumResolver& resolver, bool unknowns_allowed)
      : reader_(text), elements_(reader_, resolver, unknowns_allowed) {}

  Result<StackWithUnknowns> parse();

 private:
  struct OpenGroup {
    std::size_t begin;
    std::size_t first_layer;
  };

  void parse_operand();
  bool parse_after_operand();
  void open_group();
  void close_group();
  int parse_count();
  void repeat(std::size_t first_layer, int count, std::size_t offset);
  void add(StackElement element);
  void add(Layer layer, std::size_t unknown);
  void add_layer(const StackElement& element);
  bool room_for(std::size_t layers, std::size_t offset);
  void set_outer(const StackElement& element, Medium& medium, const char* which);
  void finish();

  static constexpr std::size_t known = std::numeric_limits<std::size_t>::max();

  ExpressionReader reader_;
  StackElementParser elements_;
  Stack stack_;
  std::vector<UnknownThickness> unknowns_;
  std::vector<std::size_t> unknown_of_layer_;  // index into unknowns_ or `known`, for each layer
  std::vector<OpenGroup> groups_;
  std::optional<StackElement> last_;  // the last element outside groups: a layer, or the exit medium if none follows
  bool has_incidence_ = false;
  bool too_many_layers_ = false;
  // One slip, one message: set by what would only be told again.
  bool lacks_operand_ = false;  // the operand before, too
  bool lacks_count_ = false;    // the ')' before, too
  bool lacks_opening_ = false;
  bool lacks_incidence_ = false;
};

Result<StackWithUnknowns> StackParser::parse() {
  do {
    parse_operand();
  } while (!reader_.stopped() && parse_after_operand());
  if (!reader_.stopped()) finish();
  if (reader_.has_problems()) return reader_.take_problems();
  for (std::size_t i = 0; i < unknown_of_layer_.size(); ++i)
    if (unknown_of_layer_[i] != known) unknowns_[unknown_of_layer_[i]].layers.push_back(i);
  return StackWithUnknowns{std::move(stack_), std::move(unknowns_)};
}

// An element, with the groups that open before it.
void StackParser::parse_operand() {
  reader_.skip_space();
  while (reader_.at('(') && !reader_.stopped()) {
    open_group();
    reader_.skip_space();
  }
  if (reader_.stopped()) return;
  const bool lacks_operand = reader_.at_end() || reader_.at('|') || reader_.at(')');
  StackElement broken;
  broken.begin = reader_.offset();
  broken.broken = true;
  add(lacks_operand && lacks_operand_ ? broken : elements_.parse());
  lacks_operand_ = lacks_operand;
  lacks_count_ = lacks_opening_ = false;
}

// The ends of groups and the bar. True when another operand follows.
bool StackParser::parse_after_operand() {
  for (;;) {
    reader_.skip_space();
    if (reader_.stopped() || reader_.at_end()) return false;
    if (reader_.at(')')) {
      close_group();
    } else if (reader_.at('|')) {
      reader_.advance();
      return true;
    } else {
      reader_.expected("'|'", reader_.offset());
      if (reader_.at('(')) return true;
      reader_.skip_element();
    }
  }
}

void StackParser::open_group() {
  const std::size_t begin = reader_.offset();
  reader_.advance();
  if (groups_.size() == most_nested_groups) {
    reader_.problem(begin, "expected at most " + std::to_string(most_nested_groups) + " groups within each other");
    reader_.stop();
    return;
  }
  if (groups_.empty()) {
    if (!has_incidence_) {
      reader_.problem(begin, "expected a first medium without thickness before a group");
      lacks_incidence_ = true;
    }
    has_incidence_ = true;
    if (last_) add_layer(*last_);
    last_.reset();
  }
  groups_.push_back({begin, stack_.layers.size()});
}

void StackParser::close_group() {
  const std::size_t begin = reader_.offset();
  reader_.advance();
  reader_.skip_space();
  if (groups_.empty()) {
    if (!lacks_opening_) reader_.problem(begin, "expected '(' before this ')'");
    lacks_opening_ = true;
    if (reader_.at('^')) parse_count();
    return;
  }
  const OpenGroup group = groups_.back();
  groups_.pop_back();
  const std::size_t count_begin = reader_.offset();
  repeat(group.first_layer, parse_count(), count_begin);
}

// After ')': the count, or 1 after a problem.
int StackParser::parse_count() {
  if (!reader_.at('^')) {
    if (!lacks_count_) reader_.expected(std::string(count_form), reader_.offset());
    lacks_count_ = true;
    return 1;
  }
  reader_.advance();
  reader_.skip_space();
  const std::size_t begin = reader_.offset();
  const auto count = parse_integer(reader_.take_until_delimiter());
  if (count && *count >= 1 && *count <= most_repeats) return static_cast<int>(*count);
  reader_.expected("a whole number 1..1000 after '^'", begin);
  return 1;
}

void StackParser::repeat(std::size_t first_layer, int count, std::size_t offset) {
  const std::size_t period = stack_.layers.size() - first_layer;
  if (!room_for(period * static_cast<std::size_t>(count - 1), offset)) return;
  stack_.layers.reserve(first_layer + period * static_cast<std::size_t>(count));
  for (std::size_t i = period; i < period * static_cast<std::size_t>(count); ++i)
    add(stack_.layers[first_layer + i - period], unknown_of_layer_[first_layer + i - period]);
}

void StackParser::add(StackElement element) {
  if (!groups_.empty()) {
    add_layer(element);
  } else if (!has_incidence_) {
    has_incidence_ = true;
    set_outer(element, stack_.incidence, "first");
    if (element.medium && !(element.medium->index(rendered_range_nm.first_nm).real() > 0))
      reader_.expected("a first medium that lets light travel (n > 0)", element.begin);
  } else {
    if (last_) add_layer(*last_);
    last_ = std::move(element);
  }
}

void StackParser::add_layer(const StackElement& element) {
  if (!element.broken && !element.thickness_begin)
    reader_.problem(element.medium_end, "expected " + std::string(thickness_form) + " after the medium");
  if (!room_for(1, element.begin)) {
    reader_.stop();
    return;
  }
  if (element.unknown) unknowns_.push_back(*element.unknown);
  add(Layer{element.medium.value_or(Medium()), element.thickness_nm, element.coherent},
      element.unknown ? unknowns_.size() - 1 : known);
}

void StackParser::add(Layer layer, std::size_t unknown) {
  stack_.layers.push_back(std::move(layer));
  unknown_of_layer_.push_back(unknown);
}

bool StackParser::room_for(std::size_t layers, std::size_t offset) {
  if (stack_.layers.size() + layers <= most_layers) return true;
  if (!too_many_layers_)
    reader_.problem(offset, "expected at most " + std::to_string(most_layers) + " layers, got " +
                                std::to_string(stack_.layers.size() + layers));
  too_many_layers_ = true;
  return false;
}

void StackParser::set_outer(const StackElement& element, Medium& medium, const char* which) {
  if (element.medium) medium = *element.medium;
  if (element.thickness_begin && !element.broken)
    reader_.problem(*element.thickness_begin, std::string("expected no thickness: the ") + which +
                                                  " medium fills the space on its side of the stack");
}

// The end of the text.
void StackParser::finish() {
  if (groups_.size() == 1)
    reader_.problem(groups_.front().begin, "expected ')' to close this '('");
  else if (!groups_.empty())
    reader_.problem(groups_.front().begin,
                    "expected ')' to close this '(' and " + std::to_string(groups_.size() - 1) + " more within it");
  if (!groups_.empty()) return;
  if (last_)
    set_outer(*last_, stack_.exit, "last");
  else if (stack_.layers.empty() && !reader_.has_problems())
    reader_.expected("'|' and a second medium, as in 'air | water 300nm | air'", reader_.offset());
  else if (!stack_.layers.empty() && !lacks_count_ && !lacks_incidence_)
    reader_.expected("'|' and a last medium without thickness after the group", reader_.offset());
}

Result<StackWithUnknowns> parse(std::string_view text, const MediumResolver& resolver, bool unknowns_allowed) {
  if (text.size() > most_bytes)
    return fail(Failure::content, "stack expression: expected at most " + std::to_string(most_bytes) + " bytes, got " +
                                      std::to_string(text.size()));
  if (trim(text).empty()) {
    ExpressionReader reader(text);
    reader.expected("a stack such as 'air | water 300nm | air'", 0);
    return reader.take_problems();
  }
  return StackParser(text, resolver, unknowns_allowed).parse();
}

}  // namespace

Result<Medium> resolve_from_library(std::string_view name_or_file, bool is_file) {
  if (is_file) return fail(Failure::content, "n-k files cannot be read here; expected a name or a number");
  return medium_named(name_or_file);
}

Result<Medium> parse_medium(std::string_view text, const MediumResolver& resolver) {
  if (text.size() > most_bytes)
    return fail(Failure::content, "medium: expected at most " + std::to_string(most_bytes) + " bytes, got " +
                                      std::to_string(text.size()));
  ExpressionReader reader(text);
  reader.skip_space();
  const std::optional<Medium> medium = StackElementParser(reader, resolver).parse_medium();
  reader.skip_space();
  if (!reader.has_problems() && !reader.at_end()) reader.expected("one medium and nothing after it", reader.offset());
  if (!reader.has_problems() && medium) return *medium;
  Diagnostics problems = reader.take_problems();
  for (Diagnostic& problem : problems)
    if (problem.source == "<stack>") problem.source = "<medium>";
  return problems;
}

Result<StackWithUnknowns> parse_stack_with_unknowns(std::string_view text, const MediumResolver& resolver) {
  return parse(text, resolver, true);
}

Result<Stack> parse_stack(std::string_view text, const MediumResolver& resolver) {
  Result<StackWithUnknowns> parsed = parse(text, resolver, false);
  if (!parsed) return parsed.errors();
  return std::move(parsed->stack);
}

}  // namespace shabon::optics
