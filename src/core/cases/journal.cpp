// SPDX-License-Identifier: Apache-2.0
#include "myoface/cases/journal.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/io/text_file.h"

#include "archive.h"

namespace myoface {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* kFace = "face.myoface";
constexpr const char* kState = "state";
constexpr const char* kLock = "lock";
constexpr const char* kSealed = "sealed";  ///< a protected record within a record
constexpr char kMagic[8] = {'M', 'Y', 'O', 'J', 'R', 'N', 'L', '1'};

/// FNV-1a: tells a whole record from a torn one.
std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char byte : bytes) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    }
    return hash;
}

void append_sized(std::string& into, std::string_view bytes) {
    const std::uint64_t size = bytes.size();
    into.append(reinterpret_cast<const char*>(&size), sizeof size);
    into.append(bytes);
}

/// Takes pieces off a record as append_sized() put them.
class Pieces {
public:
    Pieces(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}
    bool empty() const { return bytes_.empty(); }
    std::string next() {
        std::uint64_t size = 0;
        if (bytes_.size() < sizeof size) {
            damaged();
        }
        std::memcpy(&size, bytes_.data(), sizeof size);
        bytes_.remove_prefix(sizeof size);
        if (size > bytes_.size()) {
            damaged();
        }
        std::string piece(bytes_.substr(0, size));
        bytes_.remove_prefix(size);
        return piece;
    }
    [[noreturn]] void damaged() const { throw IoError(name_ + ": the journal is damaged."); }

private:
    std::string_view bytes_;
    const std::string& name_;
};

struct Record {
    json header;
    std::map<std::string, std::string> parts;
};

Record record_of(std::string_view body, const std::string& name) {
    Pieces pieces(body, name);
    Record record;
    record.header = json::parse(pieces.next(), nullptr, false);
    if (!record.header.is_object()) {
        pieces.damaged();
    }
    while (!pieces.empty()) {
        std::string key = pieces.next();
        record.parts[std::move(key)] = pieces.next();
    }
    return record;
}

Record read_record(const fs::path& file) {
    const std::string bytes = read_file(file);
    const std::string name = file.string();
    constexpr std::size_t kHead = sizeof kMagic + sizeof(std::uint64_t);
    if (bytes.size() < kHead || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0) {
        throw IoError(name + ": is no journal.");
    }
    std::uint64_t expected = 0;
    std::memcpy(&expected, bytes.data() + sizeof kMagic, sizeof expected);
    const std::string_view body = std::string_view(bytes).substr(kHead);
    if (checksum(body) != expected) {
        throw IoError(name + ": the journal is damaged.");
    }
    return record_of(body, name);
}

/// A record's body, as record_of() reads it.
std::string body_of(const json& header, const std::map<std::string, std::string>& parts) {
    std::string body;
    append_sized(body, header.dump(-1, ' ', false, json::error_handler_t::replace));
    for (const auto& [name, bytes] : parts) {
        append_sized(body, name);
        append_sized(body, bytes);
    }
    return body;
}

std::string text_in(const json& header, const char* key) {
    return header.contains(key) && header[key].is_string() ? header[key].get<std::string>() : "";
}

Landmarks landmarks_in(const json& object) {
    Landmarks landmarks;
    for (const auto& [name, v] : object.items()) {
        landmarks[name].position = {v.at(0).get<double>(), v.at(1).get<double>(),
                                    v.at(2).get<double>()};
        landmarks[name].error_mm = v.at(3).get<double>();
    }
    return landmarks;
}

std::string now_in_words() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    ::localtime_r(&now, &local);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &local);
    return text;
}

}  // namespace

Journal::Journal(const fs::path& folder, const OpenedFace& face)
    : name_(face.name), passphrase_(face.passphrase) {
    const auto stamp = std::chrono::system_clock::now().time_since_epoch().count();
    own_ = folder / ("face-" + std::to_string(stamp) + "-" + std::to_string(::getpid()));
    std::error_code error;
    fs::create_directories(own_, error);
    const fs::path lock = own_ / kLock;
    lock_ = error ? -1 : ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (lock_ < 0 || ::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        throw IoError(own_.string() + ": no journal can be kept there" +
                      (error ? ": " + error.message() : std::string()) +
                      "; changes to this face are safe only once the case is saved.");
    }
    write_case(own_ / kFace, face, face.state);
}

