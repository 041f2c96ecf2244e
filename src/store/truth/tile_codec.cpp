#include "store/truth/tile_codec.h"

#include "core/error.h"
#include "reference/estimate/falloff.h"

#include <zlib.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace aoscore {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes are stored as they lie in memory");

constexpr int kCompression = 1;  // sums are mostly noise: higher levels gain almost nothing

/// The value as an integer, in multiples of `step`.
std::uint64_t steps_of(double value, double step) {
    const double steps = value / step;
    const auto whole = static_cast<std::int64_t>(steps);
    if (static_cast<double>(whole) != steps) throw internal_error("a sum of rays is no multiple of its step");
    return static_cast<std::uint64_t>(whole);
}

double value_of(std::uint64_t steps, double step) {
    return static_cast<double>(static_cast<std::int64_t>(steps)) * step;
}

/// Values byte by byte: first the lowest byte of all, then the next, because these resemble each other. Bytes
/// that are all zero take a single mark.
class PlaneWriter {
  public:
    template <class T>
    void value(const T& v) {
        bytes_.append(reinterpret_cast<const char*>(&v), sizeof v);
    }
    template <class T>
    void planes(const std::vector<T>& values) {
        value(static_cast<std::uint32_t>(values.size()));
        for (std::size_t plane = 0; plane < sizeof(T); ++plane) {
            std::string bytes;
            bytes.reserve(values.size());
            bool empty = true;
            for (const T& v : values) {
                std::array<char, sizeof(T)> parts;
                std::memcpy(parts.data(), &v, sizeof v);
                bytes += parts[plane];
                empty = empty && parts[plane] == 0;
            }
            bytes_ += empty ? '\0' : '\1';
            if (!empty) bytes_ += bytes;
        }
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

class PlaneReader {
  public:
    PlaneReader(std::string_view bytes, const std::string& where) : bytes_(bytes), where_(where) {}

    template <class T>
    T value() {
        T v;
        std::memcpy(&v, take(sizeof v).data(), sizeof v);
        return v;
    }
    template <class T>
    std::vector<T> planes() {
        const auto count = value<std::uint32_t>();
        if (count > std::size_t{1} << 28) throw file_error("a count is out of range", where_);
        std::vector<std::array<char, sizeof(T)>> parts(count, std::array<char, sizeof(T)>{});
        for (std::size_t plane = 0; plane < sizeof(T); ++plane) {
            if (take(1)[0] == '\0') continue;
            const std::string_view bytes = take(count);
            for (std::size_t i = 0; i < count; ++i) parts[i][plane] = bytes[i];
        }
        std::vector<T> values(count);
        for (std::size_t i = 0; i < count; ++i) std::memcpy(&values[i], parts[i].data(), sizeof(T));
        return values;
    }

  private:
    std::string_view take(std::size_t size) {
        if (size > bytes_.size()) throw file_error("ends too early", where_);
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }
    std::string_view bytes_;
    const std::string& where_;
};

std::vector<std::uint64_t> integers(const std::vector<HitObserver::Sums>& extras) {
    std::vector<std::uint64_t> values;
    for (std::size_t c = 0; c < kCauses; ++c) {
        for (const auto& sums : extras) values.push_back(steps_of(sums.by_cause[c], kOcclusionStep));
    }
    for (const auto& sums : extras) values.push_back(steps_of(sums.one_layer, kOcclusionStep));
    return values;
}

std::vector<std::uint64_t> integers(const std::vector<OpenSums>& all) {
    std::vector<std::uint64_t> values;
    for (std::size_t b = 0; b < kBlocks; ++b) {
        for (const OpenSums& sums : all) values.push_back(steps_of(sums.open[b], kOcclusionStep));
        for (int axis = 0; axis < 3; ++axis) {
            for (const OpenSums& sums : all)
                values.push_back(steps_of(sums.direction[b][axis], OpenSums::kDirectionStep));
        }
    }
    return values;
}

std::vector<OpenSums> open_sums_of(const std::vector<std::uint64_t>& values) {
    constexpr std::size_t kRows = 4;  // rows of a block
    std::vector<OpenSums> all(values.size() / (kRows * kBlocks));
    auto next = values.begin();
    for (std::size_t b = 0; b < kBlocks; ++b) {
        for (OpenSums& sums : all) sums.open[b] = value_of(*next++, kOcclusionStep);
        for (int axis = 0; axis < 3; ++axis) {
            for (OpenSums& sums : all) sums.direction[b][axis] = value_of(*next++, OpenSums::kDirectionStep);
        }
    }
    return all;
}

std::vector<HitObserver::Sums> extras_of(const std::vector<std::uint64_t>& values) {
    std::vector<HitObserver::Sums> extras(values.size() / (kCauses + 1));
    const std::size_t count = extras.size();
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < kCauses; ++c)
            extras[i].by_cause[c] = value_of(values[c * count + i], kOcclusionStep);
        extras[i].one_layer = value_of(values[kCauses * count + i], kOcclusionStep);
    }
    return extras;
}

