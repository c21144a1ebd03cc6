// SPDX-License-Identifier: MIT
// The program as a user and a script meet it: exit codes, streams, files, reports.
#include "support/cli.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <tuple>

#include "base/file.h"
#include "image/exr.h"
#include "image/png.h"

namespace lueur {
namespace {

TEST_F(Cli, HelpAndVersionGoToStdout) {
  EXPECT_EQ(run({"--version"}).out.find("lueur "), 0u);
  for (const Arguments& command : {Arguments{},
                                   {"render"},
                                   {"bench"},
                                   {"diff"},
                                   {"devices"},
                                   {"reference"},
                                   {"compare"},
                                   {"sequence"},
                                   {"paper"},
                                   {"diff"},
                                   {"techniques"},
                                   {"scene"},
                                   {"scene", "list"},
                                   {"scene", "info"},
                                   {"scene", "sheet"},
                                   {"scene", "export"}}) {
    Arguments arguments = command;
    arguments.push_back("--help");
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.err, "");
    EXPECT_NE(ended.out.find("Examples:"), std::string::npos);
    EXPECT_NE(ended.out.find("Exit codes:"), std::string::npos);
  }
}

TEST_F(Cli, UsageErrorsAreOneLine) {
  expect_error(2, {}, "render");
  expect_error(2, {"rendre"}, "rendre");
  expect_error(2, {"scene", "explode"}, "explode");
  expect_error(2, {"render"}, "SCENE");
  expect_error(2, {"render", "cornell"}, "-o");
  expect_error(2, {"render", "cornel", "-o", "x.png"}, "cornell");
  expect_error(2, {"render", "cor\nnell", "-o", "x.png"}, "cornell");
  expect_error(2, {"render", "cornell", "-o", "x.jpg"}, ".png");
  expect_error(2, {"render", "cornell", "-o", "x.png", "-o", "x.png"}, "twice");
  expect_error(2, {"render", "cornell", "-o", "x.exr", "--size", "16384x16384"}, "x.exr");
  for (const char* size : {"0x0", "1e9x1", "-5x3", "12", "12x", "x12", "16385x1", "1x16385",
                           "4294967297x1", "99999999999999999999x1", "1x1x1", "", " 1x1", "1 x 1"})
    expect_error(2, {"render", "cornell", "-o", "x.png", "--size", size}, "--size");
  const std::pair<const char*, const char*> values[] = {
      {"--technique", "magic"}, {"--set", "samples"},     {"--set", "samples=0"},
      {"--set", "samples=1e9"}, {"--set", "nothing=1"},   {"--set", "=1"},
      {"--seed", "-1"},         {"--seed", "4294967296"}, {"--exposure", "bright"},
      {"--exposure", "nan"},    {"--exposure", "1e9"},    {"--time", "inf"},
      {"--tone-map", "sepia"},  {"--camera", "99"},       {"--camera", "nobody"},
      {"--side-camera", "99"},  {"--side-camera", ""},    {"--device", "99"},
      {"--view", "no.image"},   {"--frobnicate", "1"}};
  for (const auto& [flag, value] : values)
    expect_error(2, {"render", "cornell", "-o", "x.png", "--size", "8x8", flag, value}, flag);
  expect_error(2, {"render", "cornell", "-o", "x.png", "--preset", "slow"}, "fast, balanced");
  expect_error(2, {"bench", "--techniques", "none", "--preset", "fast"}, "--preset");
  expect_error(2, {"render", "cornell", "--dump", "*"}, "--dump-to");
  expect_error(2, {"render", "cornell", "--size", "8x8", "--dump", "no.*", "--dump-to", "passes"},
               "no.*");
  expect_error(2, {"render", "atrium:triangles=7", "-o", "x.png"}, "triangles");
  expect_error(2, {"bench", "--frames", "0"}, "--frames");
  expect_error(2, {"bench", "--triangles", "10000,many"}, "--triangles");
  expect_error(2, {"bench", "--scene", "cornell", "--triangles", "10000"}, "--triangles");
  for (const char* list : {"", "magic", "none,", "none,none", "none:samples=8", "hierarchical:",
                           "hierarchical:samples=0", "none,hierarchical:nothing=1"})
    expect_error(2, {"bench", "--techniques", list}, "--techniques '");
  expect_error(2, {"bench", "--techniques", "none", "--set", "samples=8"}, "--techniques");
  for (const char* scale : {"", "radius", "start=full", "samples=0", "samples=8,8", "samples=8,",
                            "pixels=12", "triangles=many", "nothing=1"})
    expect_error(2, {"bench", "--scale", scale}, "--scale");
  expect_error(2, {"bench", "--scene", "cornell", "--scale", "triangles"}, "--scale");
  expect_error(2, {"bench", "--technique", "none", "--scale", "samples"}, "none");
  expect_error(2, {"bench", "--scale", "samples", "--triangles", "10000"}, "--triangles");
  expect_error(2,
               {"bench", "--size", "8x8", "--scene", "cornell", "--techniques",
                "hierarchical:levels=2:only_level=3"},
               "only_level=3");
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
}

TEST_F(Cli, BadInputFiles) {
  const std::string longest(3000, 'x');
  const std::pair<const char*, std::string> files[] = {
      {"empty.gltf", ""},
      {"noise.glb", "glTF" + longest},
      {"wrong.gltf", "[1, 2, 3]"},
      {"deep.gltf", std::string(100000, '[')},
      {"huge.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 1e18}],
                       "bufferViews": [{"buffer": 0, "byteLength": 1e18}],
                       "accessors": [{"count": 1e17, "componentType": 5126, "type": "VEC3"}],
                       "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                       "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0})"},
      {"outside.gltf", R"({"asset": {"version": "2.0"}, "buffers":
                          [{"uri": "../../../etc/passwd", "byteLength": 9}],
                          "bufferViews": [{"buffer": 0, "byteLength": 9}],
                          "accessors": [{"bufferView": 0, "count": 1, "componentType": 5121,
                                         "type": "SCALAR"}],
                          "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                          "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0})"}};
  for (const auto& [name, content] : files) {
    ASSERT_TRUE(write_file(folder_ / name, content).ok());
    expect_error(3, {"render", name, "-o", "x.png"}, name);
    expect_error(3, {"scene", "info", name}, name);
  }
  expect_error(3, {"render", "missing.gltf", "-o", "x.png"}, "missing.gltf");
  expect_error(3, {"render", ".", "-o", "x.png"});
  EXPECT_FALSE(fs::exists(folder_ / "x.png"));
}

