// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/plan_file.h"

#include "fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace myoface;
    fuzz::guarded([&] {
        const RecordedPlan plan =
            recorded_plan_from_json({reinterpret_cast<const char*>(data), size}, "f.json");
        // What was read is written and read again to the same text.
        const std::string text = recorded_plan_to_json(plan);
        fuzz::require(recorded_plan_to_json(recorded_plan_from_json(text, "again")) == text);
    });
    return 0;
}
