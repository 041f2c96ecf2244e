#include "screen/method/preset_tuning.h"

#include "core/error.h"

#include <utility>

namespace aoscore {
namespace {

constexpr double kLargestLoss = 1e6;
constexpr int kMostViews = 1 << 20;

/// What was measured on views that were left out.
void parse_held_out(StrictObject object, PresetTuning& tuning) {
    tuning.left_out = object.text("left_out");
    if (tuning.left_out != "scene" && tuning.left_out != "view")
        throw file_error("is \"" + tuning.left_out + "\"", object.where("left_out"), "scene, view");
    tuning.held_out = object.number("loss", 0, kLargestLoss);
    tuning.change = object.number("less_published", -kLargestLoss, kLargestLoss);
    const std::vector<double> interval = object.numbers("less_published_95", 2);
    tuning.low = interval[0];
    tuning.high = interval[1];
    object.finish();
}

}  // namespace

nlohmann::json tuning_json(const PresetTuning& tuning) {
    nlohmann::json object = {{"from", tuning.from},           {"metric", tuning.metric},
                             {"views", tuning.views},         {"scenes", tuning.scenes},
                             {"published", tuning.published}, {"fitted", tuning.fitted}};
    if (!tuning.definition.empty()) object["definition"] = tuning.definition;
    if (tuning.held_out) {
        object["held_out"] = {{"left_out", tuning.left_out},
                              {"loss", *tuning.held_out},
                              {"less_published", *tuning.change},
                              {"less_published_95", {*tuning.low, *tuning.high}}};
    }
    return object;
}

PresetTuning parse_tuning(StrictObject object) {
    PresetTuning tuning;
    tuning.from = object.text("from");
    tuning.definition = object.text_or("definition", "");
    tuning.metric = object.text("metric");
    tuning.views = object.integer("views", 1, kMostViews);
    tuning.scenes = object.integer("scenes", 1, kMostViews);
    tuning.published = object.number("published", 0, kLargestLoss);
    tuning.fitted = object.number("fitted", 0, kLargestLoss);
    if (object.has("held_out")) parse_held_out(object.object("held_out"), tuning);
    object.finish();
    return tuning;
}

}  // namespace aoscore
