// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/mass_spring_model.h"

#include <cmath>
#include <numeric>
#include <string>

#include "myoface/base/error.h"

namespace myoface {

void index_rows(MassSpringModel& model) {
    const int n = model.node_count();
    model.spring_start.assign(static_cast<std::size_t>(n) + 1, 0);
    for (const Spring& s : model.springs) {
        ++model.spring_start[s.a + 1];
        ++model.spring_start[s.b + 1];
    }
    std::partial_sum(model.spring_start.begin(), model.spring_start.end(),
                     model.spring_start.begin());
    model.spring_ends.resize(2 * model.springs.size());
    std::vector<int> at(model.spring_start.begin(), model.spring_start.end() - 1);
    for (std::size_t s = 0; s < model.springs.size(); ++s) {
        const Spring& spring = model.springs[s];
        for (const auto& [from, to] :
             {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
            model.spring_ends[at[from]++] = {to, static_cast<int>(s), spring.stiffness,
                                             spring.length};
        }
    }
    model.contact_of.assign(static_cast<std::size_t>(n), -1);
    for (std::size_t c = 0; c < model.contacts.size(); ++c) {
        model.contact_of[model.contacts[c].a] = static_cast<int>(c);
        model.contact_of[model.contacts[c].b] = static_cast<int>(c);
    }
    if (model.linear.start.size() == 1) {
        model.linear.start.assign(static_cast<std::size_t>(n) + 1, 0);
    }
    if (model.layer.links.start.size() == 1) {
        model.layer.links.start.assign(static_cast<std::size_t>(model.skin_nodes) + 1, 0);
    }
    model.stretch.resize(static_cast<std::size_t>(n));
    model.ties.resize(static_cast<std::size_t>(n));
    model.fixed.resize(static_cast<std::size_t>(n), 0);
    model.label.resize(static_cast<std::size_t>(n));
}

void validate(const MassSpringModel& model) {
    const int n = model.node_count();
    if (model.mass.size() != n) {
        throw InvalidInput("The model has " + std::to_string(n) + " nodes but " +
                           std::to_string(model.mass.size()) + " masses.");
    }
    if (!model.rest.allFinite()) {
        throw InvalidInput("A rest position of the model is not finite.");
    }
    for (int i = 0; i < n; ++i) {
        if (!(model.mass[i] > 0.0) || !std::isfinite(model.mass[i])) {
            throw InvalidInput("The mass of node " + std::to_string(i) + " is not above zero.");
        }
    }
    for (std::size_t s = 0; s < model.springs.size(); ++s) {
        const Spring& spring = model.springs[s];
        if (spring.a < 0 || spring.b < 0 || spring.a >= n || spring.b >= n ||
            spring.a == spring.b) {
            throw InvalidInput("Spring " + std::to_string(s) + " does not join two nodes.");
        }
        if (!(spring.stiffness >= 0.0) || !(spring.length >= 0.0) || !(spring.damping >= 0.0) ||
            !std::isfinite(spring.stiffness + spring.length + spring.damping)) {
            throw InvalidInput("Spring " + std::to_string(s) +
                               " has a negative or non-finite constant.");
        }
    }
}

MassSpringState rest_state(const MassSpringModel& model) {
    MassSpringState state;
    state.positions = model.rest;
    state.velocities = Points::Zero(3, model.node_count());
    return state;
}

}  // namespace myoface
