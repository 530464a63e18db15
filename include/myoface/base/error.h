// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace myoface {

/// Base of every exception that leaves the core. `what()` is one sentence for a person: which file,
/// line or element, what is wrong, what to do. It stands on one line whatever it quotes: control
/// characters become '?', and what goes on for more than 2,000 bytes is cut.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& sentence);
};

/// A file cannot be read or written: missing, truncated, malformed, not of the expected kind.
class IoError : public Error {
public:
    using Error::Error;
};

/// A value given by a person or a script is unusable: unknown name, number out of range, landmarks
/// that do not lie on the face.
class InvalidInput : public Error {
public:
    using Error::Error;
};

/// The work was stopped because the user asked for it.
class Cancelled : public Error {
public:
    Cancelled() : Error("Cancelled.") {}
};

}  // namespace myoface
