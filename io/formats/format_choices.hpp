#pragma once

namespace pcvt {

/// The choices of FileOptions that a format takes.
///
/// Example usage:
///   constexpr FormatChoices of_tables{.phases = true, .orientations = true};
struct FormatChoices {
    bool gltf_nodes = false;
    bool single_precision = false;
    bool pixels = false;
    bool voxels = false;
    bool coriolis = false;
    bool cut_width = false;
    bool element = false;
    bool job = false;
    /// Beside a job, if the format takes one.
    bool constants = false;
    bool thickness = false;
    bool colouring = false;
    bool background = false;
    bool phases = false;
    bool orientations = false;
};

}  // namespace pcvt
