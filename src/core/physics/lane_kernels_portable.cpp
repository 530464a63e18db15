// SPDX-License-Identifier: Apache-2.0
// The kernels for any processor.
#include <cmath>

#include "lane_tasks.h"

namespace myoface {
namespace {

struct Lanes {
    float v[kLanes];
};

template <typename Operation>
inline Lanes each(const Operation& operation) {
    Lanes result;
    for (int k = 0; k < kLanes; ++k) {
        result.v[k] = operation(k);
    }
    return result;
}
inline Lanes all(float value) {
    return each([&](int) { return value; });
}
inline Lanes load(const float* from) {
    return each([&](int k) { return from[k]; });
}
inline void store(const Lanes& a, float* to) {
    for (int k = 0; k < kLanes; ++k) {
        to[k] = a.v[k];
    }
}
inline void store_past_cache(const Lanes& a, float* to) {
    store(a, to);
}
inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return a.v[k] + b.v[k]; });
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return a.v[k] - b.v[k]; });
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return a.v[k] * b.v[k]; });
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return a.v[k] / b.v[k]; });
}
// As the processor's instructions have it: the second where neither is larger.
inline Lanes max(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return a.v[k] > b.v[k] ? a.v[k] : b.v[k]; });
}
inline Lanes min(const Lanes& a, const Lanes& b) {
    return each([&](int k) { return a.v[k] < b.v[k] ? a.v[k] : b.v[k]; });
}
inline Lanes abs(const Lanes& a) {
    return each([&](int k) { return std::fabs(a.v[k]); });
}
inline Lanes sqrt(const Lanes& a) {
    return each([&](int k) { return std::sqrt(a.v[k]); });
}
inline Lanes copy_sign(const Lanes& size, const Lanes& sign) {
    return each([&](int k) { return std::copysign(size.v[k], sign.v[k]); });
}
inline Lanes where_positive(const Lanes& a, const Lanes& value) {
    return each([&](int k) { return a.v[k] > 0.0F ? value.v[k] : 0.0F; });
}
inline double sum(const Lanes& a) {
    const double low =
        (static_cast<double>(a.v[0]) + a.v[4]) + (static_cast<double>(a.v[2]) + a.v[6]);
    const double high =
        (static_cast<double>(a.v[1]) + a.v[5]) + (static_cast<double>(a.v[3]) + a.v[7]);
    return low + high;
}

/// Eight records of eight numbers, transposed.
inline void gather_records(const float* records, const std::int32_t* rows, Lanes* out) {
    for (int part = 0; part < 8; ++part) {
        out[part] = each([&](int k) { return records[8 * rows[k] + part]; });
    }
}
/// Four numbers of each of eight records, from `part` on; the last is not used.
inline void gather_halves(const float* records, int part, const std::int32_t* rows, Lanes* out) {
    for (int p = 0; p < 3; ++p) {
        out[p] = each([&](int k) { return records[8 * rows[k] + part + p]; });
    }
}
inline void load_records(const float* records, Lanes* out) {
    for (int part = 0; part < 8; ++part) {
        out[part] = each([&](int k) { return records[8 * k + part]; });
    }
}
/// Writes numbers 4 … 7 of eight records.
inline void store_halves(const Lanes* parts, float* records) {
    for (int part = 0; part < 4; ++part) {
        for (int k = 0; k < kLanes; ++k) {
            records[8 * k + 4 + part] = parts[part].v[k];
        }
    }
}
inline void prefetch(const float* records, const std::int32_t* rows) {
    for (int k = 0; k < kLanes; ++k) {
        __builtin_prefetch(records + 8 * rows[k]);
    }
}

}  // namespace
}  // namespace myoface

#include "lane_kernels.inc"

namespace myoface {

const LaneKernels& portable_kernels() {
    static constexpr LaneKernels kKernels{"portable",    forces,   forces_and_energy,
                                          damped_forces, row_sums, step};
    return kKernels;
}

}  // namespace myoface
