// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "myoface/base/error.h"
#include "myoface/face/landmark_detection.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {

void add_landmarks(CLI::App& app) {
    auto* command = app.add_subcommand("landmarks", "Find landmarks by the shape of the face");
    auto arguments = std::make_shared<FaceArguments>();
    auto output = std::make_shared<std::string>();
    arguments->add_to(*command);
    command->add_option("-o", *output, "JSON file, instead of standard output");
    command->callback([arguments, output] {
        const OpenedFace face = arguments->open();
        const DetectedLandmarks found =
            detect_landmarks(face.scan->mesh, face.pose ? &*face.pose : nullptr);
        write_text(*output, landmarks_to_json(found.landmarks, face.scan->frame, found.confidence));
    });
}

}  // namespace myoface::cli
