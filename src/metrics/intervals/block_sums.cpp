#include "metrics/intervals/block_sums.h"

#include <limits>
#include <utility>

namespace aoscore {

DrawnSums& DrawnSums::operator+=(const DrawnSums& other) {
    for (double DrawnSums::*const sum :
         {&DrawnSums::count, &DrawnSums::squared, &DrawnSums::absolute, &DrawnSums::difference,
          &DrawnSums::variance, &DrawnSums::missing, &DrawnSums::false_occlusion, &DrawnSums::ssim,
          &DrawnSums::ssim_weight, &DrawnSums::flip})
        this->*sum += other.*sum;
    return *this;
}

std::vector<DrawnSums> sums_of_blocks(const BlockErrors& image) {
    constexpr double kNotThere = std::numeric_limits<double>::quiet_NaN();
    DrawnSums empty;
    empty.ms_ssim = kNotThere;
    std::vector<DrawnSums> blocks(image.counts.size(), empty);
    const std::pair<double DrawnSums::*, const std::vector<double>*> sums[] = {
        {&DrawnSums::count, &image.counts},
        {&DrawnSums::squared, &image.squared_sums},
        {&DrawnSums::absolute, &image.absolute_sums},
        {&DrawnSums::difference, &image.signed_sums},
        {&DrawnSums::variance, &image.variance_sums},
        {&DrawnSums::missing, &image.missing_counts},
        {&DrawnSums::false_occlusion, &image.false_counts},
        {&DrawnSums::ssim, &image.maps.ssim_sums},
        {&DrawnSums::ssim_weight, &image.maps.ssim_weights},
        {&DrawnSums::flip, &image.maps.flip_sums}};
    for (const auto& [sum, values] : sums) {
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            blocks[b].*sum = values->size() == blocks.size() ? (*values)[b] : kNotThere;
        }
    }
    return blocks;
}

}  // namespace aoscore
