#include "metrics/analysis/distance.h"

#include <cmath>
#include <limits>
#include <vector>

namespace aoscore {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// values[q] becomes the least of (q - p)^2 + values[p] over all p: the lower envelope of parabolas.
void lower_envelope(std::vector<double>& values) {
    const int count = static_cast<int>(values.size());
    std::vector<int> vertices;
    std::vector<double> starts;  // the places where each vertex' parabola becomes the lowest
    const auto at = [&](int q) { return values[static_cast<std::size_t>(q)]; };
    for (int q = 0; q < count; ++q) {
        if (at(q) == kFar) continue;
        double start = -kFar;
        while (!vertices.empty()) {
            const int p = vertices.back();
            start = ((at(q) + double{1} * q * q) - (at(p) + double{1} * p * p)) / (2.0 * (q - p));
            if (start > starts.back()) break;
            vertices.pop_back();
            starts.pop_back();
            start = -kFar;
        }
        vertices.push_back(q);
        starts.push_back(start);
    }
    if (vertices.empty()) return;
    std::vector<double> result(values.size());
    std::size_t k = 0;
    for (int q = 0; q < count; ++q) {
        while (k + 1 < vertices.size() && starts[k + 1] < q) ++k;
        const double offset = q - vertices[k];
        result[static_cast<std::size_t>(q)] = offset * offset + at(vertices[k]);
    }
    values = std::move(result);
}

}  // namespace

ImageF distance_to(const Mask& marked) {
    Image<double> squared(marked.width, marked.height, kFar);
    for (std::size_t i = 0; i < marked.size(); ++i) {
        if (marked.pixels[i] != 0) squared.pixels[i] = 0;
    }
    std::vector<double> line(static_cast<std::size_t>(marked.height));
    for (int x = 0; x < marked.width; ++x) {
        for (int y = 0; y < marked.height; ++y) line[static_cast<std::size_t>(y)] = squared.at(x, y);
        lower_envelope(line);
        for (int y = 0; y < marked.height; ++y) squared.at(x, y) = line[static_cast<std::size_t>(y)];
    }
    line.resize(static_cast<std::size_t>(marked.width));
    ImageF distance(marked.width, marked.height);
    for (int y = 0; y < marked.height; ++y) {
        for (int x = 0; x < marked.width; ++x) line[static_cast<std::size_t>(x)] = squared.at(x, y);
        lower_envelope(line);
        for (int x = 0; x < marked.width; ++x)
            distance.at(x, y) = static_cast<float>(std::sqrt(line[static_cast<std::size_t>(x)]));
    }
    return distance;
}

}  // namespace aoscore
