#pragma once

#include <array>
#include <string>

#include "mesher/base/error.hpp"
#include "plugin/abi/option_values.hpp"
#include "plugin/job/features.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// A field of a struct of pcvt.h, which belongs to a feature of a job by its name.
template <class Struct>
struct FieldRow {
    const char* name;
    /// Whether two structs differ in the field.
    bool (*differs)(const Struct& one, const Struct& other);
};

template <auto kField, class Struct>
bool differ_in(const Struct& one, const Struct& other) {
    return differ(one.*kField, other.*kField);
}

/// The fields that features name (FeatureRow::fields).
inline constexpr std::array kOptionFields{
    FieldRow<pcvt_options>{"lattice", differ_in<&pcvt_options::lattice>},
    FieldRow<pcvt_options>{"lattice3", differ_in<&pcvt_options::lattice3>},
    FieldRow<pcvt_options>{"symmetry", differ_in<&pcvt_options::symmetry>},
    FieldRow<pcvt_options>{"origin", differ_in<&pcvt_options::origin>},
    FieldRow<pcvt_options>{"find_origin", differ_in<&pcvt_options::find_origin>},
    FieldRow<pcvt_options>{"density_source", differ_in<&pcvt_options::density_source>},
    FieldRow<pcvt_options>{"density", differ_in<&pcvt_options::density>},
    FieldRow<pcvt_options>{"density_data", differ_in<&pcvt_options::density_data>},
    FieldRow<pcvt_options>{"density_range", differ_in<&pcvt_options::density_range>},
    FieldRow<pcvt_options>{"areas", differ_in<&pcvt_options::areas>},
    FieldRow<pcvt_options>{"n_areas", differ_in<&pcvt_options::n_areas>},
    FieldRow<pcvt_options>{"area_law", differ_in<&pcvt_options::area_law>},
    FieldRow<pcvt_options>{"aspect", differ_in<&pcvt_options::aspect>},
    FieldRow<pcvt_options>{"aspect_degrees", differ_in<&pcvt_options::aspect_degrees>},
    FieldRow<pcvt_options>{"walls", differ_in<&pcvt_options::walls>},
    FieldRow<pcvt_options>{"wall_cells", differ_in<&pcvt_options::wall_cells>},
    FieldRow<pcvt_options>{"fixed_sites", differ_in<&pcvt_options::fixed_sites>},
    FieldRow<pcvt_options>{"n_fixed_sites", differ_in<&pcvt_options::n_fixed_sites>},
    FieldRow<pcvt_options>{"inclusions", differ_in<&pcvt_options::inclusions>},
    FieldRow<pcvt_options>{"fibres", differ_in<&pcvt_options::fibres>},
    FieldRow<pcvt_options>{"holes", differ_in<&pcvt_options::holes>},
    FieldRow<pcvt_options>{"budget", differ_in<&pcvt_options::budget>},
    FieldRow<pcvt_options>{"phases", differ_in<&pcvt_options::phases>},
    FieldRow<pcvt_options>{"orientations", differ_in<&pcvt_options::orientations>},
    FieldRow<pcvt_options>{"n_orientations", differ_in<&pcvt_options::n_orientations>},
    FieldRow<pcvt_options>{"random_orientations", differ_in<&pcvt_options::random_orientations>},
    FieldRow<pcvt_options>{"grain_size", differ_in<&pcvt_options::grain_size>},
    FieldRow<pcvt_options>{"grain_per_edge", differ_in<&pcvt_options::grain_per_edge>},
    FieldRow<pcvt_options>{"grain_order", differ_in<&pcvt_options::grain_order>},
    FieldRow<pcvt_options>{"columns", differ_in<&pcvt_options::columns>},
    FieldRow<pcvt_options>{"rows", differ_in<&pcvt_options::rows>}};
inline constexpr std::array kWriteFields{
    FieldRow<pcvt_write_options>{"outline", differ_in<&pcvt_write_options::outline>},
    FieldRow<pcvt_write_options>{"colour", differ_in<&pcvt_write_options::colour>},
    FieldRow<pcvt_write_options>{"background", differ_in<&pcvt_write_options::background>},
    FieldRow<pcvt_write_options>{"gltf_nodes", differ_in<&pcvt_write_options::gltf_nodes>},
    FieldRow<pcvt_write_options>{"single_precision",
                                 differ_in<&pcvt_write_options::single_precision>},
    FieldRow<pcvt_write_options>{"surface", differ_in<&pcvt_write_options::surface>},
    FieldRow<pcvt_write_options>{"pixels", differ_in<&pcvt_write_options::pixels>},
    FieldRow<pcvt_write_options>{"voxels", differ_in<&pcvt_write_options::voxels>},
    FieldRow<pcvt_write_options>{"voxel_layers", differ_in<&pcvt_write_options::voxel_layers>},
    FieldRow<pcvt_write_options>{"coriolis", differ_in<&pcvt_write_options::coriolis>},
    FieldRow<pcvt_write_options>{"cut_width", differ_in<&pcvt_write_options::cut_width>},
    FieldRow<pcvt_write_options>{"element", differ_in<&pcvt_write_options::element>},
    FieldRow<pcvt_write_options>{"job", differ_in<&pcvt_write_options::job>},
    FieldRow<pcvt_write_options>{"thickness", differ_in<&pcvt_write_options::thickness>},
    FieldRow<pcvt_write_options>{"materials", differ_in<&pcvt_write_options::materials>}};

/// Requires that the fields of features which jobs of a dimension lack have their defaults.
///
/// Example usage:
///   require_default_fields(kOptionFields, options, default_options(), &FeatureRow::in_space,
///                          "is not for three dimensions");
///
/// @param of_dimension  FeatureRow::in_plane or in_space.
/// @param why           the end of the message.
/// @throws InvalidInput naming the first field of another value.
template <class Fields, class Struct>
void require_default_fields(const Fields& fields, const Struct& given, const Struct& defaults,
                            bool FeatureRow::*of_dimension, const char* why) {
    for (const FieldRow<Struct>& field : fields) {
        if (find_field(field.name)->*of_dimension || !field.differs(given, defaults)) continue;
        throw InvalidInput(std::string(field.name) + " " + why);
    }
}

}  // namespace pcvt::abi
