// SPDX-License-Identifier: Apache-2.0
// Broken cases, plans, landmark files and journals: each is refused with its own sentence.
#include "bad_files.h"

#include <chrono>
#include <set>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/cases/journal.h"
#include "myoface/io/text_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

void open(const test::BadFile& file, const test::TemporaryFolder& folder) {
    switch (file.kind) {
        case test::BadKind::Case:
            write_file(folder / file.name, file.bytes);
            read_case((folder / file.name).string());
            break;
        case test::BadKind::Plan:
            recorded_plan_from_json(file.bytes, file.name);
            break;
        case test::BadKind::Landmarks:
            landmarks_from_json(file.bytes, file.name);
            break;
        case test::BadKind::Journal: {
            const std::filesystem::path journal = folder / file.name;
            std::filesystem::create_directories(journal);
            write_file(journal / "face.myoface", test::good_case());
            write_file(journal / "state", file.bytes);
            recover({journal, file.name, 1, "", false});
            break;
        }
    }
}

TEST(BadFiles, AreManyAndDifferent) {
    const auto files = test::bad_files();
    EXPECT_GE(files.size(), 150U);
    std::set<std::pair<test::BadKind, std::string>> different;
    for (const test::BadFile& file : files) {
        different.emplace(file.kind, file.bytes);
    }
    EXPECT_EQ(different.size(), files.size());
}

TEST(BadFiles, AreSpokenOfOnOneLine) {
    EXPECT_STREQ(IoError("a\nb\t\x7F.").what(), "a?b??.");
    EXPECT_STREQ(InvalidInput("顔").what(), "顔");
    std::string name;
    while (name.size() < 5000) {
        name += "顔";  // three bytes each
    }
    const std::string cut = InvalidInput(name).what();
    EXPECT_LT(cut.size(), 2010U);
    EXPECT_EQ(cut, name.substr(0, 1998) + "…");
}

TEST(BadFiles, AreRefusedEachWithItsSentence) {
    const test::TemporaryFolder folder;
    for (const test::BadFile& file : test::bad_files()) {
        const auto start = std::chrono::steady_clock::now();
        std::string sentence;
        try {
            open(file, folder);
        } catch (const Error& error) {
            sentence = error.what();
        }
        EXPECT_NE(sentence.find(file.says), std::string::npos)
            << file.name << " should say '" << file.says << "' and says: " << sentence << "\n"
            << file.bytes.substr(0, 120);
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        EXPECT_TRUE(!sentence.empty() && (sentence.back() == '.' || sentence.back() == ')'))
            << sentence;
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10)) << file.name;
    }
}

TEST(BadFiles, AreMadeFromGoodOnes) {
    const test::TemporaryFolder folder;
    write_file(folder / "good.myoface", test::good_case());
    const OpenedFace face = read_case((folder / "good.myoface").string());
    EXPECT_DOUBLE_EQ(face.state.shape(0, 1), 0.5);
    EXPECT_EQ(face.state.plan.edits.size(), 1U);
    EXPECT_EQ(recorded_plan_from_json(test::good_plan(), "p").edits.size(), 9U);
    EXPECT_EQ(landmarks_from_json(test::good_landmarks(), "l").landmarks.size(), 2U);
    test::BadFile journal{test::BadKind::Journal, "good", test::good_journal(), ""};
    EXPECT_NO_THROW(open(journal, folder));
}

}  // namespace
}  // namespace myoface
