// SPDX-License-Identifier: Apache-2.0
#include "myoface/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace myoface {
namespace {

using Body = std::function<void(int, int)>;

/// One parallel loop in flight. Workers that wake late hold it alive and find nothing left to do.
struct Job {
    const Body* body = nullptr;
    int count = 0;
    int grain = 1;
    int chunks = 0;
    std::atomic<int> seats{0};  ///< for workers beside the caller
    std::atomic<int> next{0};
    std::atomic<int> done{0};

    void work() {
        for (;;) {
            const int chunk = next.fetch_add(1, std::memory_order_relaxed);
            if (chunk >= chunks) {
                return;
            }
            (*body)(chunk * grain, std::min(count, (chunk + 1) * grain));
            done.fetch_add(1, std::memory_order_release);
        }
    }
};

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

// When another program has the other processors, waiting for a worker that does not run costs more
// than it brings: such a loop is done alone for a while, then company is tried again.
constexpr double kLongWait = 150.0;    // [µs] for others, and …
constexpr double kWaitOverWork = 1.0;  // … as long as the caller's own work
constexpr double kUsuallyWaits = 0.4;  // share of a loop, on average
constexpr double kMemory = 0.05;       // of that average, a loop
constexpr std::chrono::microseconds kAlone{20'000};

constexpr int kSpins = 2000;  // some 20 microseconds: a pass over 10k nodes follows the last one

/// Leaves the core to its other thread for a moment.
inline void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

class Pool {
public:
    explicit Pool(int threads) {
        for (int i = 1; i < threads; ++i) {
            workers_.emplace_back([this] { serve(); });
        }
    }

    ~Pool() {
        {
            const std::lock_guard lock(mutex_);
            stop_ = true;
            ++generation_;
        }
        wake_.notify_all();
        for (std::thread& worker : workers_) {
            worker.join();
        }
    }

    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    int threads() const { return static_cast<int>(workers_.size()) + 1; }

    /// @param threads that may take part, the caller among them
    void run(int count, int grain, int threads, const Body& body) {
        auto job = std::make_shared<Job>();
        job->body = &body;
        job->count = count;
        job->grain = grain;
        job->chunks = (count + grain - 1) / grain;
        job->seats = threads - 1;
        const Clock::time_point start = Clock::now();
        if (start < alone_until_) {
            job->work();
            return;
        }
        {
            const std::lock_guard lock(mutex_);
            job_ = job;
            ++generation_;
        }
        wake_.notify_all();
        job->work();
        const Clock::time_point own = Clock::now();
        while (job->done.load(std::memory_order_acquire) < job->chunks) {
            std::this_thread::yield();
        }
        learn(Microseconds(own - start).count(), Clock::now() - own);
    }

private:
    /// From how long the caller worked and then waited in one loop: whether company pays.
    void learn(double worked, Clock::duration waited) {
        const double waiting = Microseconds(waited).count();
        waiting_share_ += kMemory * (waiting / (worked + waiting + 1e-3) - waiting_share_);
        if ((waiting > kLongWait && waiting > kWaitOverWork * worked) ||
            waiting_share_ > kUsuallyWaits) {
            alone_until_ = Clock::now() + kAlone;
            waiting_share_ = 0.0;
        }
    }

    void serve() {
        std::uint64_t seen = 0;
        for (;;) {
            for (int spin = 0; spin < kSpins && generation_.load() == seen; ++spin) {
                pause();
            }
            std::shared_ptr<Job> job;
            {
                std::unique_lock lock(mutex_);
                wake_.wait(lock, [&] { return generation_.load() != seen; });
                if (stop_) {
                    return;
                }
                seen = generation_.load();
                job = job_;
            }
            if (job && job->seats.fetch_sub(1) > 0) {
                job->work();
            }
        }
    }

    std::vector<std::thread> workers_;
    std::mutex mutex_;
    std::condition_variable wake_;
    std::shared_ptr<Job> job_;
    std::atomic<std::uint64_t> generation_{0};
    bool stop_ = false;
    // Of the caller, one at a time.
    Clock::time_point alone_until_{};
    double waiting_share_ = 0.0;
};

int initial_threads() {
    if (const char* text = std::getenv("MYOFACE_THREADS")) {
        const int wanted = std::atoi(text);
        if (wanted >= 1) {
            return std::min(wanted, 64);
        }
    }
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 8);
}

std::mutex pool_mutex;  // guards creation and exclusive use of the pool
std::unique_ptr<Pool> pool;
std::atomic<int> wanted_threads{0};
thread_local bool inside_loop = false;

}  // namespace

int thread_count() {
    int count = wanted_threads.load();
    if (count == 0) {
        count = initial_threads();
        wanted_threads.store(count);
    }
    return count;
}

void set_thread_count(int count) {
    wanted_threads.store(std::clamp(count, 1, 64));
}

void parallel_for(int count, int grain, const std::function<void(int, int)>& body) {
    if (count <= 0) {
        return;
    }
    grain = std::max(grain, 1);
    const int threads = thread_count();
    std::unique_lock lock(pool_mutex, std::defer_lock);
    if (threads == 1 || count <= grain || inside_loop || !lock.try_lock()) {
        for (int begin = 0; begin < count; begin += grain) {
            body(begin, std::min(count, begin + grain));
        }
        return;
    }
    if (!pool || pool->threads() < threads) {
        pool = std::make_unique<Pool>(threads);
    }
    inside_loop = true;
    pool->run(count, grain, threads, body);
    inside_loop = false;
}

}  // namespace myoface
