// SPDX-License-Identifier: Apache-2.0
#include <cfenv>

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    // A NaN that is made anywhere in the core ends the test run on the spot.
    feenableexcept(FE_INVALID | FE_DIVBYZERO);
    return RUN_ALL_TESTS();
}
