// SPDX-License-Identifier: Apache-2.0
#include "bad_files.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "cases/archive.h"

namespace myoface::test {
namespace {

using nlohmann::json;
using Parts = std::map<std::string, std::string>;

const char* const kManifest = R"({
 "format": "myoface-case", "schema": 2, "pseudonym": "MF-2222-22", "scan": "scan.obj",
 "mm_per_unit": 1.0, "axes": [1, 0, 0, 0, 1, 0, 0, 0, 1], "tissue_depth": "mean",
 "contractions": {"risorius.L": 0.5}, "strengths": {"risorius.R": 0.25}, "notes": "n",
 "variants": [{"name": "A", "contractions": {}, "strengths": {}}],
 "materials": [], "textures": [],
 "landmarks": {"prn": {"xyz": [0, 0, 0], "est_error_mm": 1}},
 "plan": {"plan": [{"muscle": "risorius.L", "rate": 0.5}]}})";

const char* const kPlan = R"({"format": "myoface-plan", "schema": 1,
 "made_on": {"scan": "00112233445566ff", "skin": "ff00112233445566",
  "axes": [1, 0, 0, 0, 1, 0, 0, 0, 1], "landmarks": {"prn": [0, 0, 100]}},
 "plan": [
  {"drag": "view=0,0,-1; move=1,2; mode=mouse", "place": {"triangle": 7,
    "weights": [0.5, 0.25, 0.25], "xyz": [1, 2, 100], "head": [1, 2, 99], "near": "prn",
    "off": [1, 2, 0]}},
  {"volume": "at=zy_l; ml=0.5"}, {"target": "nasolabial angle=100"},
  {"protect": "at=prn; radius=8"}, {"muscle": "risorius.L", "rate": 0.5},
  {"muscle": "risorius.L", "strength": 0.5}, {"expression": "joy", "intensity": 0.5},
  {"shape": {"vertices": 9, "moved": [[3, 0.5, 0, 0]]}}, {"shape": "scan"}]})";

const char* const kLandmarks =
    R"({"unit": "mm", "landmarks": {"prn": [0, 0, 100], "en_l": {"xyz": [15, 30, 80],
 "est_error_mm": 2}}})";

template <typename Number>
std::string raw(const std::vector<Number>& numbers) {
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

/// A sparse part: how many vertices there are, then which one is where.
std::string sparse_part(std::int64_t all, std::int64_t vertex, double x) {
    return raw<std::int64_t>({all, vertex}) + raw<double>({x, 0.0, 0.0});
}

std::string journal_header() {
    return R"({"name": "a.ply", "gestures": 1, "saved": "2026-01-01 00:00:00",
 "tissue_depth": "mean", "landmarks": {"prn": [0, 0, 100, 1]},
 "state": {"contractions": {"risorius.L": 0.5}, "strengths": {}, "notes": "", "variants": []}})";
}

/// A record as a journal writes it, its sum right.
std::string journal_of(const std::string& header, const Parts& parts) {
    std::string body;
    const auto put = [&](const std::string& bytes) {
        body += raw<std::uint64_t>({bytes.size()}) + bytes;
    };
    put(header);
    for (const auto& [name, bytes] : parts) {
        put(name);
        put(bytes);
    }
    return journal_record(body);
}

Parts good_parts() {
    return {{"manifest.json", kManifest},
            {"scan", "v 0 0 0\nv 200 0 0\nv 0 200 0\nf 1 2 3\n"},
            {"shape", sparse_part(3, 1, 0.5)},
            {"variant-0", sparse_part(3, 2, 0.25)},
            {"protection", sparse_part(3, 0, 1.0)}};
}

std::string zipped(const Parts& parts, const std::string& passphrase = {}) {
    std::vector<ZipPart> list;
    for (const auto& [name, bytes] : parts) {
        list.push_back({name, bytes});
    }
    return zip_bytes(list, passphrase, "test");
}

/// A JSON text with one place changed; no value: taken away.
std::string changed(const std::string& text, const std::string& pointer,
                    const std::optional<std::string>& value) {
    json document = json::parse(text);
    const json::json_pointer at(pointer);
    if (value) {
        document[at] = json::parse(*value);
    } else {
        document[at.parent_pointer()].erase(at.back());
    }
    return document.dump();
}

