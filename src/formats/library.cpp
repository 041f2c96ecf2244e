// The one function that the library shows: image/image_formats.h says who calls it.
#include "formats/readers.h"
#include "image/image_formats.h"

extern "C" __attribute__((visibility("default"))) const aoscore::ImageFormats* aoscore_image_formats() {
    static constexpr aoscore::ImageFormats kFormats{aoscore::read_picture, aoscore::decode_picture};
    return &kFormats;
}
