#include "jobs/draw_image.h"

#include "jobs/masked_mean.h"

namespace aoscore {

MethodOutput draw_image(ScreenRenderer& renderer, const MethodRequest& request) {
    return renderer.run(request);
}

double fetches_per_pixel(ScreenRenderer& renderer, const MethodRequest& request, const Mask& valid) {
    return mean_over(renderer.count_fetches(request), valid);
}

}  // namespace aoscore
