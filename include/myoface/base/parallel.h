// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace myoface {

/// Number of threads that parallel_for() uses; at least 1. Starts as the number of processors,
/// at most 8; the environment variable MYOFACE_THREADS overrides it.
int thread_count();

/// Sets the number of threads for the whole process (1 … 64). Not to be called from inside
/// parallel_for().
void set_thread_count(int count);

/// Runs body(begin, end) over [0, count) in chunks whose bounds depend only on `count` and `grain`,
/// never on the number of threads: a body that writes only to its own elements gives the same bits
/// for any number of threads. Returns when all chunks are done. Nested calls run in the caller.
void parallel_for(int count, int grain, const std::function<void(int begin, int end)>& body);

}  // namespace myoface
