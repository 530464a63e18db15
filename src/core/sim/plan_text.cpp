// SPDX-License-Identifier: Apache-2.0
// Edits of a plan as the texts that people write.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"
#include "myoface/sim/plan.h"

#include "edit_text.h"

namespace myoface {
namespace {

constexpr std::array<std::string_view, 3> kPaths{"free", "normal", "midplane"};

/// @return what 0 or 1 means
template <typename Wrong>
bool yes(const std::string& key, const std::string& value, const Wrong& wrong) {
    if (value != "0" && value != "1") {
        wrong(key + " is 0 or 1.");
    }
    return value == "1";
}

/// A place that stands beside the text is not said in it.
std::string at_text(const std::string& at, const std::optional<PlanPlace>& place) {
    return place ? "" : "at=" + at + "; ";
}

/// Radius and mirror, which several edits have. @return whether the key was one of them
template <typename Wrong>
bool take_place(const std::string& key, const std::string& value, double& radius, bool& mirrored,
                const Wrong& wrong) {
    if (key == "radius") {
        if (!read_number(value, radius) || radius < 0.0 || radius > 100.0) {
            wrong("radius is a number of millimetres from 0 to 100.");
        }
        return true;
    }
    if (key == "mirror") {
        mirrored = yes(key, value, wrong);
        return true;
    }
    return false;
}

void append_part(std::string& text, const std::string& part) {
    text += text.empty() ? part : "; " + part;
}

void append_place(std::string& text, double radius, bool mirrored) {
    if (radius > 0.0) {
        append_part(text, "radius=");
        append_number(text, radius);
    }
    if (mirrored) {
        append_part(text, "mirror=1");
    }
}

}  // namespace

DragEdit parse_drag(const std::string& text) {
    DragEdit drag;
    each_part(text, [&](const std::string& key, const std::string& value) {
        const auto wrong = [&](const std::string& what) {
            throw InvalidInput("Drag '" + text + "': " + what);
        };
        if (key == "at") {
            drag.at = value;
        } else if (key == "view") {
            drag.view = value;
            view_axes(value);
        } else if (key == "move") {
            const std::vector<double> xy = numbers(value);
            if (xy.size() != 2 || std::abs(xy[0]) > 200.0 || std::abs(xy[1]) > 200.0) {
                wrong("move needs two numbers of millimetres, RIGHT,UP, of at most 200.");
            }
            drag.move = {xy[0], xy[1]};
        } else if (key == "mode") {
            if (value != "mouse" && value != "constraint") {
                wrong("mode is mouse or constraint.");
            }
            drag.mode = value == "mouse" ? DragMode::MousePriority : DragMode::ConstraintPriority;
        } else if (key == "path") {
            const auto path = std::find(kPaths.begin(), kPaths.end(), value);
            if (path == kPaths.end()) {
                wrong("path is free, normal or midplane.");
            }
            drag.path = static_cast<DragPath>(path - kPaths.begin());
        } else if (key == "keep") {
            drag.keep = yes(key, value, wrong);
        } else if (key == "force") {
            if (!read_number(value, drag.force_N) || !(drag.force_N > 0.0) || drag.force_N > 6.0) {
                wrong("force is a number of newtons above 0, at most 6.");
            }
        } else if (!take_place(key, value, drag.radius, drag.mirrored, wrong)) {
            wrong("'" + key +
                  "' is not one of at, view, move, mode, radius, mirror, path, keep, force.");
        }
    });
    if (drag.force_N > 0.0 && drag.mode == DragMode::MousePriority) {
        throw InvalidInput("Drag '" + text + "': force goes with mode=constraint.");
    }
    return drag;
}

VolumeEdit parse_volume(const std::string& text) {
    VolumeEdit volume;
    each_part(text, [&](const std::string& key, const std::string& value) {
        const auto wrong = [&](const std::string& what) {
            throw InvalidInput("Volume '" + text + "': " + what);
        };
        if (key == "at") {
            volume.at = value;
        } else if (key == "ml") {
            if (!read_number(value, volume.ml)) {
                wrong("ml is a number of millilitres.");
            }
        } else if (!take_place(key, value, volume.radius, volume.mirrored, wrong)) {
            wrong("'" + key + "' is not one of at, ml, radius, mirror.");
        }
    });
    return volume;
}

std::string volume_to_text(const VolumeEdit& volume) {
    std::string text = at_text(volume.at, volume.place) + "ml=";
    append_number(text, volume.ml);
    append_place(text, volume.radius, volume.mirrored);
    return text;
}

TargetEdit parse_target(const std::string& text) {
    TargetEdit target;
    const auto wrong = [&](const std::string& what) {
        throw InvalidInput("Target '" + text + "': " + what);
    };
    const std::size_t semicolon = std::min(text.find(';'), text.size());
    const std::string goal = text.substr(0, semicolon);
    const std::size_t by = goal.rfind(" by ");
    const std::size_t equals = goal.rfind('=');
    const bool relative = equals == std::string::npos && by != std::string::npos;
    const std::size_t at = relative ? by : equals;
    if (at == std::string::npos ||
        !read_number(goal.substr(at + (relative ? 4 : 1)), target.value)) {
        wrong("is neither \"MEASURE=NUMBER\" nor \"MEASURE by CHANGE\".");
    }
    each_part(text.substr(semicolon), [&](const std::string& key, const std::string& value) {
        bool mirrored = false;
        if (key != "radius" || !take_place(key, value, target.radius, mirrored, wrong)) {
            wrong("'" + key + "' is not radius.");
        }
    });
    target.measure = trimmed(goal.substr(0, at));
    target.relative = relative;
    target_measure(target.measure);
    return target;
}

std::string target_to_text(const TargetEdit& target) {
    std::string text = target.measure + (target.relative ? " by " : "=");
    append_number(text, target.value);
    append_place(text, target.radius, false);
    return text;
}

ProtectEdit parse_protect(const std::string& text) {
    ProtectEdit protect;
    if (trimmed(text) == "none") {
        protect.none = true;
        return protect;
    }
    each_part(text, [&](const std::string& key, const std::string& value) {
        const auto wrong = [&](const std::string& what) {
            throw InvalidInput("Protect '" + text + "': " + what);
        };
        if (key == "at") {
            protect.at = value;
        } else if (key == "erase") {
            protect.erases = yes(key, value, wrong);
        } else if (!take_place(key, value, protect.radius, protect.mirrored, wrong)) {
            wrong("'" + key + "' is not one of at, radius, mirror, erase.");
        }
    });
    return protect;
}

std::string protect_to_text(const ProtectEdit& protect) {
    if (protect.none) {
        return "none";
    }
    std::string text = protect.place ? "" : "at=" + protect.at;
    if (protect.erases) {
        append_part(text, "erase=1");
    }
    append_place(text, protect.radius, protect.mirrored);
    return text;
}

std::string drag_to_text(const DragEdit& drag) {
    std::string text = at_text(drag.at, drag.place) + "view=" + drag.view + "; move=";
    append_number(text, drag.move.x());
    text += ',';
    append_number(text, drag.move.y());
    text += drag.mode == DragMode::MousePriority ? "; mode=mouse" : "; mode=constraint";
    append_place(text, drag.radius, drag.mirrored);
    if (drag.path != DragPath::Free) {
        text += "; path=";
        text += kPaths[static_cast<std::size_t>(drag.path)];
    }
    text += drag.keep ? "; keep=1" : "";
    if (drag.force_N > 0.0) {
        text += "; force=";
        append_number(text, drag.force_N);
    }
    return text;
}

std::pair<std::string, double> parse_setting(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    double value = 0.0;
    if (equals == std::string::npos || equals == 0 ||
        !read_number(text.substr(equals + 1), value)) {
        throw InvalidInput("'" + text + "' is not of the form NAME=NUMBER.");
    }
    return {trimmed(text.substr(0, equals)), value};
}

}  // namespace myoface
