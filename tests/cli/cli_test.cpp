// SPDX-License-Identifier: Apache-2.0
// The command line as scripts use it: exit codes, files, one line of complaint.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sys/wait.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "myoface/io/image.h"
#include "myoface/io/mesh_file.h"
#include "myoface/io/text_file.h"

#include "test_meshes.h"

namespace myoface {
namespace {

struct Outcome {
    int code = -1;
    std::string out, err;
};

Outcome run(const std::string& program, const std::string& arguments) {
    const test::TemporaryFolder folder;
    const std::string out = (folder / "out").string();
    const std::string err = (folder / "err").string();
    const int status = std::system((program + " " + arguments + " >" + out + " 2>" + err).c_str());
    const auto text = [](const std::string& file) {
        std::ifstream stream(file);
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text(out), text(err)};
}
Outcome cli(const std::string& arguments) {
    return run(MYOFACE_CLI, arguments);
}

/// A generated face with landmarks beside it, for all tests of this process.
struct Face {
    test::TemporaryFolder folder;
    std::string scan = (folder / "face.obj").string();

    Face() {
        const Outcome made = cli("generate --vertices 4000 -o " + scan + " --landmarks-out " +
                                 (folder / "face.landmarks.json").string());
        EXPECT_EQ(made.code, 0) << made.err;
    }
};
const Face& face() {
    static const Face kFace;
    return kFace;
}

void expect_refusal(const std::string& arguments, int code, const std::string& words) {
    const Outcome outcome = cli(arguments);
    EXPECT_EQ(outcome.code, code) << arguments;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

TEST(Info, TellsWhatIsInTheFile) {
    const Outcome outcome = cli("info " + face().scan);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["unit"], "mm");
    EXPECT_EQ(json["components"], 35);
    EXPECT_EQ(json["landmarks"], 35);
}

TEST(Simulate, WithNothingToDoGivesTheFileBack) {
    const std::string out = (face().folder / "same.obj").string();
    ASSERT_EQ(cli("simulate " + face().scan + " --muscle risorius=0 -o " + out).code, 0);
    EXPECT_EQ(read_mesh(out).file_vertices, read_mesh(face().scan).file_vertices);
}

TEST(Simulate, WritesTheReportThatIsDocumented) {
    const std::string report = (face().folder / "r.json").string();
    const std::string arguments = "simulate " + face().scan +
                                  " --muscle zygomaticus_major=0.5 --strength risorius=0.5 " +
                                  "--drag 'at=prn; view=left; move=-1,1; mode=mouse' -o " +
                                  (face().folder / "s.ply").string() + " --report " + report;
    ASSERT_EQ(cli(arguments).code, 0);
    const auto json = nlohmann::json::parse(read_file(report));
    for (const char* key : {"vertices", "springs", "muscles", "max_displacement_mm", "max_strain",
                            "solver", "drags", "state_hash"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
    EXPECT_DOUBLE_EQ(json["muscles"]["zygomaticus_major.L"].get<double>(), 0.5);
    for (const char* key : {"mode", "vertex", "target", "reached", "off_ray_mm",
                            "view_force_residual", "stage_skin_mN", "stage_muscle_mN"}) {
        EXPECT_TRUE(json["drags"][0].contains(key)) << key;
    }
    EXPECT_EQ(json["solver"]["converged"], true);
    const std::string hash = json["state_hash"];
    ASSERT_EQ(cli(arguments + " --threads 1").code, 0);
    EXPECT_EQ(nlohmann::json::parse(read_file(report))["state_hash"], hash);
}

TEST(Simulate, ShowsAnExpression) {
    const std::string smile = (face().folder / "joy.ply").string();
    const std::string report = (face().folder / "joy.json").string();
    ASSERT_EQ(cli("simulate " + face().scan + " --expression joy=0.8 --expression AU26=0.3 -o " +
                  smile + " --report " + report)
                  .code,
              0);
    const auto json = nlohmann::json::parse(read_file(report));
    EXPECT_NEAR(json["muscles"]["zygomaticus_major.L"].get<double>(), 0.8 * 0.9 * 0.85, 1e-9);
    EXPECT_GT(json["muscles"]["jaw_opening"].get<double>(), 0.1);
    expect_refusal("simulate " + face().scan + " --expression glee=1 -o " + smile, 1,
                   "no expression 'glee'");
    expect_refusal("simulate " + face().scan + " --expression joy=2 -o " + smile, 1,
                   "between 0 and 1");
}

TEST(Simulate, ReplaysAPlan) {
    const std::string plan = (face().folder / "plan.json").string();
    std::ofstream(plan) << R"({"plan":[{"muscle":"mentalis","rate":0.5}]})";
    const std::string a = (face().folder / "a.ply").string();
    const std::string b = (face().folder / "b.ply").string();
    ASSERT_EQ(cli("simulate " + face().scan + " --plan " + plan + " -o " + a).code, 0);
    ASSERT_EQ(cli("simulate " + face().scan + " --muscle mentalis=0.5 -o " + b).code, 0);
    EXPECT_EQ(read_file(a), read_file(b));
}

TEST(Replay, GivesTheSameBitsFromAPlanAndFromTheCaseThatHoldsIt) {
    const auto file = [](const char* name) { return (face().folder / name).string(); };
    std::ofstream(file("made.json"))
        << R"({"plan":[{"drag":"at=prn; view=left; move=-1,2"},{"muscle":"mentalis","rate":0.4}]})";
    const auto hash = [](const std::string& report) {
        return nlohmann::json::parse(read_file(report))["state_hash"].get<std::string>();
    };
    ASSERT_EQ(cli("replay " + file("made.json") + " " + face().scan + " --threads 1 --case-out " +
                  file("made.myoface") + " --report " + file("one.json"))
                  .code,
              0);
    ASSERT_EQ(cli("replay " + file("made.myoface") + " " + face().scan + " --threads 2 --report " +
                  file("two.json"))
                  .code,
              0);
    EXPECT_EQ(hash(file("one.json")), hash(file("two.json")));
    const auto report = nlohmann::json::parse(read_file(file("two.json")));
    EXPECT_EQ(report["face"], "same");
    EXPECT_EQ(report["done"], 2);
    std::ofstream(file("half.json")) << R"({"plan":[{"drag":"at=tail"}]})";
    const auto half = cli("replay " + file("half.json") + " " + face().scan);
    EXPECT_EQ(half.code, 0);
    EXPECT_NE(half.err.find("left out"), std::string::npos) << half.err;
    expect_refusal("replay " + face().scan + " " + face().scan, 1, "is not a plan");
}

TEST(Passphrase, IsWantedByAProtectedCase) {
    const auto file = [](const char* name) { return (face().folder / name).string(); };
    std::ofstream(file("pass")) << "seven quiet herons\n";
    std::ofstream(file("other")) << "eight loud herons\n";
    ASSERT_EQ(cli("fit " + face().scan + " -o " + file("locked.myoface") + " --passphrase-file " +
                  file("pass"))
                  .code,
              0);
    expect_refusal("info " + file("locked.myoface"), 1, "--passphrase-file");
    expect_refusal("info " + file("locked.myoface") + " --passphrase-file " + file("other"), 1,
                   "another passphrase");
    EXPECT_EQ(cli("info " + file("locked.myoface") + " --passphrase-file " + file("pass")).code, 0);
}

TEST(Generate, MeasuresAsTheNormsSay) {
    const std::string woman = (face().folder / "woman.glb").string();
    const std::string marks = (face().folder / "woman.json").string();
    ASSERT_EQ(cli("generate --sex f --age 22 --vertices 4000 --picture 128 -o " + woman +
                  " --landmarks-out " + marks)
                  .code,
              0);
    const auto result = cli("measure " + woman + " --landmarks " + marks + " --sex f --age 22");
    ASSERT_EQ(result.code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    int within = 0;
    for (const auto& row : json["measures"]) {
        within +=
            row["unit"] == "mm" && row.contains("z") && std::abs(row["z"].get<double>()) <= 1.0;
    }
    EXPECT_GE(within, 18);
    EXPECT_NE(json["note"].get<std::string>().find("not a medical device"), std::string::npos);
    const std::string csv = (face().folder / "m.csv").string();
    ASSERT_EQ(
        cli("measure " + woman + " --landmarks " + marks + " --compare " + woman + " -o " + csv)
            .code,
        0);
    const std::string table = read_file(csv);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 25);
    EXPECT_NE(table.find("n-gn,facial height,mm,"), std::string::npos);
    const std::string cube = (face().folder / "cube.obj").string();
    std::ofstream(cube)
        << "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    expect_refusal("measure " + cube, 1, "no face was found");
    EXPECT_EQ(cli("measure " + woman + " --sex x").code, 2);
    EXPECT_EQ(cli("generate --vertices 12 -o " + woman).code, 1);
}

TEST(Fit, WritesCaseMusclesAndBone) {
    const std::string file = (face().folder / "c.myoface").string();
    const std::string muscles = (face().folder / "m.json").string();
    const std::string bone = (face().folder / "b.ply").string();
    ASSERT_EQ(cli("fit " + face().scan + " -o " + file + " --muscles-out " + muscles +
                  " --bone-out " + bone)
                  .code,
              0);
    const auto json = nlohmann::json::parse(read_file(muscles));
    EXPECT_EQ(json["muscles"]["zygomaticus_major.L"]["kind"], "linear");
    EXPECT_EQ(json["muscles"]["orbicularis_oris_upper"]["kind"], "sphincter");
    EXPECT_EQ(json["muscles"]["orbicularis_oris_upper"]["points"].front(),
              json["muscles"]["orbicularis_oris_upper"]["points"].back());
    EXPECT_GT(read_mesh(bone).mesh.triangle_count(), 1000);
    EXPECT_EQ(
        cli("simulate " + file + " --muscle procerus=1 -o " + (face().folder / "p.obj").string())
            .code,
        0);
}

TEST(Measure, TakesEditsAndSaysBeforeAndNow) {
    const auto result = cli("measure " + face().scan + " --muscle zygomaticus_major=1");
    ASSERT_EQ(result.code, 0) << result.err;
    for (const auto& row : nlohmann::json::parse(result.out)["measures"]) {
        if (row["id"] == "ch-ch") {
            EXPECT_GT(row["difference"].get<double>(), 4.0);
            EXPECT_NEAR(row["other"].get<double>() - row["value"].get<double>(),
                        row["difference"].get<double>(), 1e-9);
        }
    }
}

TEST(Section, CutsBeforeAndNow) {
    const std::string csv = (face().folder / "s.csv").string();
    const auto made = cli("section " + face().scan +
                          " --plane horizontal --at prn --muscle zygomaticus_major=1 -o " + csv);
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.err.find("Apart by up to"), std::string::npos);
    const std::string lines = read_file(csv);
    EXPECT_EQ(lines.rfind("state,line,right_mm,up_mm\n", 0), 0U);
    EXPECT_NE(lines.find("\nnow,1,"), std::string::npos);
    expect_refusal("section " + face().scan + " --at nowhere", 1, "no landmark 'nowhere'");
    expect_refusal("section " + face().scan + " --plane tilted", 1, "none of profile, horizontal");
    expect_refusal("section " + face().scan + " --plane horizontal --at 0,500,0", 1,
                   "does not meet the face");
}

TEST(Animate, WritesPicturesAndRefusesOtherEndings) {
    const std::filesystem::path film = face().folder / "film";
    const auto made = cli("animate " + face().scan +
                          " --motion expression --expression joy=1 --frames 4 --size 96x108 "
                          "--anonymous -o " +
                          film.string());
    ASSERT_EQ(made.code, 0) << made.err;
    const Image rest = read_image(film / "frame-000.png");
    const Image smile = read_image(film / "frame-002.png");
    EXPECT_EQ(rest.width, 96);
    EXPECT_NE(rest.rgba, smile.rgba);
    EXPECT_FALSE(std::filesystem::exists(film / "frame-004.png"));
    expect_refusal("animate " + face().scan + " -o film.avi", 1, "a film is a .gif, an .mp4");
    // Without an encoder it says so instead of drawing for minutes.
    const Outcome none = run("PATH=/nowhere " MYOFACE_CLI, "animate " + face().scan + " -o f.mp4");
    EXPECT_EQ(none.code, 1);
    EXPECT_NE(none.err.find("give a folder instead"), std::string::npos) << none.err;
}

TEST(Bench, TellsWhatTheMachineDoes) {
    const auto run = cli("bench --json --vertices 3000");
    ASSERT_EQ(run.code, 0);
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_GT(json["springs"].get<int>(), 3000);
    EXPECT_GT(json["springs_per_second"].get<double>(), 1e5);
    EXPECT_GE(json["drag_frame_p99_ms"].get<double>(), json["drag_frame_median_ms"].get<double>());
    EXPECT_EQ(cli("bench --vertices 5").code, 2);
}
TEST(Convert, KeepsEveryVertex) {
    const std::string ply = (face().folder / "t.ply").string();
    const std::string obj = (face().folder / "t.obj").string();
    ASSERT_EQ(cli("convert " + face().scan + " " + ply).code, 0);
    ASSERT_EQ(cli("convert " + ply + " " + obj).code, 0);
    EXPECT_EQ(read_mesh(obj).file_vertices, read_mesh(face().scan).file_vertices);
    EXPECT_EQ(read_mesh(obj).faces.vertex, read_mesh(face().scan).faces.vertex);
}

TEST(Convert, KnowsFourFormats) {
    for (const char* name : {"c.stl", "c.glb", "c.ply", "c.obj"}) {
        const std::string out = (face().folder / name).string();
        ASSERT_EQ(cli("convert " + face().scan + " " + out).code, 0) << name;
        EXPECT_EQ(read_mesh(out).mesh.triangle_count(),
                  read_mesh(face().scan).mesh.triangle_count());
    }
    EXPECT_EQ(cli("convert " + face().scan + " x.off").code, 1);
}

TEST(Info, TellsUnitAxesAndFindings) {
    const std::string out = (face().folder / "turned.obj").string();
    Scan scan = read_mesh(face().scan);
    set_frame(scan, {1.0, Mat3::Identity()});
    scan.file_vertices = 0.001 * axes_from_text("+x-z+y").transpose() * scan.mesh.vertices;
    scan.mesh.vertices = scan.file_vertices;
    scan.frame = {};
    write_mesh(out, scan, scan.mesh.vertices);
    const auto json = nlohmann::json::parse(cli("info " + out).out);
    EXPECT_EQ(json["unit"], "m");
    EXPECT_EQ(json["axes"], "+x-z+y");
    EXPECT_GT(json["frame_confidence"], 0.5);
    EXPECT_EQ(json["components"], 35);
    EXPECT_EQ(json["parts"].size(), 35U);
    const auto known = nlohmann::json::parse(
        cli("info " + out + " --known \"from=vertex 0; to=vertex 1; mm=7\"").out);
    const Points& v = scan.file_vertices;
    EXPECT_NEAR(known["mm_per_unit"], 7.0 / (v.col(0) - v.col(1)).norm(), 1e-6);
    EXPECT_EQ(cli("info " + out + " --known \"from=nose; to=vertex 1; mm=7\"").code, 1);
}

TEST(Generate, DiffersBySexAndSeedOnly) {
    const std::string a = (face().folder / "1.ply").string();
    const std::string b = (face().folder / "2.ply").string();
    ASSERT_EQ(cli("generate --sex f --age 22 --seed 7 --vertices 3000 -o " + a).code, 0);
    ASSERT_EQ(cli("generate --sex f --age 22 --seed 7 --vertices 3000 -o " + b).code, 0);
    EXPECT_EQ(read_file(a), read_file(b));
    ASSERT_EQ(cli("generate --sex m --age 22 --seed 7 --vertices 3000 -o " + b).code, 0);
    EXPECT_NE(read_file(a), read_file(b));
}

TEST(BadInput, EndsWithOneSentence) {
    const std::string out = " -o " + (face().folder / "x.obj").string();
    expect_refusal("info no-such-file.obj", 1, "there is no such file");
    expect_refusal("simulate " + face().scan + " --muscle zygomaticus_mayor=1" + out, 1,
                   "nearest name is 'zygomaticus_major'");
    expect_refusal("simulate " + face().scan + " --muscle risorius=3" + out, 1, "between -0.5");
    expect_refusal("simulate " + face().scan + " --muscle risorius" + out, 1, "NAME=NUMBER");
    expect_refusal("simulate " + face().scan + " --drag at=tail" + out, 1, "neither a landmark");
    expect_refusal("simulate " + face().scan + " --unit ell" + out, 1, "is not one of");
    expect_refusal("simulate " + face().scan + " --unit m" + out, 1, "--unit");
    expect_refusal("simulate " + face().scan + " --landmarks nowhere.json" + out, 1,
                   "there is no such file");
    expect_refusal("render " + face().scan + " --size 0x0 -o /tmp/never.png", 1, "size");
    expect_refusal("render " + face().scan + " --layers fat -o /tmp/never.png", 1, "layer");
    const std::string empty = (face().folder / "empty.ply").string();
    std::ofstream(empty).flush();
    expect_refusal("info " + empty, 1, "is empty");
    const std::string half = (face().folder / "half.obj").string();
    const std::string whole = read_file(face().scan);
    write_file(half, whole.substr(0, whole.rfind('\n', whole.size() / 3) + 1));
    expect_refusal("info " + half, 1, "no faces");
}

TEST(WrongUsage, EndsWithTwo) {
    expect_refusal("simulate", 2, "--help");
    expect_refusal("dance", 2, "dance");
    expect_refusal("simulate " + face().scan + " --solver magic -o x.obj", 2, "solver");
    expect_refusal("generate --sex x -o x.ply", 2, "sex");
}

TEST(Help, IsThere) {
    EXPECT_EQ(cli("--help").code, 0);
    EXPECT_EQ(cli("--version").code, 0);
    EXPECT_NE(cli("simulate --help").out.find("--drag"), std::string::npos);
}

TEST(Simulate, ShapesByVolumeAndTarget) {
    const std::string report = (face().folder / "shape.json").string();
    const Outcome outcome = cli(
        "simulate " + face().scan +
        " --protect 'at=prn; radius=8' --volume 'at=pg; ml=0.5' --target 'nasal width by -2' -o " +
        (face().folder / "shape.obj").string() + " --report " + report);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto json = nlohmann::json::parse(read_file(report));
    EXPECT_NEAR(json["volumes"][0]["ml"].get<double>(), 0.5, 0.01);
    const auto& target = json["targets"][0];
    EXPECT_EQ(target["landmark"], "al");
    EXPECT_NEAR(target["reached"].get<double>() - target["before"].get<double>(), -2.0, 0.1);
    EXPECT_GT(json["shape_ml"]["chin"].get<double>(), 0.2);
    const std::string rest = " -o " + (face().folder / "no.obj").string();
    expect_refusal("simulate " + face().scan + " --target 'chin projection by 60'" + rest, 1,
                   "chin projection stays at");
    expect_refusal("simulate " + face().scan + " --target 'beauty=9'" + rest, 1,
                   "is not a measure");
    expect_refusal("simulate " + face().scan + " --volume 'at=pg; ml=500'" + rest, 1,
                   "between -20 and 20 mL");
    expect_refusal("simulate " + face().scan + " --solver explicit --seconds 1" + rest, 1,
                   "--seconds");
}

TEST(Simulate, StopsInTime) {
    const auto largest = [&](const std::string& more) {
        const std::string report = (face().folder / "time.json").string();
        const Outcome outcome =
            cli("simulate " + face().scan + " --muscle zygomaticus_major=1 " + more + " -o " +
                (face().folder / "time.obj").string() + " --report " + report);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return nlohmann::json::parse(read_file(report))["max_displacement_mm"].get<double>();
    };
    const double rest = largest("");
    EXPECT_GT(std::abs(largest("--seconds 0.017") - rest), 0.05);  // it still swings
    EXPECT_NEAR(largest("--seconds 2"), rest, 0.05);
}

TEST(Report, IsAPdfOfACase) {
    const std::string saved = (face().folder / "report.myoface").string();
    ASSERT_EQ(cli("fit " + face().scan + " -o " + saved).code, 0);
    const auto pdf = face().folder / "report.pdf";
    const Outcome outcome = cli("report " + saved + " --drag 'at=prn; view=left; move=0,2'" +
                                " --patient P-1 --notes 'tip raised' -o " + pdf.string());
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const std::string bytes = read_file(pdf);
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    EXPECT_GT(bytes.size(), 50000U);  // its pictures
    std::size_t pages = 0;
    for (std::size_t at = bytes.find("/Type /Page\n"); at != std::string::npos;
         at = bytes.find("/Type /Page\n", at + 1)) {
        ++pages;
    }
    EXPECT_EQ(pages, 2U);
    expect_refusal("report " + saved + " -o report.txt", 1, "written as .pdf");
    expect_refusal("report " + saved + " --logo none.png -o " + pdf.string(), 1, "none.png");
}

TEST(Render, DrawsWithoutADisplay) {
    const std::string png = (face().folder / "r.png").string();
    const Outcome outcome =
        run("env -u DISPLAY " MYOFACE_CLI, "render generic --layers skin --size 200x240 -o " + png);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Image image = read_image(png);
    EXPECT_EQ(image.width, 200);
    EXPECT_EQ(image.height, 240);
}

TEST(Desktop, WithoutOpenGlSaysSoInsteadOfAborting) {
    const Outcome outcome =
        run("env -u DISPLAY QT_QPA_PLATFORM=offscreen " MYOFACE_APP, "--screenshot /tmp/never.png");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("OpenGL"), std::string::npos) << outcome.err;
}

TEST(Simulate, WeakensMusclesAndTakesOtherResponses) {
    const std::string plain = (face().folder / "w0.obj").string();
    const auto smile = [&](const std::string& more, const std::string& name) {
        const std::string report = (face().folder / (name + ".json")).string();
        const Outcome made = cli("simulate " + face().scan + " --expression AU12=1 " + more +
                                 " -o " + plain + " --report " + report);
        EXPECT_EQ(made.code, 0) << made.err;
        return nlohmann::json::parse(read_file(report));
    };
    const auto full = smile("", "w0");
    const auto weak = smile("--weaken palsy_6", "w1");
    EXPECT_GT(full["max_displacement_mm"].get<double>(), 5.0);
    EXPECT_LT(weak["max_displacement_mm"].get<double>(), 1e-6);
    const auto printed = smile("--response as-printed", "w2");
    EXPECT_NE(printed["state_hash"], full["state_hash"]);
    expect_refusal("simulate generic --response cubic -o " + plain, 1, "zone-normalised");
    expect_refusal("simulate generic --weaken gout -o " + plain, 1, "palsy_4");
}

TEST(Compare, SaysHowFarAPlanIsFromTheResult) {
    const std::string after = (face().folder / "after.obj").string();
    ASSERT_EQ(
        cli("simulate " + face().scan + " --drag \"at=prn; view=left; move=-3,0\" -o " + after)
            .code,
        0);
    std::filesystem::copy_file(face().folder / "face.landmarks.json",
                               face().folder / "after.landmarks.json");
    const auto whole = [&](const std::string& plan) {
        const Outcome outcome = cli("compare " + face().scan + " " + plan + " --result " + after);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        const auto json = nlohmann::json::parse(outcome.out);
        EXPECT_LT(json["registration_mm"].get<double>(), 0.2);
        EXPECT_EQ(json["regions"][0]["region"], "whole face");
        return json["regions"][0]["mean_mm"].get<double>();
    };
    const double with_plan = whole("--drag \"at=prn; view=left; move=-3,0\"");
    const double without = whole("");
    EXPECT_LT(with_plan, 0.02);
    EXPECT_GT(without, 3.0 * with_plan);
    expect_refusal("compare " + face().scan + " --result " + face().scan + "x", 1, "no such file");
}

TEST(Report, IsAnonymousAndJapaneseWhereThatIsWanted) {
    const std::string plain = (face().folder / "r.pdf").string();
    const std::string other = (face().folder / "ja.pdf").string();
    ASSERT_EQ(cli("report " + face().scan + " --expression joy=0.5 -o " + plain).code, 0);
    const Outcome made = cli("report " + face().scan +
                             " --expression joy=0.5 --language ja --anonymous -o " + other);
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string bytes = read_file(other);
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    EXPECT_NE(bytes, read_file(plain));
    expect_refusal("report generic --language xx -o " + other, 2, "language");
}

}  // namespace
}  // namespace myoface
