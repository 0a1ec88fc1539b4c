#include "texunit/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <string_view>
#include <utility>

#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/image_header.hpp"

namespace twofold {
namespace {

using Bytes = std::vector<unsigned char>;

constexpr const char* pinned_date = "1970:01:01 00:00:00";
constexpr int max_side = max_picture_side;
constexpr int max_channels = max_picture_channels;
constexpr int rows_of_strip = 256;  // the longest blocks of rows that OpenEXR packs
constexpr std::size_t max_file_bytes = std::size_t{1} << 32;

Error bad_file(const std::string& name, const std::string& what) {
    return Error(ExitCode::bad_file, name + ": " + what);
}

/// The bytes of a file. OpenImageIO 2.4's own reader of memory takes an offset of -1, which a
/// damaged OpenEXR file can name, for the place before the first byte.
class CheckedMemory : public OIIO::Filesystem::IOMemReader {
  public:
    explicit CheckedMemory(std::span<const unsigned char> bytes)
        : IOMemReader(bytes.data(), bytes.size()), bytes_(bytes.size()) {}

    std::size_t pread(void* to, std::size_t count, std::int64_t offset) override {
        if (offset < 0 || static_cast<std::size_t>(offset) >= bytes_) return 0;
        const std::size_t left = bytes_ - static_cast<std::size_t>(offset);
        return IOMemReader::pread(to, std::min(count, left), offset);
    }

