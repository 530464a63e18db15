// SPDX-License-Identifier: Apache-2.0
// The kernels for processors with AVX2; compiled for them, called only on them. No fused multiply
// and add: the bits are those of the portable kernels.
#include <immintrin.h>

#include "lane_tasks.h"

namespace myoface {
namespace {

struct Lanes {
    __m256 v;
};

inline Lanes all(float value) {
    return {_mm256_set1_ps(value)};
}
inline Lanes load(const float* from) {
    return {_mm256_loadu_ps(from)};
}
inline void store(const Lanes& a, float* to) {
    _mm256_storeu_ps(to, a.v);
}
inline void store_past_cache(const Lanes& a, float* to) {
    _mm256_stream_ps(to, a.v);
}
inline Lanes operator+(const Lanes& a, const Lanes& b) {
    return {_mm256_add_ps(a.v, b.v)};
}
inline Lanes operator-(const Lanes& a, const Lanes& b) {
    return {_mm256_sub_ps(a.v, b.v)};
}
inline Lanes operator*(const Lanes& a, const Lanes& b) {
    return {_mm256_mul_ps(a.v, b.v)};
}
inline Lanes operator/(const Lanes& a, const Lanes& b) {
    return {_mm256_div_ps(a.v, b.v)};
}
inline Lanes max(const Lanes& a, const Lanes& b) {
    return {_mm256_max_ps(a.v, b.v)};
}
inline Lanes min(const Lanes& a, const Lanes& b) {
    return {_mm256_min_ps(a.v, b.v)};
}
inline Lanes abs(const Lanes& a) {
    return {_mm256_andnot_ps(_mm256_set1_ps(-0.0F), a.v)};
}
inline Lanes sqrt(const Lanes& a) {
    return {_mm256_sqrt_ps(a.v)};
}
inline Lanes copy_sign(const Lanes& size, const Lanes& sign) {
    const __m256 bit = _mm256_set1_ps(-0.0F);
    return {_mm256_or_ps(_mm256_andnot_ps(bit, size.v), _mm256_and_ps(bit, sign.v))};
}
inline Lanes where_positive(const Lanes& a, const Lanes& value) {
    return {_mm256_and_ps(_mm256_cmp_ps(a.v, _mm256_setzero_ps(), _CMP_GT_OQ), value.v)};
}
inline double sum(const Lanes& a) {
    const __m256d four = _mm256_add_pd(_mm256_cvtps_pd(_mm256_castps256_ps128(a.v)),
                                       _mm256_cvtps_pd(_mm256_extractf128_ps(a.v, 1)));
    const __m128d two = _mm_add_pd(_mm256_castpd256_pd128(four), _mm256_extractf128_pd(four, 1));
    return _mm_cvtsd_f64(_mm_add_sd(two, _mm_unpackhi_pd(two, two)));
}

/// Transposes the 4×4 blocks in both halves of four registers.
inline void transpose_blocks(__m256 a, __m256 b, __m256 c, __m256 d, Lanes* out) {
    const __m256 ab_low = _mm256_unpacklo_ps(a, b);
    const __m256 ab_high = _mm256_unpackhi_ps(a, b);
    const __m256 cd_low = _mm256_unpacklo_ps(c, d);
    const __m256 cd_high = _mm256_unpackhi_ps(c, d);
    out[0].v = _mm256_shuffle_ps(ab_low, cd_low, 0x44);
    out[1].v = _mm256_shuffle_ps(ab_low, cd_low, 0xEE);
    out[2].v = _mm256_shuffle_ps(ab_high, cd_high, 0x44);
    out[3].v = _mm256_shuffle_ps(ab_high, cd_high, 0xEE);
}
inline __m256 two_halves(const float* low, const float* high) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(low)), _mm_loadu_ps(high), 1);
}

/// Eight records of eight numbers, transposed.
inline void gather_records(const float* records, const std::int32_t* rows, Lanes* out) {
    const float* at[kLanes];
    for (int k = 0; k < kLanes; ++k) {
        at[k] = records + 8 * static_cast<std::int64_t>(rows[k]);
    }
    transpose_blocks(two_halves(at[0], at[4]), two_halves(at[1], at[5]), two_halves(at[2], at[6]),
                     two_halves(at[3], at[7]), out);
    transpose_blocks(two_halves(at[0] + 4, at[4] + 4), two_halves(at[1] + 4, at[5] + 4),
                     two_halves(at[2] + 4, at[6] + 4), two_halves(at[3] + 4, at[7] + 4), out + 4);
}
/// Four numbers of each of eight records, from `part` on; the last is not used.
inline void gather_halves(const float* records, int part, const std::int32_t* rows, Lanes* out) {
    const float* at[kLanes];
    for (int k = 0; k < kLanes; ++k) {
        at[k] = records + 8 * static_cast<std::int64_t>(rows[k]) + part;
    }
    transpose_blocks(two_halves(at[0], at[4]), two_halves(at[1], at[5]), two_halves(at[2], at[6]),
                     two_halves(at[3], at[7]), out);
}
inline void load_records(const float* records, Lanes* out) {
    transpose_blocks(two_halves(records, records + 32), two_halves(records + 8, records + 40),
                     two_halves(records + 16, records + 48), two_halves(records + 24, records + 56),
                     out);
    const float* second = records + 4;
    transpose_blocks(two_halves(second, second + 32), two_halves(second + 8, second + 40),
                     two_halves(second + 16, second + 48), two_halves(second + 24, second + 56),
                     out + 4);
}
/// Writes numbers 4 … 7 of eight records.
inline void store_halves(const Lanes* parts, float* records) {
    Lanes rows[4];
    transpose_blocks(parts[0].v, parts[1].v, parts[2].v, parts[3].v, rows);
    for (int k = 0; k < 4; ++k) {
        _mm_storeu_ps(records + 8 * k + 4, _mm256_castps256_ps128(rows[k].v));
        _mm_storeu_ps(records + 8 * k + 36, _mm256_extractf128_ps(rows[k].v, 1));
    }
}
inline void prefetch(const float* records, const std::int32_t* rows) {
    for (int k = 0; k < kLanes; ++k) {
        _mm_prefetch(
            reinterpret_cast<const char*>(records + 8 * static_cast<std::int64_t>(rows[k])),
            _MM_HINT_T0);
    }
}

}  // namespace
}  // namespace myoface

#include "lane_kernels.inc"

namespace myoface {

#ifdef MYOFACE_NATIVE_KERNELS
const LaneKernels& native_kernels() {
#else
const LaneKernels& avx2_kernels() {
#endif
    static constexpr LaneKernels kKernels{"AVX2",        forces,   forces_and_energy,
                                          damped_forces, row_sums, step};
    return kKernels;
}

}  // namespace myoface
