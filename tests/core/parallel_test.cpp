// SPDX-License-Identifier: Apache-2.0
#include "myoface/base/parallel.h"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace myoface {
namespace {

class ParallelFor : public ::testing::Test {
protected:
    void TearDown() override { set_thread_count(before_); }
    int before_ = thread_count();
};

TEST_F(ParallelFor, VisitsEachIndexOnceWithAnyNumberOfThreads) {
    for (const int threads : {1, 2, 4}) {
        set_thread_count(threads);
        std::vector<int> visits(10007, 0);
        for (int repeat = 0; repeat < 50; ++repeat) {
            parallel_for(10007, 64, [&](int begin, int end) {
                for (int i = begin; i < end; ++i) {
                    ++visits[i];
                }
            });
        }
        for (const int count : visits) {
            ASSERT_EQ(count, 50);
        }
    }
}

TEST_F(ParallelFor, RunsNestedLoopsInTheCaller) {
    set_thread_count(2);
    std::atomic<int> sum{0};
    parallel_for(8, 1, [&](int begin, int end) {
        parallel_for(10, 2, [&](int b, int e) { sum += (e - b) * (end - begin); });
    });
    EXPECT_EQ(sum.load(), 80);
}

TEST_F(ParallelFor, DoesNothingForNothing) {
    parallel_for(0, 16, [](int, int) { FAIL(); });
}

}  // namespace
}  // namespace myoface