  private:
    std::size_t bytes_;
};

/// An opened picture. The reader refers to the proxy, so it is declared after it and destroyed
/// before.
struct Input {
    std::string name;
    std::unique_ptr<CheckedMemory> proxy;
    std::unique_ptr<OIIO::ImageInput> reader;
    OIIO::ImageSpec spec;
};

/// OpenImageIO's own limit is one setting per process; it stands behind the checks made here.
/// OpenEXR works in this thread: its own wait for ever if memory ends while work is handed to them.
void configure_open_image_io() {
    static const bool done =
        OIIO::attribute("limits:imagesize_MB", 4096) && OIIO::attribute("exr_threads", -1);
    if (!done)
        throw Error(ExitCode::failure,
                    "OpenImageIO: no settings limits:imagesize_MB and exr_threads");
}

/// OpenImageIO tells of exceptions, and libpng of what malloc refused, by texts alone.
std::string checked_reason(const std::string& reason) {
    for (const char* text : {"bad_alloc", "nsufficient memory", "ut of memory", "allocate memory"})
        if (reason.find(text) != std::string::npos) throw std::bad_alloc();
    return reason.empty() ? "no reason given" : reason;
}

/// With the first line of the reader's own reason.
Error reader_error(const Input& input, const char* what) {
    const std::string reason = checked_reason(input.reader->geterror());
    return bad_file(input.name, fmt::format("{} {} data: {}", what, input.reader->format_name(),
                                            printable(reason.substr(0, reason.find('\n')), 240)));
}

/// Opens with the reader of `format` alone. All four read from memory in OpenImageIO 2.4; one that
/// does not would have to open the file by name, past the bytes that were checked, so it is
/// refused.
Input open_input(std::span<const unsigned char> bytes, const PictureFormat& format,
                 const std::string& name) {
    configure_open_image_io();
    Input input{
        name, std::make_unique<CheckedMemory>(bytes), OIIO::ImageInput::create(format.reader), {}};
    if (!input.reader || input.reader->format_name() != std::string_view(format.reader) ||
        !input.reader->supports("ioproxy"))
        throw bad_file(name, fmt::format("OpenImageIO cannot read {} from memory: {}",
                                         format.reader, checked_reason(OIIO::geterror())));
    input.reader->set_ioproxy(input.proxy.get());
    OIIO::ImageSpec configuration;
    configuration.attribute("oiio:UnassociatedAlpha", 1);
    if (!input.reader->open(format.reader, input.spec, configuration))
        throw reader_error(input, "damaged");
    return input;
}

void check_size(const OIIO::ImageSpec& spec, std::int64_t pixels_possible,
                const std::string& name) {
    check_picture_size(spec.width, spec.height, name);
    if (std::int64_t{spec.width} * spec.height > pixels_possible)
        throw bad_file(name, fmt::format("{} x {} pixels do not fit into a file of this length: "
                                         "truncated or damaged",
                                         spec.width, spec.height));
    if (spec.nchannels < 1 || spec.nchannels > max_channels)
        throw bad_file(name, fmt::format("{} channels, allowed are 1 to 4", spec.nchannels));
    if (spec.tile_width > max_side || spec.tile_height > max_side)
        throw bad_file(name, fmt::format("tiles of {} x {}", spec.tile_width, spec.tile_height));
}

/// Refuses by name what would otherwise be read as something else than it is.
void check_layout(const OIIO::ImageSpec& spec, const std::string& name) {
    if (spec.deep || spec.depth > 1) throw bad_file(name, "a deep or volume image");
    if (spec.x != 0 || spec.y != 0 || spec.width != spec.full_width ||
        spec.height != spec.full_height)
        throw bad_file(name, "data window and display window differ; crop or pad it first");
    if (spec.get_int_attribute("Orientation", 1) != 1)
        throw bad_file(name, "rows or columns are not stored from the top left; turn it first");
    const auto& names = spec.channelnames;
    if (spec.nchannels >= 3 && (names[0] != "R" || names[1] != "G" || names[2] != "B"))
        throw bad_file(
            name, fmt::format("channels {}, {}, {} where R, G, B are expected", printable(names[0]),
                              printable(names[1]), printable(names[2])));
    for (int c = 0; c < spec.nchannels; ++c)
        if (spec.channelformat(c) == OIIO::TypeDesc::UINT)
            throw bad_file(name, "32-bit integer channels, which have no value as a colour");
}

/// OpenEXR's DWA packs up to 64 equal pixels into one number before it deflates.
int pixels_packed(const OIIO::ImageSpec& spec) {
    const std::string compression = spec.get_string_attribute("compression");
    return compression.starts_with("dwa") ? 64 : 1;
}

Input open_checked(std::span<const unsigned char> bytes, const std::string& name) {
    const PictureFormat& format = identify_picture(bytes, name);
    const std::int64_t most = most_pixels(bytes, format, name);
    Input input = open_input(bytes, format, name);
    check_size(input.spec, most * pixels_packed(input.spec), name);
    check_layout(input.spec, name);
    return input;
}

std::size_t sample_count(const OIIO::ImageSpec& spec) {
    return static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
           static_cast<std::size_t>(spec.nchannels);
}

/// Rows [begin, end), which are whole rows of tiles where there are tiles.
bool read_rows(Input& input, int begin, int end, OIIO::TypeDesc type, void* samples) {
    const OIIO::ImageSpec& spec = input.spec;
    if (spec.tile_width != 0)
        return input.reader->read_tiles(0, 0, 0, spec.width, begin, end, 0, 1, 0, spec.nchannels,
                                        type, samples);
    return input.reader->read_scanlines(0, 0, begin, end, 0, 0, spec.nchannels, type, samples);
}

/// All samples as T, and no error left behind: reading alone does not tell all of them. Memory
/// grows with the rows that the file has: one of a few kilobytes can claim 2^28 pixels.
template <typename T>
std::vector<T> read_samples(Input& input, OIIO::TypeDesc type) {
    const OIIO::ImageSpec& spec = input.spec;
    const std::size_t row = sample_count(spec) / static_cast<std::size_t>(spec.height);
    const int strip = spec.tile_width != 0 ? spec.tile_height : rows_of_strip;
    std::vector<T> samples;
    for (int begin = 0; begin < spec.height; begin += strip) {
        const int end = std::min(begin + strip, spec.height);
        const std::size_t before = samples.size();
        samples.resize(static_cast<std::size_t>(end) * row);
        const bool done = read_rows(input, begin, end, type, &samples[before]);
        if (!done || input.reader->has_error()) throw reader_error(input, "truncated or damaged");
    }
    return samples;
}

/// What the header says and the samples do not. Dividing by an EXPOSURE of 0 would give Inf, and
/// files carry it without having been scaled, so both numbers are only passed on (hard case D05).
std::vector<std::string> notes_of(const OIIO::ImageSpec& spec) {
    std::vector<std::string> notes;
    for (const auto& [attribute, header] :
         {std::pair("hdr:exposure", "EXPOSURE"), std::pair("oiio:Gamma", "GAMMA")}) {
        const float value = spec.get_float_attribute(attribute, 1.0F);
        if (value != 1.0F)
            notes.push_back(fmt::format("{}={} in the header is not applied", header, value));
    }
    const int parts = spec.get_int_attribute("oiio:subimages", 1);
    if (parts > 1) notes.push_back(fmt::format("the first of {} parts is used", parts));
    return notes;
}

/// Integers as fractions of their maximum, by a division that rounds correctly; OpenImageIO
/// multiplies by a rounded 1 / maximum, which is off by a bit for 126 of the 256 bytes.
template <typename T>
std::vector<float> read_fractions(Input& input, OIIO::TypeDesc type) {
    const std::vector<T> samples = read_samples<T>(input, type);
    std::vector<float> fractions(samples.size());
    std::transform(samples.begin(), samples.end(), fractions.begin(), [](T sample) {
        return static_cast<float>(sample) / static_cast<float>(std::numeric_limits<T>::max());
    });
    return fractions;
}

std::vector<float> read_floats(Input& input) {
    if (input.spec.format == OIIO::TypeDesc::UINT8)
        return read_fractions<std::uint8_t>(input, OIIO::TypeDesc::UINT8);
    if (input.spec.format == OIIO::TypeDesc::UINT16)
        return read_fractions<std::uint16_t>(input, OIIO::TypeDesc::UINT16);
    return read_samples<float>(input, OIIO::TypeDesc::FLOAT);
}

/// One pixel of 1 to 4 channels: grey, grey and alpha, RGB, RGBA.
Rgba8 spread(const unsigned char* s, int channels) {
    switch (channels) {
        case 1:
            return {s[0], s[0], s[0], 255};
        case 2:
            return {s[0], s[0], s[0], s[1]};
        case 3:
            return {s[0], s[1], s[2], 255};
        default:
            return {s[0], s[1], s[2], s[3]};
    }
}

/// A picture that cannot be written is the caller's mistake, so no file is named.
OIIO::ImageSpec checked_spec(int width, int height, int channels, std::size_t samples,
                             OIIO::TypeDesc type) {
    const bool sizes_fit = width >= 1 && height >= 1 && width <= max_side && height <= max_side &&
                           channels >= 1 && channels <= max_channels;
    OIIO::ImageSpec spec =
        sizes_fit ? OIIO::ImageSpec(width, height, channels, type) : OIIO::ImageSpec();
    if (!sizes_fit || sample_count(spec) != samples)
        throw Error(ExitCode::failure,
                    fmt::format("picture: {} x {} pixels of {} channels with {} samples", width,
                                height, channels, samples));
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

Bytes encode(const char* format, const OIIO::ImageSpec& spec, const void* samples) {
    configure_open_image_io();
    Bytes bytes;
    OIIO::Filesystem::IOVecOutput proxy(bytes);
    const auto writer = OIIO::ImageOutput::create(format);
    if (!writer || !writer->supports("ioproxy"))
        throw bad_file(format, "OpenImageIO cannot write this format to memory: " +
                                   checked_reason(OIIO::geterror()));
    writer->set_ioproxy(&proxy);
    const bool written = writer->open(format, spec) && writer->write_image(spec.format, samples);
    const bool closed = writer->close();
    const std::string reason = writer->geterror();  // set even where all calls reported success
    if (!written || !closed || !reason.empty())
        throw bad_file(format, "encoding failed: " + checked_reason(reason));
    return bytes;
}

}  // namespace

ReadImage decode_float_image(std::span<const unsigned char> bytes, const std::string& name) {
    Input input = open_checked(bytes, name);
    ReadImage result{{input.spec.width, input.spec.height, input.spec.nchannels, {}},
                     notes_of(input.spec)};
    result.image.samples = read_floats(input);
    return result;
}

ReadImage read_float_image(const std::filesystem::path& path) {
    return decode_float_image(read_file(path, max_file_bytes), path.string());
}

ByteImage decode_png(std::span<const unsigned char> bytes, const std::string& name) {
    if (std::string_view(identify_picture(bytes, name).reader) != "png")
        throw bad_file(name, "not a PNG file");
    Input input = open_checked(bytes, name);
    if (input.spec.format != OIIO::TypeDesc::UINT8)
        throw bad_file(name, "more than 8 bits a channel");
    const auto samples = read_samples<unsigned char>(input, OIIO::TypeDesc::UINT8);
    const auto channels = static_cast<std::size_t>(input.spec.nchannels);
    ByteImage image{input.spec.width, input.spec.height, {}};
    image.pixels.reserve(samples.size() / channels);
    for (std::size_t i = 0; i < samples.size(); i += channels)
        image.pixels.push_back(spread(&samples[i], input.spec.nchannels));
    return image;
}

ByteImage read_png(const std::filesystem::path& path) {
    return decode_png(read_file(path, max_file_bytes), path.string());
}

std::vector<unsigned char> encode_png(const ByteImage& image) {
    static_assert(sizeof(Rgba8) == 4, "pixels are handed over as they lie");
    const OIIO::ImageSpec spec =
        checked_spec(image.width, image.height, 4, image.pixels.size() * 4, OIIO::TypeDesc::UINT8);
    Bytes bytes = encode("png", spec, image.pixels.data());
    if (decode_png(bytes, "png").pixels != image.pixels)
        throw bad_file("png", "encoding changed the picture");
    return bytes;
}

std::vector<unsigned char> encode_exr(const FloatImage& image) {
    OIIO::ImageSpec spec = checked_spec(image.width, image.height, image.channels,
                                        image.samples.size(), OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    // Otherwise the writer stores the time of day, and no two files are equal.
    spec.attribute("DateTime", pinned_date);
    Bytes bytes = encode("openexr", spec, image.samples.data());
    Input written = open_checked(bytes, "openexr");
    const std::vector<float> decoded = read_floats(written);
    // Bit patterns, not values: NaN differs from itself and -0 equals 0. Without memory the writer
    // leaves attributes out and reports success.
    if (decoded.size() != image.samples.size() ||
        std::memcmp(decoded.data(), image.samples.data(), decoded.size() * sizeof(float)) != 0 ||
        written.spec.get_string_attribute("DateTime") != pinned_date ||
        written.spec.get_string_attribute("compression") != "zip")
        throw bad_file("openexr", "encoding changed the picture");
    return bytes;
}

}  // namespace twofold
