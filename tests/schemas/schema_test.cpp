// Holds each schema to the program's reader of that kind of file: what the schema names, the reader knows,
// and what neither names, both refuse. A JSON Schema validator judges the files that the project comes with.
#include "core/error.h"
#include "core/files.h"
#include "core/folders.h"
#include "core/strict_json.h"
#include "jobs/contest/outside_method.h"
#include "jobs/recorded/frame_camera.h"
#include "plan/claims/claim.h"
#include "plan/plan.h"
#include "scene/view_file.h"
#include "screen/method/method.h"
#include "support/support.h"
#include "tuning/tuning_definition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

namespace aoscore {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::output_dir;
using testing::run_aoscore;
using testing::run_shell;
using testing::ShellRun;

json schema_named(const std::string& name) {
    return parse_json_file(data_dir() / "reports" / "schemas" / name);
}

/// A place in a schema; `file` is what its references are relative to.
struct SchemaPart {
    json schema;
    std::string file;
};

/// The parts that describe the same value: the part itself, what it refers to, and its choices.
std::vector<SchemaPart> alternatives(const SchemaPart& part) {
    std::vector<SchemaPart> all{part};
    if (part.schema.contains("$ref")) {
        const std::string reference = part.schema["$ref"];
        const auto hash = reference.find('#');
        const std::string file = hash == 0 ? part.file : reference.substr(0, hash);
        const json::json_pointer pointer(reference.substr(hash + 1));
        for (SchemaPart& one : alternatives({schema_named(file).at(pointer), file})) all.push_back(one);
    }
    for (const char* choices : {"oneOf", "anyOf"}) {
        if (!part.schema.contains(choices)) continue;
        for (const json& choice : part.schema[choices]) {
            for (SchemaPart& one : alternatives({choice, part.file})) all.push_back(one);
        }
    }
    return all;
}

/// Calls `visit` with every object of the example that has a schema of its members, and that schema.
void walk(const json& value, const json::json_pointer& at, const SchemaPart& part,
          const std::function<void(const json::json_pointer&, const json& properties)>& visit) {
    for (const SchemaPart& one : alternatives(part)) {
        if (value.is_array() && one.schema.contains("items") && one.schema["items"].is_object()) {
            for (std::size_t i = 0; i < value.size(); ++i)
                walk(value[i], at / i, {one.schema["items"], one.file}, visit);
        }
        if (!value.is_object()) continue;
        if (one.schema.contains("properties")) {
            const json& properties = one.schema["properties"];
            // Of the kinds of experiment, the one that the example is.
            const json kind = properties.value("kind", json::object());
            if (kind.contains("const") && kind["const"] != value.value("kind", "table")) continue;
            visit(at, properties);
            for (const auto& [key, member] : value.items()) {
                if (properties.contains(key)) walk(member, at / key, {properties[key], one.file}, visit);
            }
        } else if (const auto others = one.schema.find("additionalProperties");
                   others != one.schema.end() && others->is_object()) {
            for (const auto& [key, member] : value.items())
                walk(member, at / key, {*others, one.file}, visit);
        }
    }
}

/// A kind of file: an example, and how the program reads one in this folder. It throws where it refuses it.
struct Kind {
    std::string id;
    fs::path example;
    std::function<void(const json& content, const fs::path& folder)> read;
};

void write_json(const fs::path& path, const json& content) {
    fs::create_directories(path.parent_path());
    write_atomically(path, content.dump());
}

/// Reads content as the only experiment of a data folder whose other parts are the project's.
void read_experiment(const json& content, const fs::path& folder) {
    const fs::path data = data_dir(), copy = folder / "data";
    fs::create_directories(copy / "reports");
    for (const char* part : {"shaders", "scenes"}) {
        if (!fs::exists(copy / part)) fs::create_directory_symlink(data / part, copy / part);
    }
    if (!fs::exists(copy / "reports" / "claims"))
        fs::create_directory_symlink(data / "reports" / "claims", copy / "reports" / "claims");
    const std::string id = content.at("id").get<std::string>();
    write_json(copy / "reports" / (id + ".json"), content);
    const char* before = std::getenv("AOSCORE_DATA");
    const std::string restored = before == nullptr ? "" : before;
    setenv("AOSCORE_DATA", copy.c_str(), 1);
    std::optional<Error> refused;
    try {
        plan_experiments({id}, 0.1);
    } catch (const Error& e) {
        refused = e;
    }
    fs::remove(copy / "reports" / (id + ".json"));
    restored.empty() ? unsetenv("AOSCORE_DATA") : setenv("AOSCORE_DATA", restored.c_str(), 1);
    if (refused) throw *refused;
}

void read_method(const fs::path& of, const json& content, const fs::path& folder) {
    const fs::path copy = folder / "methods" / "a-copy";
    fs::remove_all(copy);
    fs::create_directories(copy.parent_path());
    fs::copy(of, copy);
    write_json(copy / "method.json", content);
    load_methods(folder / "methods");
}

std::vector<Kind> kinds(const fs::path& folder) {
    const fs::path data = data_dir();
    std::vector<Kind> all;
    for (const char* method : {"sd-hbao", "gtao", "n8ao", "multi-view-hbao", "xegtao"}) {
        const fs::path of = data / "shaders" / "methods" / method;
        all.push_back({"method", of / "method.json",
                       [of](const json& content, const fs::path& to) { read_method(of, content, to); }});
    }
    all.push_back(
        {"presets", data / "shaders/methods/gtao/tuned.json", [](const json& content, const fs::path& to) {
             write_json(to / "presets.json", content);
             std::vector<MethodDescriptor> methods = load_methods();
             add_presets(methods, to / "presets.json");
         }});
    all.push_back(
        {"views", data / "scenes/sponza_crytek/views.json", [](const json& content, const fs::path& to) {
             write_json(to / "views.json", content);
             read_view_file(to / "views.json");
         }});
    const json cameras = {
        {{"fovy_deg", 50}, {"near_m", 0.1}, {"far_m", 50}},
        {{"fovx_deg", 80}},
        {{"fovy_deg", 50}, {"near_m", 0.1}, {"far_m", "infinite"}, {"normal_signs", {1, -1, 1}}},
        {{"projection", "orthographic"}, {"half_height_m", 2}}};
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const fs::path file = folder / ("camera-" + std::to_string(i) + ".json");
        write_json(file, cameras[i]);
        all.push_back({"camera", file, [](const json& content, const fs::path& to) {
                           write_json(to / "changed.json", content);
                           read_frame_camera(to / "changed.json", 16.0 / 9);
                       }});
    }
    const fs::path outside = data / "contestants" / "threejs-gtao";
    all.push_back({"contestant", outside / "contestant.json", [](const json& content, const fs::path& to) {
                       const fs::path copies = to / "contestants";
                       if (!fs::exists(copies))
                           fs::copy(data_dir() / "contestants", copies, fs::copy_options::recursive);
                       write_json(copies / "threejs-gtao" / "contestant.json", content);
                       load_outside_method(copies / "threejs-gtao");
                   }});
    for (const char* experiment : {"hussain-table-3", "today", "vermeer-table-9-1"})
        all.push_back(
            {"experiment", data / "reports" / (std::string(experiment) + ".json"), read_experiment});
    for (const char* claims : {"hussain", "field", "gravas"})
        all.push_back({"claims", data / "reports/claims" / (std::string(claims) + ".json"),
                       [](const json& content, const fs::path& to) {
                           write_json(to / "claims" / "c.json", content);
                           load_claims(to / "claims");
                       }});
    return all;
}

