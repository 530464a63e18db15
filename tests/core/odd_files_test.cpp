// SPDX-License-Identifier: Apache-2.0
#include "odd_files.h"

#include <chrono>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/io/mesh_file.h"

namespace myoface {
namespace {

TEST(OddFiles, AreManyAndDifferent) {
    const auto files = test::odd_files();
    EXPECT_GE(files.size(), 120U);
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_FALSE(files[i].bytes == files[k].bytes) << files[i].name << " " << files[k].name;
        }
    }
}

TEST(OddFiles, AreReadOrRefusedWithOneSentence) {
    for (const test::OddFile& file : test::odd_files()) {
        const auto start = std::chrono::steady_clock::now();
        std::string problem;
        try {
            const Scan scan = read_mesh_bytes(file.bytes, file.name);
            EXPECT_TRUE(scan.mesh.vertices.allFinite()) << file.name;
            EXPECT_LT(scan.mesh.triangles.maxCoeff(), scan.mesh.vertex_count()) << file.name;
            EXPECT_EQ(static_cast<int>(scan.triangle_part.size()), scan.mesh.triangle_count());
            describe(scan);
        } catch (const IoError& error) {
            problem = error.what();
        }
        EXPECT_EQ(problem.empty(), file.good) << file.name << ": " << problem << "\n"
                                              << file.bytes.substr(0, 200);
        if (!problem.empty()) {
            EXPECT_EQ(problem.find(file.name), 0U) << problem;
            EXPECT_EQ(problem.back(), '.') << problem;
            EXPECT_EQ(problem.find('\n'), std::string::npos) << problem;
        }
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << file.name;
    }
}

}  // namespace
}  // namespace myoface
