#pragma once

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <string>

namespace aoscore {
/// Names the scene in a failure.
inline void PrintTo(const BuiltinScene& scene, std::ostream* out) {
    *out << scene.id;
}
}  // namespace aoscore

namespace aoscore::testing {

/// A test of every row of builtin_scenes(), named after the scene.
class EveryBuiltin : public ::testing::TestWithParam<BuiltinScene> {};

inline std::string builtin_name(const ::testing::TestParamInfo<BuiltinScene>& info) {
    return std::string(info.param.id);
}

}  // namespace aoscore::testing

#define AOSCORE_FOR_EVERY_BUILTIN(suite)                                            \
    INSTANTIATE_TEST_SUITE_P(Builtin, suite, ::testing::ValuesIn(builtin_scenes()), \
                             aoscore::testing::builtin_name)
