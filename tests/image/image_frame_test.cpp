#include "image/image_frame.h"

#include <gtest/gtest.h>

#include <cmath>

namespace aoscore {
namespace {

ImageF numbered(int width, int height) {
    ImageF image(width, height);
    for (std::size_t i = 0; i < image.size(); ++i) image.pixels[i] = static_cast<float>(i);
    return image;
}

// The tag's meaning (TIFF 6.0, page 36): the places in the shown picture of the stored row 0 and column 0.
TEST(Orientation, PutsTheFirstRowAndColumnWhereTheTagSays) {
    enum Side { kTop, kBottom, kLeft, kRight };
    struct Meaning {
        int tag;
        Side row0, column0;
    };
    const Meaning meanings[] = {{1, kTop, kLeft},     {2, kTop, kRight},  {3, kBottom, kRight},
                                {4, kBottom, kLeft},  {5, kLeft, kTop},   {6, kRight, kTop},
                                {7, kRight, kBottom}, {8, kLeft, kBottom}};
    const ImageF stored = numbered(3, 2);
    for (const Meaning& meaning : meanings) {
        const ImageF image = shown(stored, Orientation::of_tag(meaning.tag));
        const bool across = meaning.row0 == kLeft || meaning.row0 == kRight;
        ASSERT_EQ(image.width, across ? 2 : 3) << meaning.tag;
        ASSERT_EQ(image.height, across ? 3 : 2) << meaning.tag;
        for (int row = 0; row < 2; ++row) {
            for (int column = 0; column < 3; ++column) {
                int x = 0, y = 0;
                const auto put = [&](Side zero, int index) {
                    if (zero == kTop) y = index;
                    if (zero == kBottom) y = image.height - 1 - index;
                    if (zero == kLeft) x = index;
                    if (zero == kRight) x = image.width - 1 - index;
                };
                put(meaning.row0, row);
                put(meaning.column0, column);
                EXPECT_EQ(image.at(x, y), stored.at(column, row)) << meaning.tag;
            }
        }
        // A rectangle of one pixel goes where that pixel goes.
        const PixelRect rect = shown({2, 0, 1, 1}, 3, 2, Orientation::of_tag(meaning.tag));
        EXPECT_EQ(image.at(rect.x, rect.y), stored.at(2, 0)) << meaning.tag;
    }
    for (const int nonsense : {-1, 0, 9, 1000}) EXPECT_TRUE(Orientation::of_tag(nonsense).upright());
}

TEST(Frame, KeepsWhatLiesWithinItAndHasNoNumberElsewhere) {
    const ImageF picture = numbered(4, 3), frame = placed(picture, -1, 1, 5, 3);
    EXPECT_EQ(within_frame({-1, 1, 4, 3}, 5, 3), (PixelRect{0, 1, 3, 2}));
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            if (y >= 1 && x < 3)
                EXPECT_EQ(frame.at(x, y), picture.at(x + 1, y - 1));
            else
                EXPECT_TRUE(std::isnan(frame.at(x, y))) << x << " " << y;
        }
    }
    EXPECT_TRUE(within_frame({7, 0, 2, 2}, 5, 3).empty());
}

}  // namespace
}  // namespace aoscore
