// SPDX-License-Identifier: Apache-2.0
// The kernels compiled for this very machine, to compare with those chosen at run time.
#include "physics/lane_kernels_avx2.cpp"
