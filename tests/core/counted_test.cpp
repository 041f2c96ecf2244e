#include "core/counted.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

TEST(Counted, HasTheSingularForOneAlone) {
    EXPECT_EQ(counted(0, "material is", "materials are"), "0 materials are");
    EXPECT_EQ(counted(1, "material is", "materials are"), "1 material is");
    EXPECT_EQ(counted(2, "material is", "materials are"), "2 materials are");
}

}  // namespace
}  // namespace aoscore
