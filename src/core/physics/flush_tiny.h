// SPDX-License-Identifier: Apache-2.0
#pragma once

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace myoface {

/// While it lives, numbers too small for the usual form count as zero on this thread. A force fades
/// from node to node until it reaches them, and processors are many times slower with them.
class FlushTiny {
public:
#ifdef __SSE2__
    FlushTiny() : before_(_mm_getcsr()) {
        constexpr unsigned kFlushResults = 0x8000;
        constexpr unsigned kFlushOperands = 0x0040;
        _mm_setcsr(before_ | kFlushResults | kFlushOperands);
    }
    ~FlushTiny() {
        _mm_setcsr(before_);
    }
#else
    FlushTiny() = default;
#endif
    FlushTiny(const FlushTiny&) = delete;
    FlushTiny& operator=(const FlushTiny&) = delete;

#ifdef __SSE2__
private:
    unsigned before_;
#endif
};

}  // namespace myoface
