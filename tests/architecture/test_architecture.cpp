#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "source_tree.h"

namespace shabon::architecture {
namespace {

namespace fs = std::filesystem;

TEST(Architecture, TheHouseIsInOrder) {
  const Rooms rooms = parse_rooms(SHABON_ROOMS);
  ASSERT_EQ(rooms.at("base"), 0);
  for (const std::string& broken : broken_rules(SHABON_SOURCE_DIR, rooms)) ADD_FAILURE() << "shabon/" << broken;
}

// A small house of two files in order, in which each test breaks one rule.
class SmallHouse : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) / ("shabon_house_" + std::string(test_info_name()));
    fs::remove_all(root_);
    write("base/text.h", "#pragma once\n#include <string>\n");
    write("base/CMakeLists.txt", "shabon_room(base SOURCES parallel.cpp PACKAGES TBB::tbb)\n");
    write("base/parallel.cpp", "#include <oneapi/tbb/parallel_for.h>\n");
    write("math/packet.h", "#pragma once\n#include \"shabon/base/text.h\"\n");
    write("render/CMakeLists.txt", "set(SOURCES\n  kernel.cpp)\nshabon_variants(render SOURCES ${SOURCES})\n");
    write("render/kernel.cpp", "#include \"shabon/math/packet.h\"\n#include <embree3/rtcore.h>\n");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / "shabon" / path).parent_path());
    std::ofstream(root_ / "shabon" / path) << text;
  }

  // The one rule that is broken, or all of them when it is not one.
  std::string broken() const {
    std::string all;
    for (const std::string& line : broken_rules(root_, parse_rooms("base=0,math=1,io=1,optics=2,render=5"))) {
      all += (all.empty() ? "" : "\n") + line;
    }
    return all;
  }

 private:
  static const char* test_info_name() { return testing::UnitTest::GetInstance()->current_test_info()->name(); }
  fs::path root_;
};

TEST_F(SmallHouse, IsInOrder) { EXPECT_EQ(broken(), ""); }

TEST_F(SmallHouse, ALargerNumberIsRefused) {
  write("base/text.h", "#pragma once\n\n#include \"shabon/math/vec.h\"\n");
  write("math/vec.h", "#pragma once\n");
  EXPECT_EQ(broken(), "base/text.h:3: room 'base' (0) includes room 'math' (1)");
}

TEST_F(SmallHouse, AnEqualNumberIsRefused) {
  write("io/csv.h", "#pragma once\n");
  write("math/vec.h", "#pragma once\n#  include \"shabon/io/csv.h\"\n");
  EXPECT_EQ(broken(), "math/vec.h:2: room 'math' (1) includes room 'io' (1)");
}

TEST_F(SmallHouse, PlainRoomsUseTheStandardLibraryAlone) {
  write("optics/airy.h", "#pragma once\n#include <fmt/format.h>\n#include <immintrin.h>\n");
  EXPECT_EQ(broken(), "optics/airy.h:2: <fmt/format.h> is not the standard library");
}

TEST_F(SmallHouse, AFileInNoRoomIsRefused) {
  write("physics/airy.h", "#pragma once\n");
  EXPECT_EQ(broken(), "physics/airy.h:0: is in no room");
}

TEST_F(SmallHouse, AFileBesideTheRoomsIsRefused) {
  write("airy.h", "#pragma once\n");
  EXPECT_EQ(broken(), "airy.h:0: is in no room");
}

TEST_F(SmallHouse, AFileThatIsNoSourceIsRefused) {
  write("optics/airy.txt", "");
  EXPECT_EQ(broken(), "optics/airy.txt:0: is no source");
}

TEST_F(SmallHouse, AHeaderWithoutPragmaOnceIsRefused) {
  write("optics/airy.h", "// #pragma once\n");
  EXPECT_EQ(broken(), "optics/airy.h:0: lacks #pragma once");
}

TEST_F(SmallHouse, ALongFileIsRefused) {
  write("optics/airy.h", "#pragma once\n" + std::string(300, '\n'));
  EXPECT_EQ(broken(), "optics/airy.h:301: is longer than 300 lines");
}

TEST_F(SmallHouse, ASourceThatIsNotBuiltIsRefused) {
  write("optics/airy.cpp", "");
  write("optics/CMakeLists.txt", "shabon_room(optics SOURCES fairy.cpp)\n");
  EXPECT_EQ(broken(), "optics/airy.cpp:0: is not in its room's CMakeLists.txt");
}

TEST_F(SmallHouse, AnIncludeThatIsNotWrittenFromTheRootIsRefused) {
  write("optics/airy.h", "#pragma once\n#include \"stack.h\"\n");
  EXPECT_EQ(broken(), "optics/airy.h:2: \"stack.h\" is not written from the root: \"shabon/...\"");
}

TEST_F(SmallHouse, AnIncludeOfNothingIsRefused) {
  write("optics/airy.h", "#pragma once\n#include \"shabon/optics/stack.h\"\n");
  EXPECT_EQ(broken(), "optics/airy.h:2: \"shabon/optics/stack.h\" does not exist");
}

TEST_F(SmallHouse, OnlyRoomsWithVariantsSeePackets) {
  write("optics/airy.h", "#pragma once\n#include \"shabon/math/packet.h\"\n");
  write("optics/CMakeLists.txt", "shabon_room(optics SOURCES airy.cpp)\n");
  write("optics/airy.cpp", "#include \"shabon/optics/airy.h\"\n");
  EXPECT_EQ(broken(),
            "optics/airy.cpp:0: sees packets, whose layout follows the compiler's options; its room has no variants");
}

}  // namespace
}  // namespace shabon::architecture
