#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/scenes/every_field.hpp"
#include "tests/scenes/scene_text.hpp"

/// The schema and the reader say the same: fields, defaults, enumerators and ranges.

using namespace twofold;
using namespace twofold::scene_text;
using nlohmann::json;

namespace {

json written(const std::string& text) { return json::parse(scene_to_json(parse(text))); }

const json& schema() {
    static const json document = json::parse(contents(folder / "scene.schema.json"));
    return document;
}

/// The alternatives that a schema node stands for, references followed.
std::vector<json> alternatives(const json& node) {
    if (node.contains("$ref"))
        return alternatives(
            schema().at(json::json_pointer(node["$ref"].get<std::string>().substr(1))));
    std::vector<json> result;
    for (const std::string key : {"anyOf", "allOf"})
        if (node.contains(key) && !node.contains("properties"))
            for (const json& part : node[key])
                for (json& alternative : alternatives(part))
                    result.push_back(std::move(alternative));
    if (result.empty()) result.push_back(node);
    return result;
}

/// One step into a document and into its schema.
struct Step {
    std::string name;     ///< key or index
    std::string general;  ///< key, * for a name that the author chose, # for an index
    json schema;
};

std::vector<Step> steps_into(const json& value, const json& node) {
    std::vector<Step> steps;
    for (const json& kind : alternatives(node)) {
        if (value.is_array() && kind.contains("items"))
            for (std::size_t i = 0; i < value.size(); ++i)
                steps.push_back({std::to_string(i), "#", kind["items"]});
        if (!value.is_object() || !kind.contains("properties")) {
            if (value.is_object() && kind.contains("additionalProperties"))
                for (const auto& [key, member] : value.items())
                    steps.push_back({key, "*", kind["additionalProperties"]});
            continue;
        }
        for (const auto& [key, member] : value.items()) {
            INFO(key);
            REQUIRE(kind["properties"].contains(key));
            steps.push_back({key, key, kind["properties"][key]});
        }
    }
    return steps;
}

/// Calls visit(value, schema node, pointer, general path) for all that `value` holds.
template <class Visit>
void walk(const json& value, const json& node, const json::json_pointer& pointer,
          const std::string& general, const Visit& visit) {
    visit(value, node, pointer, general);
    for (const Step& step : steps_into(value, node)) {
        const json& child = value.is_array() ? value[std::stoul(step.name)] : value[step.name];
        const auto next = value.is_array() ? pointer / std::stoul(step.name) : pointer / step.name;
        walk(child, step.schema, next, general + "/" + step.general, visit);
    }
}

/// General paths of all properties of the schema.
std::set<std::string> schema_fields(const json& node, const std::string& path) {
    std::set<std::string> fields;
    const auto add = [&](const json& child, const std::string& name) {
        fields.merge(schema_fields(child, path + "/" + name));
    };
    for (const json& kind : alternatives(node)) {
        if (kind.contains("items")) add(kind["items"], "#");
        if (kind.contains("additionalProperties") && kind["additionalProperties"].is_object())
            add(kind["additionalProperties"], "*");
        if (!kind.contains("properties")) continue;
        for (const auto& [key, child] : kind["properties"].items()) {
            fields.insert(path + "/" + key);
            add(child, key);
        }
    }
    return fields;
}

/// The documents with all that the program writes into them, and the short forms as they are.
std::vector<json> full_documents() {
    std::vector<json> documents;
    for (const std::string& text : every_field) documents.push_back(written(text));
    documents.push_back(json::parse(short_forms));
    return documents;
}

/// A field's path as error texts write it.
std::string dotted(const json::json_pointer& pointer) {
    std::string text = pointer.to_string().substr(1);
    for (char& c : text)
        if (c == '/') c = '.';
    return text;
}

/// The error after one value of `document` is replaced.
std::string error_with(json document, const json::json_pointer& pointer, const json& value) {
    document[pointer] = value;
    return error_of(document.dump());
}

void check_limits(const json& document, const json& kind, const json::json_pointer& pointer) {
    const auto refuses = [&](const json& value) {
        const std::string error = error_with(document, pointer, value);
        INFO(error << " for " << value);
        CHECK(error.rfind("x.json: " + dotted(pointer) + ": " + value.dump() + " is not in", 0) ==
              0);
    };
    const auto takes = [&](const json& value) {
        const std::string error = error_with(document, pointer, value);
        INFO(error << " for " << value);
        CHECK(error.find(" is not in") == std::string::npos);
    };
    const bool whole = kind["type"] == "integer";
    const auto beyond = [&](const json& limit, double direction) -> json {
        if (whole) return limit.get<int>() + static_cast<int>(direction);
        return std::nextafter(limit.get<double>(), direction * 1e300);
    };
    if (kind.contains("minimum")) takes(kind["minimum"]), refuses(beyond(kind["minimum"], -1));
    if (kind.contains("exclusiveMinimum")) refuses(kind["exclusiveMinimum"]);
    if (kind.contains("maximum")) takes(kind["maximum"]), refuses(beyond(kind["maximum"], 1));
    if (kind.contains("exclusiveMaximum")) refuses(kind["exclusiveMaximum"]);
}

void check_enumerators(const json& document, const json& kind, const json::json_pointer& pointer) {
    // A name that is known may still not go with the others of its document.
    for (const json& value : kind["enum"]) {
        const std::string error = error_with(document, pointer, value);
        INFO(error);
        CHECK(error.find("unknown value") == std::string::npos);
        CHECK(error.find("is not one of") == std::string::npos);
    }
    if (kind["enum"][0].is_string()) CHECK(error_with(document, pointer, "nothing") != "accepted");
}

}  // namespace

