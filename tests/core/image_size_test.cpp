#include "core/image_size.h"

#include "core/error.h"
#include "core/image.h"
#include "core/strict_json.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

using nlohmann::json;

ImageSize read(const json& sides) {
    const json file = {{"size", sides}};
    StrictObject object = StrictObject::of_file(file, "views.json");
    return read_image_size(object);
}

TEST(ImageSize, IsReadFromTextAndFromJsonAlike) {
    EXPECT_EQ(parse_image_size("1920x1080", "--size"), (ImageSize{1920, 1080}));
    EXPECT_EQ(read({1920, 1080}), (ImageSize{1920, 1080}));
    EXPECT_EQ(parse_image_size("1x16384", "--size"), (ImageSize{1, kLargestImageSide_px}));
}

TEST(ImageSize, IsNoFractionNothingNegativeAndNothingEndless) {
    for (const char* text : {"", "64", "64x", "x64", "0x64", "64x-3", "64x64x", "64.5x64", "64X64", " 64x64",
                             "16385x1", "99999999999x1"}) {
        try {
            parse_image_size(text, "--size");
            ADD_FAILURE() << text;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::usage);
            EXPECT_EQ(e.where(), "--size");
        }
    }
    for (const json& sides : {json{12.7, 64}, json{64, -3}, json{1e12, 64}, json{0, 64}, json{64},
                              json{64, "64"}, json{64, 64, 64}, json{64, nullptr}}) {
        try {
            read(sides);
            ADD_FAILURE() << sides;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit_code(), ExitCode::file_error);
            EXPECT_EQ(e.where(), "views.json: size");
        }
    }
}

}  // namespace
}  // namespace aoscore
