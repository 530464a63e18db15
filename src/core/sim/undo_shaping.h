// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/sim/simulator.h"

namespace myoface {

/// Puts the face back on the way out, unless it was released: what cannot be done changes nothing.
class UndoShaping {
public:
    explicit UndoShaping(Simulator& simulator)
        : simulator_(simulator), skin_rest_(simulator.skin_rest()) {}
    ~UndoShaping() {
        if (armed_) {
            simulator_.set_load({});
            if (simulator_.dragging()) {
                simulator_.end_drag(false);
            }
            simulator_.set_skin_rest(skin_rest_);
            simulator_.settle();
        }
    }
    UndoShaping(const UndoShaping&) = delete;
    UndoShaping& operator=(const UndoShaping&) = delete;
    void release() { armed_ = false; }

private:
    Simulator& simulator_;
    Points skin_rest_;
    bool armed_ = true;
};

}  // namespace myoface
