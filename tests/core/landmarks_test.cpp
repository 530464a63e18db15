// SPDX-License-Identifier: Apache-2.0
#include "myoface/face/landmarks.h"

#include <gtest/gtest.h>

#include "myoface/base/error.h"

#include "test_meshes.h"

namespace myoface {
namespace {

TEST(LandmarkFile, ReadsShortAndLongNamesAndBothForms) {
    const LandmarkFile file = landmarks_from_json(
        R"({"unit":"cm","landmarks":{"prn":[1,2,3],"endocanthion_L":{"xyz":[4,5,6],
            "est_error_mm":2.5},"cheilion_R":[7,8,9],"my_mark":[0,0,0]}})",
        "l.json");
    EXPECT_DOUBLE_EQ(*file.mm_per_unit, 10.0);
    ASSERT_EQ(file.landmarks.size(), 3U);
    EXPECT_EQ(file.landmarks.at("en_l").position, Vec3(4, 5, 6));
    EXPECT_DOUBLE_EQ(file.landmarks.at("en_l").error_mm, 2.5);
    EXPECT_EQ(file.landmarks.at("ch_r").position, Vec3(7, 8, 9));
}

TEST(LandmarkFile, RefusesWhatItCannotUse) {
    for (const char* bad :
         {"", "[]", "{", R"({"landmarks":{"prn":[1,2]}})", R"({"landmarks":{"prn":["a",2,3]}})",
          R"({"landmarks":{"prn":[1e300,2,3]}})", R"({"landmarks":{}})", R"({"landmarks":[1]})",
          R"({"unit":"ell","landmarks":{"prn":[1,2,3]}})",
          R"({"unit":-1,"landmarks":{"prn":[1,2,3]}})"}) {
        EXPECT_THROW(landmarks_from_json(bad, "l.json"), IoError) << bad;
    }
}

TEST(LandmarkFile, ComesBackAsItWasWritten) {
    const FileFrame frame{10.0, Mat3::Identity()};
    const Landmarks& given = test::small_face().landmarks;
    const LandmarkFile back = landmarks_from_json(landmarks_to_json(given, frame), "l.json");
    const Landmarks again = in_model_frame(back, frame);
    ASSERT_EQ(again.size(), given.size());
    for (const auto& [name, landmark] : given) {
        EXPECT_LT((again.at(name).position - landmark.position).norm(), 1e-9);
    }
}

TEST(LandmarkNames, AreMirroredByTheirSide) {
    EXPECT_EQ(mirrored_name("en_l"), "en_r");
    EXPECT_EQ(mirrored_name("prn"), "prn");
    EXPECT_EQ(landmark_title("ch_r"), "mouth corner (right)");
}

}  // namespace
}  // namespace myoface