/// What the reader says of the content; empty where it takes it.
std::string refusal(const Kind& kind, const json& content, const fs::path& folder) {
    try {
        kind.read(content, folder);
    } catch (const std::exception& e) {
        return e.what();
    }
    return "";
}

/// By object of a schema, told by the members that it names: which of them no example showed the program to
/// read. Of two members that exclude each other, such as fovy_deg and half_height_m, an example has only one.
using UnreadMembers = std::map<std::string, std::set<std::string>>;

/// Gives the object each member that the schema names and it lacks, and notes those that its reader refuses
/// as unknown.
void try_members(const Kind& kind, const json& example, const json::json_pointer& at, const json& properties,
                 const fs::path& folder, UnreadMembers& unread) {
    std::set<std::string> refused;
    std::string form;
    for (const auto& [key, schema] : properties.items()) {
        form += key + " ";
        if (example.at(at).contains(key)) continue;
        json changed = example;
        changed[at][key] = json::array({json::array()});
        if (refusal(kind, changed, folder).find("unknown key") != std::string::npos) refused.insert(key);
    }
    const auto [found, is_new] = unread.try_emplace(form, refused);
    if (!is_new) std::erase_if(found->second, [&](const std::string& key) { return !refused.contains(key); });
}

TEST(FileSchema, NamesNoMemberThatTheProgramDoesNotRead) {
    const fs::path folder = output_dir();
    UnreadMembers unread;
    for (const Kind& kind : kinds(folder)) {
        const json example = parse_json_file(kind.example);
        const std::string file = kind.id + ".schema.json";
        std::set<std::string> tried;
        walk(example, json::json_pointer(), {schema_named(file), file},
             [&](const json::json_pointer& at, const json& properties) {
                 std::string members;
                 for (const auto& [key, schema] : properties.items())
                     members += key + (example.at(at).contains(key) ? "! " : " ");
                 // One object of a form with the same members will do: a claims file has hundreds.
                 if (tried.insert(members).second) try_members(kind, example, at, properties, folder, unread);
             });
        EXPECT_FALSE(tried.empty()) << kind.id;
        EXPECT_EQ(refusal(kind, example, folder), "") << kind.example;
    }
    for (const auto& [members, refused] : unread)
        EXPECT_THAT(refused, ::testing::IsEmpty()) << "of the object with " << members;
}

