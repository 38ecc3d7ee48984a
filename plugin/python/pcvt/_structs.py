"""The structs of pcvt.h. Written by plugin/words."""

import ctypes
from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int, c_int32, c_int64, c_size_t, c_uint64
from ctypes import c_void_p


class Progress(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("iteration", c_int32), ("evaluations", c_int32), ("energy", c_double),
                ("energy_bound", c_double), ("residual", c_double), ("rms_residual", c_double), ("phase", c_int32),
                ("reserved", c_int32), ("fraction", c_double), ("phase_text", c_char_p)]


ProgressCallback = CFUNCTYPE(c_int, POINTER(Progress), c_void_p)
DensityCallback = CFUNCTYPE(c_int, c_void_p, c_size_t, c_void_p, c_void_p)


class Options(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("lattice", c_double * 4), ("origin", c_double * 2), ("sites", c_void_p),
                ("n_sites", c_int32), ("start", c_int32), ("seed", c_uint64), ("solver", c_int32),
                ("max_iterations", c_int32), ("tolerance", c_double), ("n_threads", c_int32), ("columns", c_int32),
                ("rows", c_int32), ("grain_order", c_int32), ("grain_size", c_double), ("short_edges", c_double),
                ("budget", c_int64), ("density_source", c_char_p), ("density_range", c_double * 2),
                ("density", DensityCallback), ("density_data", c_void_p), ("progress", ProgressCallback),
                ("progress_data", c_void_p), ("grain_per_edge", c_int32), ("find_origin", c_int32),
                ("areas", c_void_p), ("n_areas", c_int32), ("reserved", c_int32), ("area_law", c_char_p),
                ("aspect", c_double), ("aspect_degrees", c_double), ("phases", c_char_p),
                ("orientations", c_void_p), ("n_orientations", c_int32), ("random_orientations", c_int32),
                ("symmetry", c_int32), ("walls", c_int32), ("wall_cells", c_int32), ("reserved2", c_int32),
                ("inclusions", c_char_p), ("fibres", c_char_p), ("fixed_sites", c_void_p),
                ("n_fixed_sites", c_int32), ("reserved3", c_int32), ("holes", c_char_p), ("dimension", c_int32),
                ("reserved4", c_int32), ("lattice3", c_double * 9), ("duplicates", c_int32), ("n_weights", c_int32),
                ("weights", c_void_p), ("site_phases", c_void_p), ("n_site_phases", c_int32),
                ("reserved5", c_int32), ("origin_z", c_double), ("volumes", c_void_p), ("volume_law", c_char_p),
                ("n_volumes", c_int32), ("reserved6", c_int32), ("orientation_weights", c_void_p),
                ("aspect_axis", c_double * 3), ("layers", c_int32), ("sites_are_centroids", c_int32)]


class Sites(ctypes.Structure):
    _fields_ = [("lattice", c_double * 4), ("points", c_void_p), ("n_sites", c_int32), ("reserved", c_int32),
                ("weights", c_void_p), ("phases", c_void_p), ("phase_names", POINTER(c_char_p)),
                ("orientations", c_void_p), ("n_phases", c_int32), ("n_orbits", c_int32), ("orbits", c_void_p)]


class Inclusions(ctypes.Structure):
    _fields_ = [("numbers", c_void_p), ("begin", c_void_p), ("form", c_void_p), ("tags", POINTER(c_char_p)),
                ("n_shapes", c_int32), ("reserved", c_int32)]


class Mesh(ctypes.Structure):
    _fields_ = [("lattice", c_double * 4), ("vertices", c_void_p), ("face_begin", c_void_p),
                ("corner_vertex", c_void_p), ("corner_offset", c_void_p), ("opposite", c_void_p),
                ("site", c_void_p), ("site_points", c_void_p), ("kind", c_int32), ("n_vertices", c_int32),
                ("n_faces", c_int32), ("n_corners", c_int32)]