struct Change {
    const char* at;
    const char* value;  ///< JSON; null: taken away
    const char* says;
};

std::optional<std::string> value_of(const Change& change) {
    return change.value == nullptr ? std::nullopt : std::optional<std::string>(change.value);
}

const Change kManifestChanges[] = {
    {"/format", nullptr, "manifest is damaged"},
    {"/format", "\"zip\"", "manifest is damaged"},
    {"/format", "7", "manifest is damaged"},
    {"/format", "[\"myoface-case\"]", "manifest is damaged"},
    {"/schema", nullptr, "manifest is damaged"},
    {"/schema", "\"2\"", "manifest is damaged"},
    {"/schema", "2.5", "manifest is damaged"},
    {"/schema", "null", "manifest is damaged"},
    {"/schema", "3", "written by a newer Myoface"},
    {"/schema", "99999999999999", "written by a newer Myoface"},
    {"/schema", "0", "no such schema as 0"},
    {"/schema", "-1", "no such schema as -1"},
    {"/scan", "7", "\"scan\" is no text"},
    {"/scan", "[]", "\"scan\" is no text"},
    {"/pseudonym", "7", "\"pseudonym\" is no text"},
    {"/tissue_depth", "7", "\"tissue_depth\" is no text"},
    {"/tissue_depth", "\"fat\"", "fat"},
    {"/tissue_depth", "\"\"", "thin"},
    {"/mm_per_unit", nullptr, "unit or axes are damaged"},
    {"/mm_per_unit", "\"1\"", "unit or axes are damaged"},
    {"/mm_per_unit", "null", "unit or axes are damaged"},
    {"/mm_per_unit", "[]", "unit or axes are damaged"},
    {"/mm_per_unit", "0", "unit or axes are damaged"},
    {"/mm_per_unit", "-1", "unit or axes are damaged"},
    {"/mm_per_unit", "1e9", "unit or axes are damaged"},
    {"/axes", nullptr, "unit or axes are damaged"},
    {"/axes", "[]", "unit or axes are damaged"},
    {"/axes", "\"+x+y+z\"", "unit or axes are damaged"},
    {"/axes", "[1,0,0,0,1,0,0,0]", "unit or axes are damaged"},
    {"/axes", "[1,0,0,0,1,0,0,0,1,0]", "unit or axes are damaged"},
    {"/axes", "[0,0,0,0,0,0,0,0,0]", "unit or axes are damaged"},
    {"/axes", "[-1,0,0,0,1,0,0,0,1]", "unit or axes are damaged"},
    {"/axes", "[1,1,0,0,1,0,0,0,1]", "unit or axes are damaged"},
    {"/axes", "[2,0,0,0,2,0,0,0,2]", "unit or axes are damaged"},
    {"/axes", "[\"1\",0,0,0,1,0,0,0,1]", "unit or axes are damaged"},
    {"/contractions", "[]", "\"contractions\" is damaged"},
    {"/contractions", "7", "\"contractions\" is damaged"},
    {"/contractions", R"({"risorius.L": 2})", "risorius.L is out of range"},
    {"/contractions", R"({"risorius.L": -0.6})", "risorius.L is out of range"},
    {"/contractions", R"({"risorius.L": "1"})", "risorius.L is out of range"},
    {"/contractions", R"({"risorius.L": null})", "risorius.L is out of range"},
    {"/contractions", R"({"risorius.L": [1]})", "risorius.L is out of range"},
    {"/strengths", "[]", "\"strengths\" is damaged"},
    {"/strengths", R"({"risorius.L": 1.5})", "risorius.L is out of range"},
    {"/strengths", R"({"risorius.L": -0.1})", "risorius.L is out of range"},
    {"/strengths", R"({"risorius.L": {}})", "risorius.L is out of range"},
    {"/notes", "7", "\"notes\" is no text"},
    {"/notes", "{}", "\"notes\" is no text"},
    {"/variants", "{}", "variants are damaged"},
    {"/variants", "7", "variants are damaged"},
    {"/variants", "[7]", "variants are damaged"},
    {"/variants", "[[]]", "variants are damaged"},
    {"/variants", R"([{"name": 7}])", "\"name\" is no text"},
    {"/variants", R"([{"contractions": []}])", "\"contractions\" is damaged"},
    {"/variants", R"([{"strengths": {"a": 2}}])", "setting of a is out of range"},
    {"/textures", "[7]", "materials are damaged"},
    {"/textures", "[null]", "materials are damaged"},
    {"/landmarks", "7", "no \"landmarks\" object"},
    {"/landmarks", "[]", "no \"landmarks\" object"},
    {"/landmarks", "{}", "no landmark with a known name"},
    {"/landmarks/prn", "7", "'prn' is not three numbers"},
    {"/landmarks/prn", "[1, 2]", "'prn' is not three numbers"},
    {"/landmarks/prn", "[1, 2, \"3\"]", "'prn' is not three numbers"},
    {"/landmarks/prn/xyz", "[1, 2, 1e99]", "'prn' is not finite"},
    {"/plan", "7", "is not a plan"},
    {"/plan", "[]", "is not a plan"},
    {"/plan", R"({"plan": 7})", "is not a plan"},
    {"/plan", R"({"plan": [7]})", "edit 1: is not an object"},
    {"/plan", R"({"plan": [{"drag": "mov=1"}]})", "'mov' is not one of"},
    {"/plan", R"({"schema": 9, "plan": []})", "written by a newer Myoface"},
};

