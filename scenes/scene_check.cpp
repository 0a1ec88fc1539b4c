#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "scenes/json_text.hpp"
#include "scenes/scene_names.hpp"
#include "scenes/scene_parts.hpp"
#include "texunit/error.hpp"

namespace twofold::scene_io {
namespace {

/// A scene that is being checked and the name of its file.
struct Checked {
    const Scene& scene;
    std::string_view file;
    bool may_be_absolute;

    [[noreturn]] void fail(std::string_view path, std::string_view what) const {
        throw Error(ExitCode::failure, path.empty() ? fmt::format("{}: {}", file, what)
                                                    : fmt::format("{}: {}: {}", file, path, what));
    }
};

template <class T>
void check_name(const Checked& checked, const std::string& path, std::string_view kind,
                const std::string& name, const std::map<std::string, T>& known) {
    if (known.count(name) != 0) return;
    std::vector<std::string_view> names;
    for (const auto& [key, value] : known) names.push_back(key);
    checked.fail(
        path, fmt::format("no {} named '{}'{}", kind, printable(name), did_you_mean(name, names)));
}

/// A scene is something one gets from others: it must not reach outside its own folder.
void check_path(const Checked& checked, const std::string& where, const std::string& text) {
    const std::filesystem::path path(text);
    const std::string shown = fmt::format("'{}'", printable(text));
    if (text.empty()) checked.fail(where, "is empty");
    if (std::any_of(text.begin(), text.end(), [](char c) { return c >= '\0' && c < ' '; }))
        checked.fail(where, shown + " has a control character");
    if (std::find(path.begin(), path.end(), "..") != path.end())
        checked.fail(where, shown + " leads out of the scene's folder by '..'");
    if (path.is_absolute() && !checked.may_be_absolute)
        checked.fail(where, shown + " is absolute; only a scene with 'directory' may name such");
}

void check_texture_paths(const Checked& checked, const std::string& where,
                         const TextureSpec& texture) {
    const bool cube = texture.images.size() > 1;
    for (std::size_t i = 0; i < texture.images.size(); ++i)
        if (const auto* file = std::get_if<TextureFile>(&texture.images[i]))
            check_path(checked,
                       cube ? fmt::format("{}.cube.faces.{}.file", where, i) : where + ".file",
                       file->path);
}

void check_paths(const Checked& checked) {
    if (checked.scene.directory.find('\0') != std::string::npos)
        checked.fail("directory", "has a NUL character");
    if (checked.scene.environment)
        if (const auto* file = std::get_if<EnvironmentFile>(&checked.scene.environment->source))
            check_path(checked,
                       fmt::format("environment.{}", name_in(environment_form_names, file->form)),
                       file->path);
    for (const auto& [name, brdf] : checked.scene.materials)
        if (const auto* measured = std::get_if<MeasuredBrdf>(&brdf))
            check_path(checked,
                       fmt::format("materials.{}.{}.file", name,
                                   name_in(measured_names, measured->source.format)),
                       measured->source.path);
    for (std::size_t i = 0; i < checked.scene.historical.size(); ++i)
        check_path(checked, fmt::format("historical.{}.factors", i),
                   checked.scene.historical[i].factors);
    for (const auto& [name, mesh] : checked.scene.meshes)
        if (const auto* file = std::get_if<MeshFile>(&mesh))
            check_path(checked, fmt::format("meshes.{}.file", name), file->path);
    for (const auto& [name, texture] : checked.scene.textures)
        check_texture_paths(checked, "textures." + name, texture);
}

/// What is lit or textured by direction needs normals; files and generated meshes always have them.
void check_normals(const Checked& checked, const std::string& path, const std::string& name) {
    const auto* vertices = std::get_if<InlineMesh>(&checked.scene.meshes.at(name));
    if (vertices != nullptr && vertices->mesh.normals.empty())
        checked.fail(path,
                     fmt::format("the mesh '{}' has no normals, which are needed here", name));
}

/// Whether the upper left 3x3 part has no inverse to speak of. Its rows are first scaled to a
/// largest element of 1, so that the size of the model does not matter.
bool is_singular(const Mat4& matrix) {
    std::array<Vec3, 3> rows;
    for (int i = 0; i < 3; ++i) {
        const Vec3 row{matrix[0][i], matrix[1][i], matrix[2][i]};
        const double largest = max_component({std::abs(row.x), std::abs(row.y), std::abs(row.z)});
        if (largest == 0.0) return true;
        rows[static_cast<std::size_t>(i)] = row / largest;
    }
    return std::abs(dot(rows[0], cross(rows[1], rows[2]))) <= 1e-12;
}

bool uses_normals(const PassState& state) {
    return std::any_of(state.units.begin(), state.units.end(),
                       [](const auto& unit) { return unit && uses_normal(unit->texgen); });
}

/// A unit's target and its texture must be of one kind, and rectangles have neither levels nor a
/// way to repeat.
void check_target(const Checked& checked, const std::string& path, const TextureUnitState& unit,
                  const std::string& name) {
    const auto found = checked.scene.textures.find(name);
    if (found == checked.scene.textures.end()) return;
    const bool cube = found->second.images.size() > 1;
    if (cube != (unit.target == TextureTarget::cube_map))
        checked.fail(path + ".target",
                     fmt::format("the texture '{}' is {} cube map", name, cube ? "a" : "no"));
    if (unit.target == TextureTarget::rectangle && found->second.border != 0)
        checked.fail(path + ".target",
                     fmt::format("a rectangle has no border, and the texture '{}' has", name));
}

/// @source NV_texture_rectangle
void check_rectangle(const Checked& checked, const std::string& path,
                     const TextureUnitState& unit) {
    if (unit.target != TextureTarget::rectangle) return;
    const auto repeats = [](Wrap wrap) {
        return wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat;
    };
    if (repeats(unit.wrap_s) || repeats(unit.wrap_t))
        checked.fail(path + ".target", "a rectangle cannot repeat");
    if (unit.mip_filter != MipFilter::off)
        checked.fail(path + ".target", "a rectangle has one level and needs 'mip_filter' off");
}

/// SPHERE_MAP makes s and t (and r, as the chips do), the maps of directions s, t and r.
/// @source OpenGL 1.3, 2.10.4
void check_texgen(const Checked& checked, const std::string& path, const TexGenState& texgen) {
    const TexGen q = texgen.mode[3];
    if (q == TexGen::sphere_map || q == TexGen::normal_map || q == TexGen::reflection_map)
        checked.fail(path + ".texgen.q",
                     "q is not made from normals: none, object_linear or "
                     "eye_linear");
}

void check_unit(const Checked& checked, const std::string& path, const TextureUnitState& unit,
                const std::string& texture) {
    if (!texture.empty())
        check_name(checked, path + ".texture", "texture", texture, checked.scene.textures);
    check_target(checked, path, unit, texture);
    check_rectangle(checked, path, unit);
    check_texgen(checked, path, unit.texgen);
}

void check_pass(const Checked& checked, const std::string& path, const ScenePass& pass) {
    check_name(checked, path + ".mesh", "mesh", pass.mesh, checked.scene.meshes);
    for (std::size_t i = 0; i < pass.textures.size(); ++i)
        if (pass.state.units[i])
            check_unit(checked, fmt::format("{}.units.{}", path, i), *pass.state.units[i],
                       pass.textures[i]);
    if (!uses_normals(pass.state)) return;
    check_normals(checked, path + ".mesh", pass.mesh);
    if (is_singular(pass.state.modelview))
        checked.fail(path + ".modelview",
                     "its upper left 3x3 part has no inverse, which 'texgen' needs for normals");
}

void check_object(const Checked& checked, const std::string& path, const FactoredObject& object) {
    check_name(checked, path + ".mesh", "mesh", object.mesh, checked.scene.meshes);
    check_name(checked, path + ".material", "material", object.material, checked.scene.materials);
    check_normals(checked, path + ".mesh", object.mesh);
}

/// A surface light field is of one surface.
void check_one_object_a_material(const Checked& checked) {
    std::map<std::string, std::size_t> first;
    for (std::size_t i = 0; i < checked.scene.objects.size(); ++i) {
        const auto [found, fresh] = first.try_emplace(checked.scene.objects[i].material, i);
        if (!fresh)
            checked.fail(fmt::format("objects.{}.material", i),
                         fmt::format("'{}' is that of objects.{} too, and with the model slf a "
                                     "material belongs to one object",
                                     printable(found->first), found->second));
    }
}

}  // namespace

void check_scene(const Scene& scene, std::string_view file, bool may_be_absolute) {
    const Checked checked{scene, file, may_be_absolute};
    check_paths(checked);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        check_object(checked, fmt::format("objects.{}", i), scene.objects[i]);
    if (scene.factorization.model == Model::slf) check_one_object_a_material(checked);
    for (std::size_t i = 0; i < scene.passes.size(); ++i)
        check_pass(checked, fmt::format("passes.{}", i), scene.passes[i]);
    for (std::size_t i = 0; i < scene.historical.size(); ++i) {
        const std::string where = fmt::format("historical.{}.mesh", i);
        check_name(checked, where, "mesh", scene.historical[i].mesh, scene.meshes);
        check_normals(checked, where, scene.historical[i].mesh);
    }
    if (scene.objects.empty() && scene.historical.empty() && scene.passes.empty())
        checked.fail("", "needs at least one element in 'objects', 'historical' or 'passes'");
    if (!scene.objects.empty() && !scene.environment)
        checked.fail("environment", "is missing, and 'objects' are lit by it");
}

}  // namespace twofold::scene_io