TEST(FileSchema, OfAKindNamesWhatAnEditorMayPutAtTheTop) {
    const fs::path folder = output_dir();
    for (const Kind& kind : kinds(folder)) {
        json example = parse_json_file(kind.example);
        example["$schema"] = kind.id + ".schema.json";
        EXPECT_EQ(refusal(kind, example, folder), "") << kind.example;
        EXPECT_TRUE(schema_named(kind.id + ".schema.json").contains("description"));
    }
}

TEST(FileSchema, AcceptsEveryFileOfTheProjectAndRefusesUnknownMembers) {
    const fs::path folder = output_dir();
    const auto score = run_aoscore(
        "score plane --view facing --size 48x32 --samples 4 --methods gtao --advise --out score", folder);
    ASSERT_EQ(score.exit_code, 0) << score.err;
    const auto listed = run_aoscore("schema", folder);
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    EXPECT_THAT(listed.out, HasSubstr("results "));
    const auto results = run_aoscore("schema results", folder);
    ASSERT_EQ(results.exit_code, 0) << results.err;
    write_atomically(folder / "results.schema.json", results.out);
    const ShellRun run =
        run_shell("node '" + (testing::source_dir() / "tests/schemas/validate.mjs").string() + "' '" +
                  testing::source_dir().string() + "' '" + folder.string() + "'");
    EXPECT_EQ(run.status, 0) << run.text;
    EXPECT_THAT(run.text, HasSubstr(" files, 0 refused"));
}

TEST(FileSchema, OfAnUnknownKindIsAnErrorThatListsTheKinds) {
    const auto run = run_aoscore("schema method-descriptor", output_dir());
    EXPECT_EQ(run.exit_code, 64);
    EXPECT_THAT(run.err, HasSubstr("claims"));
}

}  // namespace
}  // namespace aoscore
