// SPDX-License-Identifier: Apache-2.0
#include "output.h"

#include <iostream>

#include "myoface/io/text_file.h"

namespace myoface::cli {

void write_text(const std::string& file, const std::string& text) {
    if (file.empty()) {
        std::cout << text;
    } else {
        write_file(file, text);
    }
}

}  // namespace myoface::cli