class Tile(ctypes.Structure):
    _fields_ = [("lattice", c_double * 4), ("points", c_void_p), ("face_begin", c_void_p), ("corners", c_void_p),
                ("face_site", c_void_p), ("site_points", c_void_p), ("vertex_site", c_void_p),
                ("vertex_orbit", c_void_p), ("vertex_offset", c_void_p), ("edge_pairs", c_void_p),
                ("kind", c_int32), ("outline", c_int32), ("n_vertices", c_int32), ("n_faces", c_int32),
                ("n_corners", c_int32), ("n_edge_pairs", c_int32), ("wall_edges", c_void_p),
                ("n_wall_edges", c_int32), ("n_holes", c_int32), ("hole_names", POINTER(c_char_p))]


class Cells(ctypes.Structure):
    _fields_ = [("lattice", c_double * 9), ("points", c_void_p), ("point_orbit", c_void_p),
                ("point_offset", c_void_p), ("face_begin", c_void_p), ("face_points", c_void_p),
                ("owner", c_void_p), ("neighbour", c_void_p), ("partner", c_void_p), ("partner_offset", c_void_p),
                ("volumes", c_void_p), ("site_points", c_void_p), ("sites", c_void_p), ("n_cells", c_int32),
                ("n_faces", c_int32), ("n_inner_faces", c_int32), ("n_points", c_int32), ("n_face_points", c_int32),
                ("n_phases", c_int32), ("phases", c_void_p), ("phase_names", POINTER(c_char_p)),
                ("orientations", c_void_p), ("weights", c_void_p)]


class Statistics(ctypes.Structure):
    _fields_ = [("energy", c_double), ("energy_bound", c_double), ("residual", c_double),
                ("rms_residual", c_double), ("seconds_build", c_double), ("seconds_optimize", c_double),
                ("valences", c_void_p), ("n_valences", c_int32), ("n_hexagons", c_int32), ("stop", c_int32),
                ("n_sites", c_int32), ("iterations", c_int32), ("evaluations", c_int32), ("n_threads", c_int32),
                ("n_mirrors", c_int32), ("area_error", c_double), ("newton_steps", c_int32), ("n_dropped", c_int32),
                ("dropped", c_void_p)]


class WriteOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("report", c_char_p), ("kind", c_int32), ("outline", c_int32),
                ("replace", c_int32), ("colour", c_int32), ("progress", ProgressCallback),
                ("progress_data", c_void_p), ("gltf_nodes", c_int32), ("single_precision", c_int32),
                ("pixels", c_int32), ("element", c_int32), ("cut_width", c_double), ("background", c_char_p),
                ("voxels", c_int32 * 2), ("job", c_int32), ("voxel_layers", c_int32), ("thickness", c_double),
                ("surface", c_int32), ("reserved2", c_int32), ("materials", c_char_p), ("coriolis", c_double * 2)]


class CheckOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("lattice", c_double * 4), ("tolerance", c_double), ("cvt", c_double),
                ("areas", c_char_p), ("inclusions", c_char_p), ("density", c_char_p),
                ("density_range", c_double * 2), ("progress", ProgressCallback), ("progress_data", c_void_p),
                ("volumes", c_char_p)]


class StudyOptions(ctypes.Structure):
    _fields_ = [("struct_size", c_size_t), ("name", c_char_p), ("sites", c_void_p), ("n_sites", c_int32),
                ("runs", c_int32), ("seed", c_uint64), ("n_threads", c_int32), ("replace", c_int32),
                ("path", c_char_p), ("progress", ProgressCallback), ("progress_data", c_void_p)]


class StudyContents(ctypes.Structure):
    _fields_ = [("text", c_char_p), ("n_tables", c_int32), ("n_pictures", c_int32)]


class Table(ctypes.Structure):
    _fields_ = [("name", c_char_p), ("columns", POINTER(c_char_p)), ("cells", POINTER(c_char_p)),
                ("notes", POINTER(c_char_p)), ("n_columns", c_int32), ("n_rows", c_int32), ("n_notes", c_int32),
                ("reserved", c_int32)]


class Picture(ctypes.Structure):
    _fields_ = [("name", c_char_p), ("svg", c_char_p)]