std::string compressed(const std::string& bytes) {
    uLongf size = compressBound(bytes.size());
    std::string result(sizeof(std::uint64_t) + size, '\0');
    const std::uint64_t raw = bytes.size();
    std::memcpy(result.data(), &raw, sizeof raw);
    if (compress2(reinterpret_cast<Bytef*>(result.data() + sizeof raw), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), kCompression) != Z_OK) {
        throw internal_error("zlib does not compress", "truth cache");
    }
    result.resize(sizeof raw + size);
    return result;
}

std::string uncompressed(std::string_view bytes, const std::string& where) {
    std::uint64_t raw = 0;
    if (bytes.size() < sizeof raw) throw file_error("ends too early", where);
    std::memcpy(&raw, bytes.data(), sizeof raw);
    if (raw > std::uint64_t{1} << 32) throw file_error("a size is out of range", where);
    std::string result(raw, '\0');
    uLongf size = raw;
    if (uncompress(reinterpret_cast<Bytef*>(result.data()), &size,
                   reinterpret_cast<const Bytef*>(bytes.data() + sizeof raw),
                   bytes.size() - sizeof raw) != Z_OK ||
        size != raw) {
        throw file_error("is not what was compressed", where);
    }
    return result;
}

}  // namespace

std::string encode(const GroupState& state) {
    PlaneWriter out;
    out.value(static_cast<std::uint32_t>(state.tiles.size()));
    out.value(state.seconds);
    for (const TileState& tile : state.tiles) {
        out.planes(tile.places);
        out.planes(tile.depths_m);
        std::vector<float> normals;
        for (int axis = 0; axis < 3; ++axis) {
            for (const glm::vec3& normal : tile.normals) normals.push_back(normal[axis]);
        }
        out.planes(normals);
        out.planes(tile.samples);
        std::vector<std::uint64_t> sums;
        sums.reserve(tile.sums.size());
        for (const double sum : tile.sums) sums.push_back(steps_of(sum, kOcclusionStep));
        out.planes(sums);
        out.planes(integers(tile.extras));
        out.planes(integers(tile.open_sums));
    }
    return compressed(out.bytes());
}

GroupState decode(std::string_view bytes, const std::string& where) {
    const std::string raw = uncompressed(bytes, where);
    PlaneReader in(raw, where);
    GroupState state;
    const auto tiles = in.value<std::uint32_t>();
    state.seconds = in.value<double>();
    for (std::uint32_t t = 0; t < tiles; ++t) {
        TileState& tile = state.tiles.emplace_back();
        tile.places = in.planes<std::uint16_t>();
        const std::size_t surfaces = tile.surfaces();
        tile.depths_m = in.planes<float>();
        const std::vector<float> normals = in.planes<float>();
        tile.samples = in.planes<std::uint32_t>();
        if (tile.depths_m.size() != surfaces || normals.size() != 3 * surfaces ||
            tile.samples.size() != surfaces) {
            throw file_error("counts differ", where);
        }
        for (std::size_t s = 0; s < surfaces; ++s)
            tile.normals.emplace_back(normals[s], normals[surfaces + s], normals[2 * surfaces + s]);
        for (const std::uint64_t sum : in.planes<std::uint64_t>())
            tile.sums.push_back(value_of(sum, kOcclusionStep));
        tile.extras = extras_of(in.planes<std::uint64_t>());
        tile.open_sums = open_sums_of(in.planes<std::uint64_t>());
    }
    return state;
}

}  // namespace aoscore