Journal::~Journal() {
    if (lock_ >= 0) {
        ::close(lock_);
    }
}

void Journal::record(const CaseState& state, const Landmarks& landmarks, const FitOptions& fit) {
    const StateParts parts = to_parts(state);
    json header;
    header["name"] = name_;
    header["gestures"] = ++gestures_;
    header["saved"] = now_in_words();
    header["tissue_depth"] = thickness_name(fit.tissue);
    header["state"] = json::parse(parts.json);
    for (const auto& [name, landmark] : landmarks) {
        header["landmarks"][name] = {landmark.position.x(), landmark.position.y(),
                                     landmark.position.z(), landmark.error_mm};
    }
    std::string body = body_of(header, parts.parts);
    if (!passphrase_.empty()) {
        json outer;
        for (const char* told : {"name", "gestures", "saved"}) {
            outer[told] = header[told];
        }
        body = body_of(outer, {{kSealed, zip_bytes({{kSealed, body}}, passphrase_, name_)}});
    }
    const std::uint64_t sum = checksum(body);
    std::string bytes(kMagic, sizeof kMagic);
    bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    bytes += body;
    write_file(own_ / kState, bytes, Durability::SurvivesPowerLoss);
}

void Journal::finish() {
    std::error_code ignored;
    fs::remove_all(own_, ignored);
}

std::vector<Recovery> recoverable(const fs::path& folder) {
    std::vector<Recovery> found;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        if (!entry.is_directory(error)) {
            continue;
        }
        const fs::path lock = entry.path() / kLock;
        const int handle = ::open(lock.c_str(), O_RDWR | O_CLOEXEC);
        const bool lives = handle >= 0 && ::flock(handle, LOCK_EX | LOCK_NB) != 0;
        if (handle >= 0) {
            ::close(handle);
        }
        if (lives || handle < 0) {
            continue;  // somebody works on it, or it is no journal
        }
        try {
            const Record record = read_record(entry.path() / kState);
            found.push_back({entry.path(), text_in(record.header, "name"),
                             record.header.value("gestures", 0), text_in(record.header, "saved"),
                             record.parts.count(kSealed) != 0});
        } catch (const std::exception&) {
            // Ended before anything was done; a young one may just be beginning.
            const auto age = fs::file_time_type::clock::now() - fs::last_write_time(lock, error);
            if (!fs::exists(entry.path() / kState, error) && age > std::chrono::minutes(5)) {
                fs::remove_all(entry.path(), error);
            }
        }
    }
    std::sort(found.begin(), found.end(),
              [](const Recovery& a, const Recovery& b) { return a.saved > b.saved; });
    return found;
}

OpenedFace recover(const Recovery& recovery, const Progress* progress,
                   const std::string& passphrase) {
    const fs::path file = recovery.folder / kState;
    const std::string name = file.string();
    Record record = read_record(file);
    if (const auto sealed = record.parts.find(kSealed); sealed != record.parts.end()) {
        const std::string opened =
            ZipReader(ZipReader::Memory{sealed->second}, name, passphrase).part(kSealed, true);
        record = record_of(opened, name);
    }
    OpenOptions options;
    options.passphrase = passphrase;
    OpenedFace face = read_case((recovery.folder / kFace).string(), options, progress);
    face.name = text_in(record.header, "name");
    try {
        face.fit.tissue = tissue_thickness(record.header.at("tissue_depth").get<std::string>());
        if (record.header.contains("landmarks")) {
            face.landmarks = landmarks_in(record.header["landmarks"]);
        }
        face.state = from_parts(
            record.header.at("state").dump(),
            [&](const std::string& part) {
                const auto at = record.parts.find(part);
                return at == record.parts.end() ? std::string() : at->second;
            },
            face.scan->mesh.vertex_count(), name);
    } catch (const json::exception&) {
        throw IoError(name + ": the journal is damaged.");
    }
    return face;
}

void discard(const Recovery& recovery) {
    std::error_code ignored;
    fs::remove_all(recovery.folder, ignored);
}

}  // namespace myoface