TEST_F(Cli, OutputThatCannotBeWritten) {
  fs::create_directory(folder_ / "folder.png");
  for (const char* path : {"missing/x.png", "folder.png", "/proc/x.png", "/dev/null/x.png"})
    expect_error(4, {"render", "cornell", "--size", "8x8", "-o", path}, path);
  expect_error(4, {"scene", "export", "cornell", "-o", "missing/x.glb"}, "missing");
  expect_error(4, {"render", "cornell", "--dump", "*", "--dump-to", "/proc/x"}, "/proc/x");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Cli, FullDisk) {
  for (const char* path : {"x.png", "x.exr"}) {
    fs::create_symlink("/dev/full", folder_ / path);
    expect_error(4, {"render", "cornell", "--size", "8x8", "-o", path}, path);
  }
  EXPECT_EQ(file_count(), 2u);
}

TEST_F(Cli, StdoutThatCannotBeWritten) {
  for (const char* out : {"/dev/full", ""}) {
    for (const Arguments& arguments : {Arguments{"--help"},
                                       {"--version"},
                                       {"techniques"},
                                       {"devices", "--json"},
                                       {"scene", "list"},
                                       {"render", "cornell", "--size", "8x8", "--json"}}) {
      const Ended ended = run(arguments, out);
      EXPECT_EQ(ended.code, 4) << arguments[0] << " to '" << out << "'";
      EXPECT_EQ(line_count(ended.err), 1u) << ended.err;
    }
  }
}

