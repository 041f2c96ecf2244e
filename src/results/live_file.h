#pragma once

namespace aoscore {

/// The file beside results.json with shaders and cameras, by which the page runs methods on the stored
/// G-buffer.
///   methods_dir: the folder of the user's own methods as the run was told it; empty where it was not;
///   contract: what all methods share; methods, filters: each as data (screen/method_data.h);
///   views: by key {width, height, pixel_size, near_m, far_m, orthographic}, the uniforms of
///   shaders/contract/view.glsl, and `surfaces`, whether its G-buffer's file has the surfaces behind one
///   another.
inline constexpr const char* kLiveFile = "live.json";

}  // namespace aoscore
