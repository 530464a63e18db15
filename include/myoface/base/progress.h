// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <utility>

#include "myoface/base/error.h"

namespace myoface {

/// Tells how far a long piece of work is and lets somebody stop it. Safe to cancel from another
/// thread.
class Progress {
public:
    /// Called with a stage's name and the share done, 0 … 1.
    using Listener = std::function<void(const std::string& stage, double share)>;

    Progress() = default;
    explicit Progress(Listener listener) : listener_(std::move(listener)) {}

    /// Reports and checks for cancellation.
    /// @throws Cancelled when cancel() was called.
    void report(const std::string& stage, double share) const {
        if (cancelled_.load(std::memory_order_relaxed)) {
            throw Cancelled();
        }
        if (listener_) {
            listener_(stage, share);
        }
    }

    void cancel() { cancelled_.store(true, std::memory_order_relaxed); }

private:
    Listener listener_;
    std::atomic<bool> cancelled_{false};
};

}  // namespace myoface
