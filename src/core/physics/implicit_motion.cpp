// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/implicit_motion.h"

namespace myoface {

ImplicitMotion::ImplicitMotion(const MassSpringModel& model, double damping)
    : model_(model), damping_(damping) {}

void ImplicitMotion::shift(const Points& way) {
    if (warm_) {
        before_ += way;
    }
}

void ImplicitMotion::begin(const MassSpringState& state, double step, Drive& drive) {
    now_ = state.positions;
    velocity_ = state.velocities;
    Points coast;
    if (warm_ && step == step_) {
        h_ = 2.0 / 3.0 * step;
        from_ = (4.0 * now_ - before_) / 3.0;
        coast = from_ + h_ / 3.0 * (4.0 * velocity_ - velocity_before_);
    } else {  // the first step: the formula of first order
        h_ = step;
        from_ = now_;
        coast = now_ + step * velocity_;
    }
    warm_ = true;
    step_ = step;
    const int n = model_.node_count();
    drive.inertia.resize(n);
    drive.ahead.resize(3, n);
    for (int i = 0; i < n; ++i) {
        const double mass = model_.mass[i] / (h_ * h_);
        const double damper = damping_ * model_.ties[i].damping / h_;
        drive.inertia[i] = mass + damper;
        drive.ahead.col(i) =
            (mass * coast.col(i) + damper * from_.col(i)) / (mass + damper) - model_.rest.col(i);
    }
}

void ImplicitMotion::end(MassSpringState& state) {
    before_ = now_;
    velocity_before_ = velocity_;
    state.velocities = (state.positions - from_) / h_;
    for (int i = 0; i < model_.node_count(); ++i) {
        if (model_.fixed[i] != 0) {
            state.velocities.col(i).setZero();
        }
    }
}

}  // namespace myoface
