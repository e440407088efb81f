#include "shabon/optics/interference.h"

#include <gtest/gtest.h>

namespace shabon::optics {
namespace {

TEST(InterferenceModels, ListFollowsTheEnumeration) {
  for (std::size_t i = 0; i < interference_models.size(); ++i) {
    const InterferenceEntry& entry = interference_models[i];
    EXPECT_EQ(static_cast<std::size_t>(entry.value), i);
    EXPECT_EQ(name_of(entry.value), entry.name);
    EXPECT_EQ(find_interference(entry.name), entry.value);
    EXPECT_FALSE(entry.description.empty());
  }
  EXPECT_EQ(find_interference("Two-Beam"), Interference::two_beam);
  EXPECT_FALSE(find_interference("two_beam"));
}

}  // namespace
}  // namespace shabon::optics