const Change kPlanChanges[] = {
    {"/plan", nullptr, "a list \"plan\" is needed"},
    {"/plan", "{}", "a list \"plan\" is needed"},
    {"/plan", "\"drag\"", "a list \"plan\" is needed"},
    {"/format", "\"myoface-case\"", "\"format\" is another one"},
    {"/format", "7", "\"format\" is another one"},
    {"/schema", "2", "written by a newer Myoface"},
    {"/schema", "0", "\"schema\" is no whole number"},
    {"/schema", "1.5", "\"schema\" is no whole number"},
    {"/schema", "\"1\"", "\"schema\" is no whole number"},
    {"/made_on", "7", "\"made_on\" is not an object"},
    {"/made_on/scan", nullptr, "no sum of the scan"},
    {"/made_on/scan", "\"0011\"", "no sum of the scan"},
    {"/made_on/scan", "\"zz112233445566ff\"", "no sum of the scan"},
    {"/made_on/skin", "17", "no sum of the skin"},
    {"/made_on/axes", nullptr, "nine numbers of axes"},
    {"/made_on/axes", "[1, 0, 0]", "nine numbers of axes"},
    {"/made_on/axes", "[1,0,0,0,1,0,0,0,2]", "no rotation"},
    {"/made_on/axes", "[1,0,0,0,1,0,0,0,\"1\"]", "something else than numbers"},
    {"/made_on/landmarks", "[]", "damaged landmarks"},
    {"/made_on/landmarks", R"({"prn": [1, 2]})", "damaged landmarks"},
    {"/made_on/landmarks", R"({"prn": [1, 2, null]})", "something else than numbers"},
    {"/plan/0", "7", "edit 1: is not an object"},
    {"/plan/1", "null", "edit 2: is not an object"},
    {"/plan/1", "[]", "edit 2: is not an object"},
    {"/plan/1", "{}", "edit 2: is none of drag"},
    {"/plan/1", R"({"drag": 7})", "edit 2: is none of drag"},
    {"/plan/1", R"({"muscle": "risorius"})", "edit 2: is none of drag"},
    {"/plan/1", R"({"muscle": "risorius", "rate": "1"})", "edit 2: is none of drag"},
    {"/plan/1", R"({"muscle": 7, "rate": 1})", "edit 2: is none of drag"},
    {"/plan/1", R"({"expression": "joy"})", "edit 2: is none of drag"},
    {"/plan/1", R"({"expression": "joy", "intensity": null})", "edit 2: is none of drag"},
    {"/plan/1", R"({"drag": "at=prn; mov=1"})", "'mov' is not one of at, view, move"},
    {"/plan/1", R"({"drag": "at=prn; move=1"})", "move needs two numbers"},
    {"/plan/1", R"({"drag": "move=1,2,3"})", "move needs two numbers"},
    {"/plan/1", R"({"drag": "move=900,0"})", "at most 200"},
    {"/plan/1", R"({"drag": "move=nan,0"})", "move needs two numbers"},
    {"/plan/1", R"({"drag": "mode=soft"})", "mode is mouse or constraint"},
    {"/plan/1", R"({"drag": "radius=-1"})", "from 0 to 100"},
    {"/plan/1", R"({"drag": "radius=wide"})", "from 0 to 100"},
    {"/plan/1", R"({"drag": "mirror=yes"})", "mirror is 0 or 1"},
    {"/plan/1", R"({"drag": "keep=2"})", "keep is 0 or 1"},
    {"/plan/1", R"({"drag": "path=up"})", "path is free, normal or midplane"},
    {"/plan/1", R"({"drag": "view=inside"})", "inside"},
    {"/plan/1", R"({"drag": "view=0,0,0"})", "no usable length"},
    {"/plan/1", R"({"drag": "view=1e300,1e300,0"})", "no usable length"},
    {"/plan/1", R"({"volume": "ml=much"})", "ml is a number"},
    {"/plan/1", R"({"volume": "at=prn; view=left"})", "'view' is not one of at, ml"},
    {"/plan/1", R"({"target": "nasolabial angle"})", "MEASURE=NUMBER"},
    {"/plan/1", R"({"target": "nasolabial angle=wide"})", "MEASURE=NUMBER"},
    {"/plan/1", R"({"target": "beauty=10"})", "'beauty' is not a measure"},
    {"/plan/1", R"({"target": "nasolabial angle=100; mirror=1"})", "'mirror' is not radius"},
    {"/plan/1", R"({"target": "nasolabial angle=100; radius=x"})", "from 0 to 100"},
    {"/plan/1", R"({"protect": "at=prn; ml=1"})", "'ml' is not one of at, radius"},
    {"/plan/1", R"({"protect": "erase=maybe"})", "erase is 0 or 1"},
    {"/plan/0/place", "7", "no triangle"},
    {"/plan/0/place/triangle", nullptr, "no triangle"},
    {"/plan/0/place/triangle", "1.5", "no triangle"},
    {"/plan/0/place/triangle", "-1", "not on a triangle"},
    {"/plan/0/place/triangle", "99999999999", "not on a triangle"},
    {"/plan/0/place/weights", "[1, 1, 1]", "not on a triangle"},
    {"/plan/0/place/weights", "[2, -1, 0]", "not on a triangle"},
    {"/plan/0/place/weights", "[1, 0]", "\"weights\" is not three numbers"},
    {"/plan/0/place/xyz", nullptr, "\"xyz\" is not three numbers"},
    {"/plan/0/place/xyz", "[0, 0, 1e9]", "\"xyz\" is not three numbers"},
    {"/plan/0/place/head", "\"prn\"", "\"head\" is not three numbers"},
    {"/plan/0/place/near", "7", "not the name of a landmark"},
    {"/plan/0/place/off", nullptr, "\"off\" is not three numbers"},
    {"/plan/7/shape", "7", "neither \"scan\" nor"},
    {"/plan/7/shape", "\"nose\"", "neither \"scan\" nor"},
    {"/plan/7/shape/vertices", "0", "impossible number"},
    {"/plan/7/shape/vertices", "99999999999", "impossible number"},
    {"/plan/7/shape/moved", "[[9, 0, 0, 0]]", "move vertices by"},
    {"/plan/7/shape/moved", "[[-1, 0, 0, 0]]", "move vertices by"},
    {"/plan/7/shape/moved", "[[1, 0, 0]]", "move vertices by"},
    {"/plan/7/shape/moved", "[[1, 0, 0, 1e9]]", "move vertices by"},
    {"/plan/7/shape/moved", "[[1, 0, 0, \"0\"]]", "move vertices by"},
};

