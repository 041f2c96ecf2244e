#include "screen/method/method_data.h"

#include "screen/method/kernel.h"
#include "screen/passes/pass_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

/// A method's data suffice to run it elsewhere: complete settings, shaders, kernels.
namespace aoscore {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::uint64_t kSeed = 7;

std::vector<MethodDescriptor> methods_and_filters() {
    std::vector<MethodDescriptor> all = load_methods();
    for (MethodDescriptor& filter : load_filters()) all.push_back(std::move(filter));
    return all;
}

TEST(MethodData, HasEveryParameterAndCompletePresets) {
    for (const MethodDescriptor& method : methods_and_filters()) {
        const json data = method_data(method, kSeed);
        const auto of_visibility = std::ranges::count(method.parameters, "", &Parameter::signal);
        ASSERT_EQ(data["parameters"].size(), of_visibility) << method.id;
        for (const auto& [preset, values] : data["presets"].items()) {
            for (const Parameter& p : method.parameters)
                EXPECT_TRUE(!p.signal.empty() || p.accepts(parameter_value(values.at(p.id), p.id)))
                    << method.id << " " << preset << " " << p.id;
        }
        EXPECT_EQ(data["presets"]["default"], json(visibility_values(method, method.values("default"))))
            << method.id;
    }
}

TEST(MethodData, HasAShaderForEveryPassUnlessAProcessorComputesIt) {
    for (const MethodDescriptor& method : methods_and_filters()) {
        const json data = method_data(method, kSeed);
        if (data.contains("processor")) {
            EXPECT_EQ(data["processor"], method.passes[0].processor) << method.id;
            continue;
        }
        ASSERT_EQ(data["passes"].size(), method.passes.size()) << method.id;
        for (const json& pass : data["passes"]) {
            const std::string text = data["sources"].at(pass["source"].get<std::size_t>());
            EXPECT_TRUE(text.starts_with("#version 330 core\n")) << method.id;
            EXPECT_THAT(text, HasSubstr("void main()")) << method.id;
            EXPECT_THAT(text, Not(HasSubstr("#include"))) << method.id;
            for (const auto& [macro, unused] : pass_macros({}))
                EXPECT_THAT(text, Not(HasSubstr("#define " + macro))) << method.id;
        }
    }
}

double scale_of(const std::string& scale, std::size_t i, std::size_t size) {
    if (scale == "none") return 1;
    const double t = static_cast<double>(i) / (scale == "squared_of_64" ? 64.0 : static_cast<double>(size));
    return std::lerp(0.1, 1.0, t * t);
}

Kernel with_choices(Kernel kernel, const json& chosen) {
    for (std::string* member : {&kernel.directions, &kernel.radii, &kernel.sequence}) {
        if (member->starts_with('@')) *member = chosen.at(member->substr(1)).get<std::string>();
    }
    return kernel;
}

// The kernel that a reader takes from the table for a smaller size is the one that the program compiles in.
TEST(MethodData, KernelTablesHoldThePointsOfEverySize) {
    std::size_t kernels = 0;
    for (const MethodDescriptor& method : methods_and_filters()) {
        const json data = method_data(method, kSeed);
        for (const Kernel& kernel : method.kernels) {
            ++kernels;
            const json& described = *std::find_if(data["kernels"].begin(), data["kernels"].end(),
                                                  [&](const json& k) { return k["id"] == kernel.id; });
            for (const json& table : described["tables"]) {
                Kernel asked = with_choices(kernel, table["when"]);
                if (asked.scale.starts_with('@')) asked.scale = "squared";
                for (const std::size_t size :
                     {std::size_t{1}, std::size_t{5}, described["largest"].get<std::size_t>()}) {
                    asked.size = std::to_string(size);
                    const auto points = generate_kernel(asked, kSeed);
                    for (std::size_t i = 0; i < size; ++i) {
                        for (int axis = 0; axis < 3; ++axis) {
                            const auto component = table["points"][3 * i + static_cast<std::size_t>(axis)];
                            EXPECT_NEAR(component.get<double>() * scale_of(asked.scale, i, size),
                                        static_cast<double>(points[i][axis]), 1e-7)
                                << method.id << " " << kernel.id << " " << i;
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(kernels, 0U);
}

TEST(MethodData, KernelsThatDependOnAChoiceHaveATableForEach) {
    MethodDescriptor method;
    method.id = "by-choice";
    method.folder = ".";
    Parameter spread;
    spread.id = "spread";
    spread.type = Parameter::Type::choice;
    spread.choices = {"disc", "sphere"};
    spread.default_value = "disc";
    method.parameters = {spread};
    method.presets["default"] = {};
    method.kernels = {{.id = "points", .size = "4", .directions = "@spread"}};
    const json kernel = method_data(method, kSeed)["kernels"][0];
    ASSERT_EQ(kernel["tables"].size(), 2U);
    for (const json& table : kernel["tables"]) {
        Kernel asked{.id = "points", .size = "4", .directions = table["when"]["spread"]};
        EXPECT_FLOAT_EQ(table["points"][2].get<float>(), generate_kernel(asked, kSeed)[0].z);
    }
}

TEST(MethodData, TheContractHasTheNoiseOfTheSeed) {
    const json data = contract_data(kSeed);
    const auto noise = generate_noise_4x4(kSeed);
    ASSERT_EQ(data["noise_4x4"].size(), 64U);
    for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_EQ(data["noise_4x4"][i].get<float>(), noise.pixels[i / 4][static_cast<glm::length_t>(i % 4)]);
    }
    EXPECT_NE(data["noise_4x4"], contract_data(kSeed + 1)["noise_4x4"]);
}

}  // namespace
}  // namespace aoscore
