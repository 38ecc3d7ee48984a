#include "io/run_files/report.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "mesher/base/error.hpp"

namespace pcvt {
namespace {

using Json = nlohmann::ordered_json;

Report example_report() {
    return {"0.1.0",
            1000,
            plane::Lattice({1, 0}, {0.37, 0.81}),
            ~std::uint64_t{0},
            "lbfgs",
            "random",
            "converged",
            294,
            301,
            7,
            450,
            0.1 + 0.2,
            1e-7 / 3,
            1e-320,
            "yes",
            900,
            {{5, 50}, {6, 900}, {7, 50}},
            1'000'000,
            1,
            {0, 1.5, 2, 3.5},
            {"a \"b\".obj", "\xC3\xBC.txt"}};
}

TEST(Report, KeysFollowTheContractInItsOrder) {
    std::vector<std::string> keys;
    const Json json = Json::parse(encode_report(example_report()));
    for (const auto& [key, value] : json.items()) {
        keys.push_back(key);
    }
    EXPECT_THAT(
        keys, ::testing::ElementsAre("version", "sites", "lattice", "seed", "solver", "start",
                                     "stop", "iterations", "evaluations", "hessians", "cg_products",
                                     "energy", "energy_bound", "residual", "minimum", "hexagons",
                                     "valences", "mirrors", "threads", "seconds", "files"));
}

TEST(Report, ValuesReadBackExactly) {
    const Json json = Json::parse(encode_report(example_report()));
    EXPECT_EQ(json["seed"].get<std::uint64_t>(), ~std::uint64_t{0});
    EXPECT_EQ(json["energy"].get<double>(), 0.1 + 0.2);
    EXPECT_EQ(json["energy_bound"].get<double>(), 1e-7 / 3);
    EXPECT_EQ(json["residual"].get<double>(), 1e-320);
    EXPECT_EQ(json["lattice"].dump(), "[[1,0],[0.37,0.81]]");
    EXPECT_EQ(json["valences"].dump(), "{\"5\":50,\"6\":900,\"7\":50}");
    EXPECT_EQ(json["mirrors"].dump(), "1000000");
    EXPECT_EQ(json["cg_products"].dump(), "450");
    EXPECT_EQ(json["minimum"].get<std::string>(), "yes");
    EXPECT_EQ(json["seconds"]["total"].get<double>(), 3.5);
    EXPECT_EQ(json["files"][0].get<std::string>(), "a \"b\".obj");
    EXPECT_EQ(json["files"][1].get<std::string>(), "\xC3\xBC.txt");
}

TEST(Report, UnknownValuesAreNull) {
    Report report = example_report();
    report.energy_bound.reset();
    report.mirrors.reset();
    report.minimum.reset();
    report.valences.clear();
    report.files = {"not UTF-8: \xFF"};
    const Json json = Json::parse(encode_report(report));
    EXPECT_TRUE(json["energy_bound"].is_null());
    EXPECT_TRUE(json["mirrors"].is_null());
    EXPECT_TRUE(json["minimum"].is_null());
    EXPECT_EQ(json["valences"], Json::object());
}

TEST(Report, APatternIsTheLastKey) {
    Report report = example_report();
    report.pattern =
        Report::Pattern{plane::Lattice({0.5, 0.5}, {-0.5, 0.5}), {2, 1, 1}, 0.25, "no", {}};
    const Json json = Json::parse(encode_report(report));
    EXPECT_EQ(json.back().dump(),
              "{\"basis\":[[0.5,0.5],[-0.5,0.5]],\"hermite\":[2,1,1],\"energy\":0.25,"
              "\"minimum\":\"no\",\"smallest_eigenvalue\":null}");
}

TEST(Report, OnlyRunsWithADensityHaveItsKeys) {
    Report report = example_report();
    EXPECT_FALSE(Json::parse(encode_report(report)).contains("density"));
    report.density = Report::Density{.name = "1 + \"u\"",
                                     .least = 0.01,
                                     .greatest = 1,
                                     .evaluations_per_site = 54.25,
                                     .mass = 0.3,
                                     .mass_deviation = -1e-12,
                                     .expected_energy = 2e-7,
                                     .spacing_deviation = 0.0125,
                                     .quadrature_error = 1e-9,
                                     .rough_cells = 3};
    const Json json = Json::parse(encode_report(report));
    EXPECT_EQ(json["density"].get<std::string>(), "1 + \"u\"");
    EXPECT_EQ(json["density_evaluations"].get<double>(), 54.25);
    EXPECT_EQ(json["mass_deviation"].get<double>(), -1e-12);
    EXPECT_EQ(json["rough_cells"].get<int>(), 3);
    EXPECT_EQ(json.size(), 31u);
}

TEST(Report, NonFiniteNumbersAreInternalErrors) {
    Report report = example_report();
    report.energy = std::nan("");
    EXPECT_THROW(encode_report(report), InternalError);
}

}  // namespace
}  // namespace pcvt
