#include "io/voxels/damask_material.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "io/bytes/bad_file.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kDegree = std::numbers::pi / 180;

/// The rotation that takes the axes of the sample to those of the crystal: turns about z, the new
/// x, the new z.
Eigen::Matrix3d turned_axes(const BungeAngles& angles) {
    const auto turn = [](double degrees, const Eigen::Vector3d& axis) {
        return Eigen::AngleAxisd(degrees * kDegree, axis);
    };
    return (turn(angles.phi1, Eigen::Vector3d::UnitZ()) *
            turn(angles.Phi, Eigen::Vector3d::UnitX()) *
            turn(angles.phi2, Eigen::Vector3d::UnitZ()))
        .toRotationMatrix();
}

TEST(DamaskMaterial, Law1TheQuaternionTurnsTheAxesAsBungesAngles) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-400, 400);
    for (int k = 0; k < 1000; ++k) {
        const BungeAngles angles{uniform(random), uniform(random), uniform(random)};
        const Quaternion q = damask_quaternion(angles);
        const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
        EXPECT_NEAR(turn.norm(), 1, 1e-15);
        EXPECT_GE(q[0], 0);
        EXPECT_LT((turn.toRotationMatrix() - turned_axes(angles)).cwiseAbs().maxCoeff(), 1e-13);
    }
}

/// Values of DAMASK: damask.Rotation.from_Euler_angles([phi1, Phi, phi2], degrees=True).
TEST(DamaskMaterial, KnownOrientations) {
    const double root = std::sqrt(0.5);
    for (const auto& [angles, wanted] :
         {std::pair{BungeAngles{0, 0, 0}, Quaternion{1, 0, 0, 0}},
          std::pair{BungeAngles{90, 0, 0}, Quaternion{root, 0, 0, root}},
          std::pair{BungeAngles{0, 90, 0}, Quaternion{root, root, 0, 0}},
          std::pair{BungeAngles{90, 90, 0}, Quaternion{0.5, 0.5, 0.5, 0.5}},
          std::pair{BungeAngles{270, 0, 0}, Quaternion{root, 0, 0, -root}}}) {
        const Quaternion q = damask_quaternion(angles);
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(q[k], wanted[k], 1e-15) << angles.phi1 << " " << k;
    }
}

CellMaterials two_phases() {
    return {.phase_names = {"ferrite", "martensite"},
            .site_phase = {0, 1, 1},
            .site_orientation = {{10, 20, 30}, {0, 0, 0}, {350, 90, 1e-14}}};
}

TEST(DamaskMaterial, IsReadBack) {
    for (const CellMaterials& materials : {CellMaterials{}, two_phases()}) {
        const std::string text = encode_damask_material(3, materials);
        const auto entries = decode_damask_material("m.yaml", text);
        EXPECT_NO_THROW(compare_damask_material("m.yaml", entries, 3, materials));
        EXPECT_EQ(entries[1].phase, materials.empty() ? "default" : "martensite");
    }
}

TEST(DamaskMaterial, PhasesHaveTheConstantsThatTheUserChooses) {
    const std::string text = encode_damask_material(
        3, two_phases(),
        parse_elastic_choices("ferrite:2e11,0.25 martensite:162e9,92e9,69e9,181e9,47e9"));
    // lambda and mu are 8e10.
    EXPECT_THAT(text,
                HasSubstr("  ferrite:\n    lattice: cF\n    mechanical:\n      output: [F, P]\n"
                          "      elastic: {type: Hooke, C_11: 2.4e+11, C_12: 8.0e+10, "
                          "C_44: 8.0e+10}\n"));
    EXPECT_THAT(text, HasSubstr("  martensite:\n    lattice: hP\n    c/a: 1.633\n"));
    EXPECT_THAT(text, HasSubstr("C_11: 1.62e+11, C_12: 9.2e+10, C_13: 6.9e+10, C_33: 1.81e+11, "
                                "C_44: 4.7e+10}\n"));
    EXPECT_THAT(text, Not(HasSubstr("aluminium")));
    EXPECT_NO_THROW(
        compare_damask_material("m", decode_damask_material("m", text), 3, two_phases()));
    // Cells without phases.
    EXPECT_THAT(encode_damask_material(3, {}, parse_elastic_choices("grains:231,135,116")),
                HasSubstr("  default:\n    lattice: cF\n    mechanical:\n      output: [F, P]\n"
                          "      elastic: {type: Hooke, C_11: 231.0, C_12: 135.0, C_44: 116.0}\n"));
}

