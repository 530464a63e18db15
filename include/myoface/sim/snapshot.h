// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "myoface/sim/simulator.h"

namespace myoface {

/// What a viewer needs of one moment of the simulation.
struct SimSnapshot {
    Points positions;           ///< 3×nodes [mm]
    std::vector<double> rates;  ///< contraction per muscle
    JawPose jaw;
    Wrinkles wrinkles;
    StepReport report;
    bool dragging = false;
    std::uint64_t frame = 0;
};

/// What is to be seen of a simulator now; `report` and `frame` are the caller's.
SimSnapshot snapshot_of(const Simulator& simulator);

/// Positions of the scan's vertices for given node positions: exactly the scan where nothing moved.
/// Loose parts that hang on the mandible turn with it.
Points scan_positions(const FaceModel& face, const Points& node_positions, const JawPose& jaw,
                      const Wrinkles& wrinkles = {});

/// Writes a face as it stands at a moment. While lips that were parted for the simulation touch,
/// the file has the vertices and faces of the scan as it came; once they open, the margins' own
/// vertices follow the scan's. @param as_came the scan before it was fitted @throws IoError
void write_face(const std::filesystem::path& file, const Scan& as_came, const FaceModel& face,
                const Points& node_positions, const JawPose& jaw, const Wrinkles& wrinkles = {});

/// A box with one place between two threads: the newest snapshot wins, so that a slow viewer never
/// makes a queue.
class SnapshotBox {
public:
    void put(std::shared_ptr<const SimSnapshot> snapshot) {
        const std::lock_guard lock(mutex_);
        newest_ = std::move(snapshot);
    }
    /// The newest one not yet taken, or null.
    std::shared_ptr<const SimSnapshot> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(newest_, nullptr);
    }

private:
    std::mutex mutex_;
    std::shared_ptr<const SimSnapshot> newest_;
};

}  // namespace myoface
