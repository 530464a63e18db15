// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/user_expressions.h"

#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace myoface;
    fuzz::guarded([&] {
        const Expression expression =
            user_expression_from_json({reinterpret_cast<const char*>(data), size}, "f.json");
        for (const auto& [muscle, rate] : expression.rates) {
            fuzz::require(muscle >= 0 && rate >= -0.5 && rate <= 1.0);
        }
    });
    return 0;
}
