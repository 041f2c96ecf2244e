// Tests the meaning of channels by the names that other programs give them.
#include "image/channel_meaning.h"

#include <gtest/gtest.h>

namespace aoscore {
namespace {

void expect_all(ChannelMeaning meaning, std::initializer_list<const char*> names) {
    for (const char* name : names)
        EXPECT_EQ(static_cast<int>(meaning_of(ChannelName(name))), static_cast<int>(meaning)) << name;
}

TEST(ChannelMeaning, AmbientOcclusionIsKnownInAnyCaseAndPart) {
    expect_all(ChannelMeaning::occlusion, {"AO",
                                           "ao",
                                           "AO.R",
                                           "Ao.Y",
                                           "ViewLayer.AO.R",
                                           "View Layer.AO.V",
                                           "RenderLayer.AO.R",
                                           "AmbientOcclusion.R",
                                           "Ambient Occlusion.R",
                                           "ambient_occlusion",
                                           "AMBIENTOCCLUSION",
                                           "ambientocclusion.r",
                                           "FinalImageAmbientOcclusion.R",
                                           "mr Ambient Occlusion.R",
                                           "VRayExtraTex_AO.R",
                                           "PPI_AO.red",
                                           "SSAO",
                                           "ssao.R",
                                           "GTAO.X",
                                           "HBAO",
                                           "HBAO+.R",
                                           "XeGTAO.R",
                                           "RTAO.R",
                                           "CACAO",
                                           "n8ao",
                                           "occlusion",
                                           "Occlusion.R",
                                           "rt_occlusion",
                                           "AO_filtered.R",
                                           "AOPass.R",
                                           "AO2.R",
                                           "debug_ao",
                                           "AO.Combined.R",
                                           "beauty.AO.R",
                                           "AO.R.R"});
}

TEST(ChannelMeaning, OtherOcclusionIsNotAmbient) {
    for (const char* name : {"SpecularOcclusion.R", "Reflection Occlusion", "AO.A", "AO.Variance.R",
                             "ao_normal", "BentNormalAO.R", "AO.Depth.Z"}) {
        EXPECT_NE(static_cast<int>(meaning_of(ChannelName(name))),
                  static_cast<int>(ChannelMeaning::occlusion))
            << name;
    }
}

TEST(ChannelMeaning, WordsThatOnlyHoldTheLettersMeanNothing) {
    expect_all(ChannelMeaning::unknown,
               {"chaos.R", "Mayo", "R", "Y", "rgba.R", "V0.Y", "hemisphere.Y", "mine"});
}

TEST(ChannelMeaning, GeometryAndLightAreNeitherUnknownNorOcclusion) {
    expect_all(ChannelMeaning::geometry, {"Z",
                                          "A",
                                          "u",
                                          "v",
                                          "depth",
                                          "ViewLayer.Depth.Z",
                                          "Depth.V",
                                          "SceneDepth.R",
                                          "N.X",
                                          "Ns.Z",
                                          "P.Y",
                                          "Normal.X",
                                          "WorldNormal.R",
                                          "Albedo.R",
                                          "albedo.B",
                                          "mask.Y",
                                          "SE.Y",
                                          "Variance.R",
                                          "IndexOB.X",
                                          "CryptoObject00.r",
                                          "cause.hidden.Y",
                                          "bent.X",
                                          "cone.Y",
                                          "Mist.Z",
                                          "velocity.X"});
    expect_all(ChannelMeaning::shading, {"ViewLayer.Combined.R", "beauty.R", "Diffuse.R", "DiffDir.R",
                                         "Shadow.R", "Emission.G", "SpecularColor.B", "clay.R"});
}

}  // namespace
}  // namespace aoscore
