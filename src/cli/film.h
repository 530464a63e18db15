// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "myoface/io/image.h"

namespace myoface::cli {

/// Pictures that follow each other, as a folder of PNG files (frame-000.png …) or, by the ending of
/// its name, as GIF or MP4. Films are made by ffmpeg, GIFs also by ImageMagick or gifski, whichever
/// is installed.
class Film {
public:
    /// @param frames_per_second 1 to 60
    /// @throws InvalidInput when the ending is another one or no encoder is installed
    Film(std::filesystem::path output, int frames_per_second);
    ~Film();
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// @throws IoError
    void add(const Image& picture);
    /// Encodes; the film appears whole or not at all. @throws IoError
    void finish();

private:
    std::filesystem::path frame(int number) const;

    std::filesystem::path output_, folder_;
    std::string encoder_;  ///< empty: a folder of pictures
    int rate_ = 25;
    int count_ = 0;
};

}  // namespace myoface::cli