const Change kLandmarkChanges[] = {
    {"/landmarks", "7", "no \"landmarks\" object"},
    {"/landmarks", "[[1, 2, 3]]", "no \"landmarks\" object"},
    {"/landmarks", "{}", "no landmark with a known name"},
    {"/landmarks", R"({"nose": [1, 2, 3]})", "no landmark with a known name"},
    {"/landmarks/prn", "null", "'prn' is not three numbers"},
    {"/landmarks/prn", "[]", "'prn' is not three numbers"},
    {"/landmarks/prn", "[1, 2]", "'prn' is not three numbers"},
    {"/landmarks/prn", "[1, 2, 3, 4]", "'prn' is not three numbers"},
    {"/landmarks/prn", "[1, 2, true]", "'prn' is not three numbers"},
    {"/landmarks/prn", R"({"x": 1, "y": 2, "z": 3})", "'prn' is not three numbers"},
    {"/landmarks/prn", R"({"xyz": "1 2 3"})", "'prn' is not three numbers"},
    {"/landmarks/prn", "[1e10, 0, 0]", "'prn' is not finite"},
    {"/unit", "\"furlong\"", "unit is not one of"},
    {"/unit", "0", "unit"},
    {"/unit", "-3", "unit"},
    {"/unit", "[]", "unit"},
};

