#include "mesher/cells/set_names.hpp"

#include <gmock/gmock.h>

namespace pcvt {
namespace {

using ::testing::Optional;
using ::testing::StartsWith;

const std::vector<std::string> kNames{"matrix", "Soft"};

TEST(SetNames, EveryFormOfANameIsFoundWithoutRegardToCase) {
    for (const char* name :
         {"NALL",          "eall",   "Fixed",     "control_1",      "GRAIN_BOUNDARY",
          "triple_points", "cell_0", "CELL_12",   "phase_soft",     "PHASE_MATRIX",
          "orbit_3",       "ori_17", "seam_1_0",  "seam_-1_2_-3",   "back",
          "front",         "domain", "wall_left", "WALL_TOP_SIDES", "soft_sides"}) {
        EXPECT_TRUE(set_with_name(name, kNames)) << name;
    }
    EXPECT_THAT(set_with_name("CELL_12", {}), Optional(StartsWith("cell_12, the elements of a")));
}

TEST(SetNames, OtherNamesAreFree) {
    for (const char* name :
         {"soft",    "matrix",     "cell",       "cell_",      "cell_wall", "cell_1a",
          "phase_",  "phase_1",    "phase_hard", "seam_",      "seam_a_0",  "seam_1_",
          "seam__1", "seam_-",     "wall",       "wall_paper", "fixed_end", "sides",
          "_sides",  "hard_sides", "grains",     "GRAINS",     "backbone",  "steel-2"}) {
        EXPECT_FALSE(set_with_name(name, kNames)) << name;
    }
}

}  // namespace
}  // namespace pcvt
