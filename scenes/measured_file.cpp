#include "scenes/measured_file.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/number_text.hpp"

namespace twofold {
namespace {

using Bytes = std::vector<unsigned char>;

/// Far above every file of the three kinds: MERL's have 35 MB.
constexpr std::size_t max_file_bytes = std::size_t{64} << 20;
constexpr std::size_t max_list_bytes = std::size_t{1} << 20;

std::string_view text_of(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

MeasuredData parse(MeasuredFormat format, const Bytes& bytes, const std::string& name) {
    if (format == MeasuredFormat::merl) return parse_merl(bytes, name);
    if (format == MeasuredFormat::cornell) return parse_cornell(text_of(bytes), name);
    return parse_rgl(bytes, name);
}

std::string recognised(const std::filesystem::path& path, const std::string& sha256,
                       std::size_t bytes) {
    const auto list = path.parent_path() / known_list;
    if (!std::filesystem::is_regular_file(list)) return {};
    return known_name(text_of(read_file(list, max_list_bytes)), sha256, bytes);
}

MeasuredBrdf load(const MeasuredFile& source, const std::filesystem::path& path, int threads) {
    const Bytes bytes = read_file(path, max_file_bytes);
    const MeasuredData data = parse(source.format, bytes, path.string());
    MeasuredModel model = make_model(data, source.fill, threads);
    model.report.sha256 = sha256_of(bytes);
    model.report.recognised = recognised(path, model.report.sha256, bytes.size());
    return {source, std::make_shared<const MeasuredModel>(std::move(model))};
}

}  // namespace

Brdf loaded(const Brdf& brdf, const std::filesystem::path& directory, int threads) {
    const auto* measured = std::get_if<MeasuredBrdf>(&brdf);
    if (measured == nullptr) return brdf;
    return load(measured->source, directory / measured->source.path, threads);
}

std::string sha256_of(std::span<const unsigned char> bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
        throw Error(ExitCode::failure, "OpenSSL has no SHA-256");
    std::string text;
    for (unsigned i = 0; i < length; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
}

std::string known_name(std::string_view list, std::string_view sha256, std::size_t bytes) {
    while (!list.empty()) {
        std::string_view line = take_line(list);
        const std::string_view sum = take_word(line), size = take_word(line);
        if (sum == sha256 && parse_integer(size) == static_cast<long long>(bytes))
            return std::string(take_word(line));
    }
    return {};
}

}  // namespace twofold