TEST(DamaskMaterial, ATableOfMaterialsThatDiffersIsFound) {
    const auto entries = decode_damask_material("m", encode_damask_material(3, two_phases()));
    const auto refusal = [&](int n_cells, const CellMaterials& materials) -> std::string {
        try {
            compare_damask_material("m.yaml", entries, n_cells, materials);
        } catch (const BadFile& fault) {
            return fault.what();
        }
        return "";
    };
    EXPECT_THAT(refusal(4, two_phases()),
                HasSubstr("m.yaml: has 3 materials, but there are 4 cells"));
    CellMaterials other = two_phases();
    other.site_phase[1] = 0;
    EXPECT_THAT(refusal(3, other), HasSubstr("m.yaml: material 1 is not that of its cell"));
    other = two_phases();
    other.site_orientation[2].phi2 = 0.001;
    EXPECT_THAT(refusal(3, other), HasSubstr("material 2"));
}

/// PyYAML takes a number without a point for a text.
TEST(DamaskMaterial, EveryNumberHasADecimalPoint) {
    const std::string text = encode_damask_material(3, two_phases());
    std::size_t n = 0;
    for (std::size_t at = text.find("O: ["); at != std::string::npos;
         at = text.find("O: [", at + 1)) {
        const std::string list = text.substr(at + 4, text.find(']', at) - at - 4);
        EXPECT_EQ(std::count(list.begin(), list.end(), ','), 3);
        EXPECT_EQ(std::count(list.begin(), list.end(), '.'), 4) << list;
        ++n;
    }
    EXPECT_EQ(n, 3U);
}

TEST(DamaskMaterial, DamageIsRefusedWithItsLine) {
    const std::string good = encode_damask_material(3, two_phases());
    const auto refusal = [&](const std::string& from, const std::string& to) -> std::string {
        std::string text = good;
        const std::size_t at = text.rfind(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, from.size(), to);
        try {
            decode_damask_material("m.yaml", text);
        } catch (const BadFile& fault) {
            return fault.what();
        }
        return "";
    };
    EXPECT_THAT(refusal("v: 1.0", "v: 0.9"), HasSubstr("m.yaml:36: the only constituent"));
    EXPECT_THAT(refusal("O: [0", "O: [1"),
                HasSubstr("m.yaml:37: the quaternion has not the length"));
    EXPECT_THAT(refusal("O: [0", "O: 0"), HasSubstr("m.yaml:37: entry 2 of material has another"));
    EXPECT_THAT(refusal("- phase: martensite", "- phase: bainite"),
                HasSubstr("'bainite' is not among"));
    EXPECT_THAT(refusal("homogenization: direct", "homogenization: SX"), HasSubstr("'SX' is not"));
    EXPECT_THAT(refusal("    constituents:\n", ""), HasSubstr("another form"));
    EXPECT_THAT(refusal("        v: 1.0\n", ""), HasSubstr("another form"));
    EXPECT_THAT(refusal("N_constituents: 1", "N_constituents: 2"),
                HasSubstr("m.yaml:7: cells have one constituent each"));
    EXPECT_THAT(refusal("    N_constituents: 1\n", ""), HasSubstr("lacks its N_constituents"));
    EXPECT_THAT(refusal("  direct:\n", "  direct: {}\n  direct:\n"),
                HasSubstr("m.yaml:7: 'direct' is there twice"));
    EXPECT_THAT(refusal("\nmaterial:\n", "\nmaterial:\nmaterial:\n"),
                HasSubstr("'material:' is there twice"));
    // The phases are the user's.
    EXPECT_EQ(refusal("C_11: 107.3e+9", "C_11: 233.3e+9"), "");
    EXPECT_EQ(refusal("    lattice: cF\n", "    # mine\n\n    lattice: cI\n"), "");
}

}  // namespace
}  // namespace pcvt