TEST_F(Cli, RenderReport) {
  const Ended ended =
      render({"--json", "-o", "a.png", "-o", "a.exr", "--seed", "3", "--set", "samples=8"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["scene"], "cornell");
  EXPECT_EQ(json["size"], nlohmann::json::array({64, 36}));
  EXPECT_EQ(json["technique"], "hierarchical");
  EXPECT_EQ(json["settings"]["samples"], 8);
  EXPECT_EQ(json["settings"]["start"], "half");
  EXPECT_EQ(json["settings"]["rotate"], true);
  EXPECT_EQ(json["seed"], 3);
  EXPECT_EQ(json["tone_map"], "khronos-neutral");
  EXPECT_EQ(json["outputs"], nlohmann::json::array({"a.png", "a.exr"}));
  EXPECT_TRUE(json["warnings"].is_array());
  for (const char* key : {"memory_bytes", "peak_memory_bytes", "triangles"})
    EXPECT_GT(json[key].get<uint64_t>(), 0u) << key;
  for (const char* key : {"technique_ms", "frame_ms", "load_ms"})
    EXPECT_GT(json[key].get<double>(), 0.0) << key;
  EXPECT_TRUE(json["exposure_ev"].is_number());
  EXPECT_GE(json["off_screen_share"].get<double>(), 0.0);
  EXPECT_LE(json["off_screen_share"].get<double>(), 1.0);
  for (const char* key : {"name", "kind", "driver"})
    EXPECT_TRUE(json["device"][key].is_string()) << key;

  double technique_ms = 0, frame_ms = 0;
  for (const auto& pass : json["passes"]) {
    const auto name = pass["name"].get<std::string>();
    frame_ms += pass["gpu_ms"].get<double>();
    if (name.starts_with("hierarchical.")) technique_ms += pass["gpu_ms"].get<double>();
  }
  // Each time is rounded to a nanosecond.
  const double rounding_ms = 1e-6 * static_cast<double>(json["passes"].size());
  EXPECT_NEAR(json["technique_ms"].get<double>(), technique_ms, rounding_ms);
  EXPECT_NEAR(json["frame_ms"].get<double>(), frame_ms, rounding_ms);
}

// A preset is settings, whichever way it is asked for.
TEST_F(Cli, Presets) {
  const auto techniques = nlohmann::json::parse(run({"techniques", "--json"}).out);
  ASSERT_EQ(techniques["techniques"][0]["name"], "hierarchical");
  const auto& presets = techniques["techniques"][0]["presets"];
  ASSERT_EQ(presets[0]["name"], "fast");
  const Ended ended = render({"--json", "--preset", "fast", "--set", "samples=8"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto settings = nlohmann::json::parse(ended.out)["settings"];
  for (const auto& [name, value] : presets[0]["settings"].items())
    EXPECT_EQ(settings[name], name == "samples" ? nlohmann::json(8) : value) << name;
  EXPECT_NE(run({"techniques"}).out.find("--preset fast"), std::string::npos);
}

TEST_F(Cli, TechniqueNone) {
  const Ended ended = render({"--technique", "none", "--json", "-o", "a.exr"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  EXPECT_EQ(json["technique"], "none");
  EXPECT_EQ(json["settings"], nlohmann::json::object());
  EXPECT_EQ(json["technique_ms"], 0.0);
  EXPECT_FALSE(json.contains("off_screen_share"));
  const auto layers = read_exr(folder_ / "a.exr");
  ASSERT_TRUE(layers.ok()) << layers.error().message;
  for (const ImageLayer& layer : *layers) EXPECT_NE(layer.name, "indirect");
}

// What alpha holds is a layer of the name that the technique gives it, and only a share of samples
// off the screen is reported as one.
TEST_F(Cli, DiffuseAlphaHasItsName) {
  const auto listed = nlohmann::json::parse(run({"techniques", "--json"}).out)["techniques"];
  std::map<std::string, std::string> names = {{"none", ""}};
  for (const auto& technique : listed)
    names[technique["name"].get<std::string>()] = technique["diffuse_alpha"].get<std::string>();
  EXPECT_EQ(names["hierarchical"], "off_screen");
  EXPECT_EQ(names["indirect_lights"], "gathered");
  std::set<std::string> all;
  for (const auto& [technique, name] : names) all.insert(name);
  for (const auto& [technique, name] : names) {
    SCOPED_TRACE(technique);
    const Ended ended = render({"--technique", technique, "--json", "-o", "a.exr"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(nlohmann::json::parse(ended.out).contains("off_screen_share"), name == "off_screen");
    const auto layers = read_exr(folder_ / "a.exr");
    ASSERT_TRUE(layers.ok()) << layers.error().message;
    size_t found = 0;
    for (const ImageLayer& layer : *layers) {
      if (layer.name.empty() || !all.contains(layer.name)) continue;
      EXPECT_EQ(layer.name, name);
      ++found;
      EXPECT_GT(*std::max_element(layer.image.samples.begin(), layer.image.samples.end()), 0.0f);
    }
    EXPECT_EQ(found, name.empty() ? 0u : 1u);
  }
}

// composed = direct + albedo * indirect, by the layers themselves.
TEST_F(Cli, ExrLayers) {
  ASSERT_EQ(render({"-o", "a.exr"}).code, 0);
  const auto layers = read_exr(folder_ / "a.exr");
  ASSERT_TRUE(layers.ok()) << layers.error().message;
  const auto find = [&](const std::string& name) -> const ImageF& {
    static const ImageF kMissing;
    for (const ImageLayer& layer : *layers)
      if (layer.name == name) return layer.image;
    ADD_FAILURE() << "no layer " << name;
    return kMissing;
  };
  for (const char* name : {"emission", "motion", "material", "off_screen"}) find(name);
  const ImageF &composed = find(""), &direct = find("direct"), &indirect = find("indirect"),
               &albedo = find("albedo"), &source = find("source"), &specular = find("specular"),
               &normal = find("normal"), &depth = find("depth");
  ASSERT_FALSE(testing::Test::HasFailure());
  // Half floats keep 11 bits; five of them meet here.
  const auto bound = [](float value) { return 5.0f * 0x1p-11f * value + 1e-4f; };
  size_t surfaces = 0;
  for (uint32_t y = 0; y < 36; ++y)
    for (uint32_t x = 0; x < 64; ++x) {
      float length2 = 0;
      for (uint32_t c = 0; c < 3; ++c) {
        const float d = direct.at(x, y, c);
        EXPECT_NEAR(d, source.at(x, y, c) + specular.at(x, y, c), bound(d));
        const float sum = d + albedo.at(x, y, c) * indirect.at(x, y, c);
        EXPECT_NEAR(composed.at(x, y, c), sum, bound(sum)) << x << ", " << y;
        length2 += normal.at(x, y, c) * normal.at(x, y, c);
      }
      const float z_m = depth.at(x, y, 0);
      EXPECT_NEAR(length2, z_m > 0 ? 1.0f : 0.0f, 0.01f);
      if (z_m == 0.0f) continue;
      ++surfaces;
      // The box is 5.6 m deep and the camera 8 m before it.
      EXPECT_GT(z_m, 7.0f);
      EXPECT_LT(z_m, 14.5f);
    }
  EXPECT_GT(surfaces, 400u);
}

TEST_F(Cli, SeedDecidesTheBytes) {
  ASSERT_EQ(render({"-o", "a.png", "--seed", "1"}).code, 0);
  ASSERT_EQ(render({"-o", "b.png", "--seed", "1"}).code, 0);
  ASSERT_EQ(render({"-o", "c.png", "--seed", "1", "--json"}).code, 0);
  ASSERT_EQ(render({"-o", "d.png", "--seed", "2"}).code, 0);
  const std::string a = text_of(folder_ / "a.png");
  EXPECT_FALSE(a.empty());
  EXPECT_TRUE(a == text_of(folder_ / "b.png"));
  EXPECT_TRUE(a == text_of(folder_ / "c.png"));
  EXPECT_FALSE(a == text_of(folder_ / "d.png"));
}

TEST_F(Cli, ViewsAndDumps) {
  const Ended list = render({"--list-views"});
  ASSERT_EQ(list.code, 0) << list.err;
  EXPECT_NE(list.out.find("hierarchical.gather@0.indirect\n"), std::string::npos) << list.out;

  // Level 0 of a 64x36 picture at half resolution.
  ASSERT_EQ(render({"--view", "hierarchical.gather@0.indirect", "-o", "v.png"}).code, 0);
  const auto view = read_png(folder_ / "v.png");
  ASSERT_TRUE(view.ok()) << view.error().message;
  EXPECT_EQ(view->width, 32u);
  EXPECT_EQ(view->height, 18u);

  ASSERT_EQ(render({"--dump", "hierarchical.gather*", "--dump-to", "passes"}).code, 0);
  const auto dumped = read_exr(folder_ / "passes/hierarchical.gather@0.indirect.exr");
  ASSERT_TRUE(dumped.ok()) << dumped.error().message;
  EXPECT_EQ(dumped->front().image.width, 32u);
  for (const auto& entry : fs::directory_iterator(folder_ / "passes"))
    EXPECT_TRUE(entry.path().filename().string().starts_with("hierarchical.gather@"));
}

TEST_F(Cli, ChecksFindNothing) {
  const Ended ended = render({"--scan", "--validate"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.err, "");
}

TEST_F(Cli, ExportedSceneRenders) {
  ASSERT_EQ(run({"scene", "export", "cornell", "-o", "cornell.glb"}).code, 0);
  const Ended info = run({"scene", "info", "cornell.glb", "--json"});
  ASSERT_EQ(info.code, 0) << info.err;
  const auto ours = nlohmann::json::parse(run({"scene", "info", "cornell", "--json"}).out);
  const auto theirs = nlohmann::json::parse(info.out);
  EXPECT_EQ(theirs["triangles"], ours["triangles"]);
  EXPECT_EQ(theirs["cameras"].size(), ours["cameras"].size());
  const Ended ended = run({"render", "cornell.glb", "--size", "64x36", "-o", "x.png"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_TRUE(read_png(folder_ / "x.png").ok());
}

TEST_F(Cli, ObjectTakesThePlaceOfTheScenesOwn) {
  ASSERT_EQ(run({"scene", "export", "cornell", "-o", "cornell.glb"}).code, 0);
  const Ended info = run({"scene", "info", "--object", "cornell.glb", "floating-object", "--json"});
  ASSERT_EQ(info.code, 0) << info.err;
  const auto json = nlohmann::json::parse(info.out);
  EXPECT_EQ(json["scene"], "floating-object:object=cornell.glb");
  EXPECT_LT(json["triangles"], 10'000);  // not the 69 000 of its own
  EXPECT_EQ(json["cameras"][0]["name"], "front");

  // Scenes without an object, files and missing files are refused in one line.
  expect_error(2, {"scene", "info", "cornell", "--object", "cornell.glb"}, "divider-room");
  expect_error(2, {"scene", "info", "cornell.glb", "--object", "cornell.glb"}, "divider-room");
  expect_error(2, {"bench", "--object", "cornell.glb"}, "'atrium' has no object");
  expect_error(3, {"scene", "info", "divider-room", "--object", "missing.glb"}, "missing.glb");
}

TEST_F(Cli, OddSizes) {
  for (const auto& [size, width, height] :
       {std::tuple("1x1", 1u, 1u), {"37x61", 37u, 61u}, {"1x40", 1u, 40u}}) {
    const Ended ended = run({"render", "cornell", "--size", size, "-o", "x.png"});
    EXPECT_EQ(ended.code, 0) << size << ": " << ended.err;
    const auto picture = read_png(folder_ / "x.png");
    ASSERT_TRUE(picture.ok()) << picture.error().message;
    EXPECT_EQ(picture->width, width);
    EXPECT_EQ(picture->height, height);
  }
}

TEST_F(Cli, BenchReport) {
  const Ended ended = run({"bench", "--scene", "cornell", "--size", "70x37", "--frames", "2",
                           "--set", "samples=8", "--set", "levels=2", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_EQ(json["frames"], 2);
  EXPECT_GT(json["technique_ms"].get<double>(), 0.0);
  EXPECT_EQ(json["size"], nlohmann::json::array({70, 37}));
  EXPECT_EQ(json["settings"]["levels"], 2);
  for (const char* key : {"technique_ms", "frame_ms", "wall_ms", "cpu_ms"}) {
    const auto spread = json[std::string(key) + "_spread"];
    EXPECT_GT(spread["least"].get<double>(), 0.0) << key;
    EXPECT_LE(spread["least"], spread["lower_quartile"]) << key;
    EXPECT_LE(spread["lower_quartile"], json[key]) << key;
    EXPECT_LE(json[key], spread["upper_quartile"]) << key;
    EXPECT_LE(spread["upper_quartile"], spread["most"]) << key;
  }
  EXPECT_GT(json["technique_memory_bytes"].get<uint64_t>(), 70u * 37 * 8);  // its output alone
  EXPECT_GT(json["memory_bytes"], json["technique_memory_bytes"]);
  EXPECT_GE(json["peak_memory_bytes"], json["memory_bytes"]);
  uint64_t samples[2] = {};
  for (const auto& pass : json["passes"])
    for (int level = 0; level < 2; ++level)
      if (pass["name"] == "hierarchical.gather@" + std::to_string(level))
        samples[level] = pass["samples"];
  EXPECT_EQ(samples[0], 35u * 19 * 8);
  EXPECT_EQ(samples[1], 18u * 10 * 8);
}

// The light's view that the renderer draws for the technique is told beside the technique's time.
TEST_F(Cli, BenchTellsWhatTheHostDoesForATechnique) {
  const Arguments command = {"bench",    "--scene", "cornell",         "--size",         "64x36",
                             "--frames", "1",       "--set",           "sources=lights", "--set",
                             "levels=2", "--set",   "light_view_px=64"};
  Arguments with_json = command;
  with_json.emplace_back("--json");
  const auto json = nlohmann::json::parse(run(with_json).out, nullptr, false);
  ASSERT_TRUE(json.is_object());
  double views_ms = 0;
  for (const auto& pass : json["passes"])
    if (pass["name"].get<std::string>().starts_with("renderer.view."))
      views_ms += pass["gpu_ms"].get<double>();
  EXPECT_GT(views_ms, 0.0);
  // Of another frame than the passes, so that the two differ by what the machine does.
  EXPECT_GT(json["host_ms"].get<double>(), 0.0);
  EXPECT_LT(json["host_ms"].get<double>(), json["frame_ms"].get<double>());
  const auto alone = nlohmann::json::parse(
      run({"bench", "--scene", "cornell", "--size", "64x36", "--frames", "1", "--json"}).out,
      nullptr, false);
  EXPECT_EQ(alone["host_ms"], 0.0);
  EXPECT_NE(run(command).out.find("host, for the technique"), std::string::npos);
}

TEST_F(Cli, BenchOfSeveralTechniques) {
  const Arguments command = {
      "bench",  "--scene",      "cornell",
      "--size", "64x36",        "--frames",
      "1",      "--techniques", "hierarchical:levels=2,none,hierarchical:levels=1:start=full"};
  Arguments with_json = command;
  with_json.emplace_back("--json");
  const Ended ended = run(with_json);
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object());
  EXPECT_FALSE(json.contains("technique"));  // the runs differ
  const auto& runs = json["runs"];
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0]["label"], "hierarchical:levels=2");
  EXPECT_EQ(runs[0]["technique_ratio"], 1.0);
  EXPECT_EQ(runs[0]["frame_ratio"], 1.0);
  EXPECT_EQ(runs[1]["technique"], "none");
  EXPECT_EQ(runs[1]["technique_ratio"], 0.0);
  EXPECT_EQ(runs[1]["technique_memory_bytes"], 0);
  EXPECT_EQ(runs[2]["settings"]["levels"], 1);
  EXPECT_EQ(runs[2]["settings"]["start"], "full");
  EXPECT_GT(runs[2]["technique_ratio"].get<double>(), 0.0);
  EXPECT_GE(json["technique_ms_max_over_min"].get<double>(), 1.0);

  const Ended text = run(command);
  ASSERT_EQ(text.code, 0) << text.err;
  size_t width = 0;
  for (size_t at = 0, end = 0; (end = text.out.find('\n', at)) != std::string::npos; at = end + 1)
    width = std::max(width, end - at);
  EXPECT_LE(width, 100u) << text.out;
}

TEST_F(Cli, BenchScales) {
  const Arguments command = {"bench", "--scene", "cornell", "--size", "64x36", "--frames", "1"};
  const auto bench = [&](const Arguments& more) {
    Arguments arguments = command;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ended.out;
  };
  const auto json =
      nlohmann::json::parse(bench({"--techniques", "hierarchical:levels=2,hierarchical:levels=3",
                                   "--scale", "pixels=32x18,64x36,128x72", "--json"}),
                            nullptr, false);
  ASSERT_TRUE(json.is_object());
  ASSERT_EQ(json["runs"].size(), 6u);
  EXPECT_EQ(json["runs"][5]["size"], nlohmann::json::array({128, 72}));
  EXPECT_EQ(json["runs"][5]["settings"]["levels"], 3);
  EXPECT_EQ(json["scale"]["of"], "pixels");
  const auto& series = json["scale"]["series"];
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[1]["technique"], "hierarchical:levels=3");
  EXPECT_EQ(series[1]["first_run"], 3);
  EXPECT_EQ(series[1]["values"], nlohmann::json::array({32.0 * 18, 64.0 * 36, 128.0 * 72}));
  for (const char* group : {"technique", "all passes", "hierarchical.gather", "renderer.light"}) {
    const auto& fits = series[0]["fits"];
    const auto fit =
        std::find_if(fits.begin(), fits.end(), [&](const auto& f) { return f["group"] == group; });
    ASSERT_NE(fit, fits.end()) << group;
    for (const char* key : {"exponent", "exponent_error", "r_squared", "constant_ms"})
      EXPECT_TRUE((*fit)[key].is_number()) << group << " " << key;
  }

  const std::string text = bench({"--scale", "samples=8,16"});
  EXPECT_NE(text.find("exponent"), std::string::npos) << text;
  EXPECT_NE(text.find("hierarchical.gather"), std::string::npos) << text;
  // One value has no exponent, and --triangles is a scale like any other.
  EXPECT_FALSE(nlohmann::json::parse(bench({"--scale", "samples=8", "--json"})).contains("scale"));
  const auto triangles = nlohmann::json::parse(
      run({"bench", "--size", "64x36", "--frames", "1", "--triangles", "10000,20000", "--json"})
          .out,
      nullptr, false);
  EXPECT_EQ(triangles["technique"], "hierarchical");
  EXPECT_EQ(triangles["runs"][1]["scene"], "atrium:triangles=20000");
  EXPECT_EQ(triangles["scale"]["of"], "triangles");
  // Met within 10 %.
  EXPECT_NEAR(triangles["scale"]["series"][0]["values"][1].get<double>(), 20000.0, 2000.0);
}

}  // namespace
}  // namespace lueur
