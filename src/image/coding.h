#pragma once

namespace aoscore {

/// The coding of integers that stand for visibility.
enum class Coding { linear, srgb };

}  // namespace aoscore
