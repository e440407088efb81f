// Stack expressions with unknown thicknesses.
#include <gtest/gtest.h>

#include <string>

#include "shabon/base/text.h"
#include "shabon/optics/stack_expression.h"

namespace shabon::optics {
namespace {

// "0,2; 3 100..900": layers and range of each unknown.
std::string unknowns_of(std::string_view text) {
  const auto parsed = parse_stack_with_unknowns(text);
  if (!parsed) return to_text(parsed.errors().front());
  std::string shown;
  for (const UnknownThickness& unknown : parsed->unknowns) {
    shown += shown.empty() ? "" : "; ";
    for (const std::size_t layer : unknown.layers) {
      EXPECT_EQ(parsed->stack.layers.at(layer).thickness_nm, 0);
      shown += (layer == unknown.layers.front() ? "" : ",") + std::to_string(layer);
    }
    EXPECT_TRUE(text.substr(unknown.offset).starts_with("?") || unknown.range) << text;
    if (unknown.range)
      shown += " " + format_number(unknown.range->low_nm) + ".." + format_number(unknown.range->high_nm);
  }
  return shown;
}

TEST(StackExpression, ReadsUnknownThicknesses) {
  EXPECT_EQ(unknowns_of("air | water ? | air"), "0");
  EXPECT_EQ(unknowns_of("air | water 100..900nm | air"), "0 100..900");
  EXPECT_EQ(unknowns_of("air | water 0.1 .. .5 um | air"), "0 100..500");
  EXPECT_EQ(unknowns_of("air | 1.5 0..2e3nm incoherent | air"), "0 0..2000");
  EXPECT_EQ(unknowns_of("air | SiO2 5nm | 2.1 ? | Si 3nm | 1.4 1..2um | glass"), "1; 3 1000..2000");
  EXPECT_EQ(unknowns_of("air | (ZnS ? | MgF2 99nm)^3 | glass"), "0,2,4");
  EXPECT_EQ(unknowns_of("air | ((ZnS ? | 1.5 1..9nm)^2 | 1.6 1nm)^2 | 2 ? | glass"), "0,2,5,7; 1,3,6,8 1..9; 10");
  EXPECT_EQ(unknowns_of("air | water 3nm | air"), "");
}

TEST(StackExpression, UnknownThicknessesHaveAForm) {
  const auto place = [](std::string_view text) {
    const auto parsed = parse_stack_with_unknowns(text);
    EXPECT_FALSE(parsed.ok()) << text;
    return parsed ? "" : std::to_string(parsed.errors().front().column) + " " + parsed.errors().front().message;
  };
  EXPECT_EQ(place("? | water ? | air").substr(0, 20), "1 expected a medium ");
  EXPECT_EQ(place("air ? | water ? | air").substr(0, 24), "5 expected no thickness:");
  EXPECT_EQ(place("air | water ? | air ?").substr(0, 25), "21 expected no thickness:");
  EXPECT_EQ(place("air | water 9..3nm | air"), "16 expected a range that rises, such as 100..900nm");
  EXPECT_EQ(place("air | water -1..3nm | air").substr(0, 28), "13 expected a thickness >= 0");
  EXPECT_EQ(place("air | water 1..3 | air").substr(0, 27), "18 expected a unit of lengt");
  EXPECT_EQ(place("air | water 1..nm | air").substr(0, 40), "16 expected the upper end of a range suc");
  EXPECT_EQ(place("air | water 1 . 3nm | air").substr(0, 30), "15 expected a range such as 10");
  EXPECT_EQ(place("air | water 1..3m | air").substr(0, 27), "17 expected a unit of lengt");
  // A plain stack has none.
  for (const char* text : {"air | water ? | air", "air | water 1..3nm | air", "air | water 1nm ? | air"})
    EXPECT_FALSE(parse_stack(text).ok()) << text;
}

}  // namespace
}  // namespace shabon::optics