void add_cases(std::vector<BadFile>& files) {
    const auto add = [&](const std::string& what, const std::string& bytes,
                         const std::string& says) {
        files.push_back({BadKind::Case, what + ".myoface", bytes, says});
    };
    for (const Change& change : kManifestChanges) {
        Parts parts = good_parts();
        parts["manifest.json"] = changed(kManifest, change.at, value_of(change));
        add("case-" + std::to_string(files.size()), zipped(parts), change.says);
    }
    const auto with = [&](const std::string& part, const std::optional<std::string>& bytes,
                          const std::string& says, const std::string& what) {
        Parts parts = good_parts();
        parts.erase(part);
        if (bytes) {
            parts[part] = *bytes;
        }
        add(what, zipped(parts), says);
    };
    const std::string text = kManifest;
    with("manifest.json", std::nullopt, "manifest.json is missing", "no-manifest");
    with("manifest.json", "", "manifest is damaged", "empty-manifest");
    with("manifest.json", "null", "manifest is damaged", "null-manifest");
    with("manifest.json", "[" + text + "]", "manifest is damaged", "list-manifest");
    with("manifest.json", text.substr(0, text.size() / 2), "manifest is damaged", "half-manifest");
    with("manifest.json", text + "}", "manifest is damaged", "more-manifest");
    with("manifest.json", std::string(100'000, '['), "manifest is damaged", "deep-manifest");
    with("manifest.json", std::string(64, '\0'), "manifest is damaged", "zero-manifest");
    with("scan", std::nullopt, "scan is missing", "no-scan");
    with("scan", "", "scan.obj", "empty-scan");
    with("scan", "not a mesh", "scan.obj", "no-mesh");
    with("scan", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n", "scan.obj", "nan-scan");
    with("shape", std::string(9, 'x'), "shape of the skin is damaged", "odd-shape");
    with("shape", sparse_part(3, 3, 1.0), "shape of the skin is damaged", "far-shape");
    with("shape", sparse_part(3, -1, 1.0), "shape of the skin is damaged", "minus-shape");
    with("shape", sparse_part(-1, 0, 1.0), "shape of the skin is damaged", "negative-shape");
    with("shape", sparse_part(0, 0, 1.0), "shape of the skin is damaged", "none-shape");
    with("shape", sparse_part(std::int64_t(1) << 40, 0, 1.0), "belongs to a larger scan",
         "huge-shape");
    with("shape", sparse_part(4, 0, 1.0), "belongs to a larger scan", "other-shape");
    with("shape", sparse_part(3, 0, std::nan("")), "shape of the skin is damaged", "nan-shape");
    with("variant-0", sparse_part(3, 7, 1.0), "shape of the skin is damaged", "far-variant");
    with("protection", sparse_part(3, 0, 2.0), "protects is out of range", "much-protection");
    with("protection", sparse_part(3, 0, -1.0), "protects is out of range", "less-protection");
    with("shape", std::string(100'000'000, '\0'), "larger than a case can hold", "bomb");

    const std::string whole = good_case();
    add("empty", "", "not a zip archive");
    add("text", "this is no archive", "not a zip archive");
    add("half", whole.substr(0, whole.size() / 2), "not a zip archive");
    add("tail", whole.substr(whole.size() / 2), "not a zip archive");
    add("locked", good_case("correct horse battery staple"), "protected by a passphrase");
    std::string lies = whole;  // the first directory entry says another size
    const std::size_t directory = lies.find("PK\x01\x02");
    lies[directory + 24] = static_cast<char>(lies[directory + 24] + 1);
    add("lying-size", lies, "damaged");
    std::string boasts = whole;  // and here 1.6 GB, packed and unpacked
    for (const std::size_t size : {directory + 20, directory + 24}) {
        boasts.replace(size, 4, std::string("\0\0\0\x60", 4));
    }
    add("boasting-size", boasts, "damaged");
    std::string sum = whole;
    sum[directory + 16] = static_cast<char>(sum[directory + 16] ^ 1);
    add("wrong-sum", sum, "damaged");
}

void add_texts(std::vector<BadFile>& files) {
    for (const Change& change : kPlanChanges) {
        files.push_back({BadKind::Plan, "plan-" + std::to_string(files.size()) + ".json",
                         changed(kPlan, change.at, value_of(change)), change.says});
    }
    for (const Change& change : kLandmarkChanges) {
        files.push_back({BadKind::Landmarks, "landmarks-" + std::to_string(files.size()) + ".json",
                         changed(kLandmarks, change.at, value_of(change)), change.says});
    }
    const std::string huge = R"({"plan": [{"muscle": "risorius", "rate": 1e999}]})";
    for (const auto& [text, says] : {std::pair<std::string, std::string>("", "not JSON"),
                                     {"{", "not JSON"},
                                     {"[]", "a list \"plan\" is needed"},
                                     {std::string(100'000, '['), "not JSON"},
                                     {huge, "not JSON"},
                                     {"\xff\xfe{\"plan\": []}", "not JSON"}}) {
        files.push_back(
            {BadKind::Plan, "text-" + std::to_string(files.size()) + ".json", text, says});
    }
    for (const char* text : {"", "[]", "{", "null", "\"prn\""}) {
        files.push_back({BadKind::Landmarks, "text-" + std::to_string(files.size()) + ".json", text,
                         "is not a JSON file of landmarks"});
    }
}

void add_journals(std::vector<BadFile>& files) {
    const std::string whole = good_journal();
    const auto add = [&](const std::string& bytes, const std::string& says) {
        files.push_back({BadKind::Journal, "journal-" + std::to_string(files.size()), bytes, says});
    };
    add("", "is no journal");
    add("MYOJRNL2" + whole.substr(8), "is no journal");
    add(whole.substr(0, 12), "is no journal");
    add(whole.substr(0, whole.size() - 1), "is damaged");
    add(whole + "x", "is damaged");
    std::string flipped = whole;
    flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 4);
    add(flipped, "is damaged");
    add(journal_of("[]", {}), "is damaged");
    add(journal_of("{}", {}), "is damaged");
    add(journal_of(changed(journal_header(), "/tissue_depth", "7"), {}), "is damaged");
    add(journal_of(changed(journal_header(), "/state", "[]"), {}), "settings are damaged");
    add(journal_of(changed(journal_header(), "/landmarks/prn", "[1]"), {}), "is damaged");
    add(journal_of(journal_header(), {{"shape", "x"}}), "shape of the skin is damaged");
    add(journal_of(journal_header(), {{"sealed", "x"}}), "not a zip archive");
}

}  // namespace

std::string good_case(const std::string& passphrase) {
    return zipped(good_parts(), passphrase);
}

std::string good_case_parts() {
    const Parts parts = good_parts();
    return parts.at("manifest.json") + '\xff' + parts.at("shape") + '\xff' +
           parts.at("protection") + '\xff' + parts.at("variant-0");
}

std::string journal_record(const std::string& body) {
    std::uint64_t sum = 14695981039346656037ULL;
    for (const char byte : body) {
        sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211ULL;
    }
    return "MYOJRNL1" + raw<std::uint64_t>({sum}) + body;
}

std::string good_plan() {
    return kPlan;
}

std::string good_landmarks() {
    return kLandmarks;
}

std::string good_journal() {
    return journal_of(journal_header(), {{"shape", sparse_part(3, 1, 0.5)}});
}

std::vector<BadFile> bad_files() {
    std::vector<BadFile> files;
    add_cases(files);
    add_texts(files);
    add_journals(files);
    return files;
}

}  // namespace myoface::test