TEST_CASE("what is read is what is written, in every field") {
    // No field here has its default and no two fields of a kind are equal, so a field that is read
    // into another's place, or not at all, shows.
    CHECK(written(every_field[0]) == json::parse(every_field[0]));
    for (const std::string& text : every_field) {
        const json full = written(text);
        const json given = json::parse(text);
        CHECK(full["environment"] == given["environment"]);
        CHECK(written(full.dump()) == full);
    }
    CHECK(written(every_field[1])["white"] == json::parse(R"({"percentile": 98.5})"));
}

TEST_CASE("shipped scenes mean the same after being written") {
    for (const std::string& name : shipped) {
        const std::string text = scene_to_json(read_scene(folder / name));
        CHECK(scene_to_json(parse_scene(text, "y.json", "/somewhere/else")) == text);
    }
}

TEST_CASE("numbers come back to the bit") {
    for (const double x : {0.1, 1.0 / 3.0, 5e-324, 2.2250738585072014e-308, 123456789.12345679,
                           -0.0, 9007199254740993.0, 1.7976931348623157e308}) {
        Scene scene = parse(smallest);
        InlineMesh inline_mesh;
        inline_mesh.mesh.positions = {Vec3(x, -x, x)};
        scene.meshes["q"] = inline_mesh;
        const Scene again = parse(scene_to_json(scene));
        const Vec3 position = std::get<InlineMesh>(again.meshes.at("q")).mesh.positions[0];
        CHECK(position.x == x);
        CHECK(std::signbit(position.x) == std::signbit(x));
        CHECK(position.y == -x);
    }
}

TEST_CASE("the schema has exactly the fields that the reader takes and the writer writes") {
    std::set<std::string> fields;
    for (const json& document : full_documents())
        walk(document, schema(), json::json_pointer(), "",
             [&](const json&, const json&, const json::json_pointer&, const std::string& general) {
                 const std::string name = general.substr(general.rfind('/') + 1);
                 if (!general.empty() && name != "*" && name != "#") fields.insert(general);
             });
    fields.insert("/$schema");  // taken for the editors' sake and not kept
    fields.insert("/results");  // written by a run into its manifest, not kept either
    CHECK(fields == schema_fields(schema(), ""));
    CHECK(error_of(smallest, {"$schema=scene.schema.json"}) == "accepted");
}

TEST_CASE("the schema's defaults are the reader's") {
    int compared = 0;
    const auto compare = [&](const json& value, const json& node, const json::json_pointer& pointer,
                             const std::string&) {
        for (const json& kind : alternatives(node)) {
            const json& place = node.contains("default") ? node : kind;
            if (!place.contains("default")) continue;
            INFO(pointer.to_string());
            CHECK(value == place["default"]);
            ++compared;
            break;
        }
    };
    // What is on here is on with all its own fields at their defaults; what holds it is not
    // compared.
    const std::string all_on = R"({"image": {}, "camera": {}, "factorization": {}, "textures":
        {"c": {"checkerboard": {}}}, "meshes": {"s": {"sphere": {}}, "q": {"quad": {}},
                   "v": {"vertices": {"positions": [[0, 0, 0]], "indices": []}}},
        "materials": {"a": {"cook_torrance": {}}, "b": {"modified_phong": {}},
                      "c": {"merl": {"file": "m"}}},
        "environment": {"painted": {}}, "objects": [{"mesh": "q", "material": "a"}],
        "historical": [{"mesh": "q", "factors": "f"}],
        "custom": {}, "passes": [{"mesh": "v",
            "units": [{"env": {}}, {"texgen": {"s": "eye_linear"}}], "alpha_test": {},
            "depth_test": {}, "blend": {}, "fog": {}, "scissor": {"width": 1, "height": 1},
            "combiners": {"stages": [{"rgb": {"inputs": [{}]}, "alpha": {"inputs": [{}]}}],
                          "final": {"a": {}, "e": {}, "g": {}}}}]})";
    const std::set<std::string> given{"/environment",
                                      "/textures",
                                      "/meshes",
                                      "/materials",
                                      "/objects",
                                      "/historical",
                                      "/passes",
                                      "/passes/#/units",
                                      "/passes/#/alpha_test",
                                      "/passes/#/blend",
                                      "/passes/#/depth_test",
                                      "/passes/#/fog",
                                      "/passes/#/scissor",
                                      "/passes/#/combiners",
                                      "/passes/#/units/#/texgen",
                                      "/passes/#/units/#/texgen/s"};
    walk(written(all_on), schema(), json::json_pointer(), "",
         [&](const json& value, const json& node, const json::json_pointer& pointer,
             const std::string& general) {
             if (given.count(general) == 0) compare(value, node, pointer, general);
         });
    CHECK(compared > 150);
}

TEST_CASE("the schema's ranges and enumerators are the reader's", "[long]") {
    int compared = 0;
    for (const json& document : full_documents())
        walk(document, schema(), json::json_pointer(), "",
             [&](const json& value, const json& node, const json::json_pointer& pointer,
                 const std::string& general) {
                 // Indices are limited by the number of vertices, and presets are a set.
                 if (general.find("/indices/") != std::string::npos) return;
                 for (const json& kind : alternatives(node)) {
                     if (value.is_number() && kind.contains("type")) {
                         if (kind["type"] != "number" && kind["type"] != "integer") continue;
                         check_limits(document, kind, pointer);
                         ++compared;
                     }
                     if (kind.contains("enum") && general != "/presets/#")
                         check_enumerators(document, kind, pointer);
                 }
             });
    CHECK(compared > 100);
}
