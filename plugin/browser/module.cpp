// The functions of the module that JavaScript calls: options and results of pcvt.h, with fields by
// name.
#include <emscripten.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "plugin/browser/run.hpp"
#include "plugin/browser/tables.hpp"
#include "plugin/pcvt.h"

namespace pcvt::browser {
namespace {

template <class Struct, class Value>
using Field = std::pair<std::string_view, Value Struct::*>;

constexpr Field<pcvt_options, std::int32_t> kIntegers[] = {
    {"n_sites", &pcvt_options::n_sites},
    {"start", &pcvt_options::start},
    {"solver", &pcvt_options::solver},
    {"max_iterations", &pcvt_options::max_iterations},
    {"columns", &pcvt_options::columns},
    {"rows", &pcvt_options::rows},
    {"grain_order", &pcvt_options::grain_order},
    {"grain_per_edge", &pcvt_options::grain_per_edge},
    {"find_origin", &pcvt_options::find_origin},
    {"random_orientations", &pcvt_options::random_orientations},
    {"symmetry", &pcvt_options::symmetry},
    {"walls", &pcvt_options::walls},
    {"wall_cells", &pcvt_options::wall_cells},
    {"dimension", &pcvt_options::dimension},
    {"duplicates", &pcvt_options::duplicates},
};
constexpr Field<pcvt_options, double> kReals[] = {
    {"tolerance", &pcvt_options::tolerance},           {"grain_size", &pcvt_options::grain_size},
    {"short_edges", &pcvt_options::short_edges},       {"aspect", &pcvt_options::aspect},
    {"aspect_degrees", &pcvt_options::aspect_degrees},
};
constexpr Field<pcvt_options, const char*> kTexts[] = {
    {"density_source", &pcvt_options::density_source},
    {"phases", &pcvt_options::phases},
    {"inclusions", &pcvt_options::inclusions},
    {"fibres", &pcvt_options::fibres},
    {"holes", &pcvt_options::holes},
};
constexpr Field<TableTexts, std::string> kTables[] = {
    {"input", &TableTexts::input},
    {"areas", &TableTexts::areas},
    {"weights", &TableTexts::weights},
};
constexpr Field<pcvt_write_options, std::int32_t> kWriteIntegers[] = {
    {"kind", &pcvt_write_options::kind},
    {"outline", &pcvt_write_options::outline},
    {"colour", &pcvt_write_options::colour},
    {"gltf_nodes", &pcvt_write_options::gltf_nodes},
    {"single_precision", &pcvt_write_options::single_precision},
    {"pixels", &pcvt_write_options::pixels},
    {"surface", &pcvt_write_options::surface},
};

/// Sets the field of this name; returns whether there is one.
template <class Struct, class Value, std::size_t n, class Given>
bool set_field(const Field<Struct, Value> (&fields)[n], Struct& values, std::string_view name,
               const Given& given) {
    for (const auto& [field, place] : fields) {
        if (field == name) {
            values.*place = static_cast<Value>(given);
            return true;
        }
    }
    return false;
}

// Calls the function that JavaScript stored as Module.progress; it throws nothing.
EM_JS(int, report_progress,
      (int iteration, int evaluations, double energy, double energy_bound, double residual,
       int phase, double fraction, const char* text, const double* sites, int n_sites),
      {
          return Module["progress"](iteration, evaluations, energy, energy_bound, residual, phase,
                                    fraction, text, sites, n_sites);
      });

/// @param data  a bool: whether JavaScript needs the sites.
int on_progress(const pcvt_progress* p, void* data) {
    pcvt_sites sites{};
    if (*static_cast<const bool*>(data) && p->phase == PCVT_PHASE_OPTIMISE) {
        pcvt_get_progress_sites(&sites, sizeof sites);
    }
    return report_progress(p->iteration, p->evaluations, p->energy, p->energy_bound, p->residual,
                           p->phase, p->fraction, p->phase_text, sites.points, sites.n_sites);
}

/// The contents of the table that was read last.
TableContents contents_of_table;

/// Keeps numbers for the time of a run, and says how many values they are.
/// @param n_parts  numbers in each value.
template <class Stored, class Count>
void keep(const double* numbers, int n, int n_parts, std::vector<Stored>& stored,
          const Stored*& field, Count& n_values) {
    stored.assign(numbers, numbers + n);
    field = stored.data();
    n_values = static_cast<Count>(n / n_parts);
}

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE Run* run_new() {
    Run* const run = new Run;
    run->options.n_threads = 1;
    run->texts.reserve(std::size(kTexts));
    return run;
}

EMSCRIPTEN_KEEPALIVE void run_free(Run* run) {
    pcvt_free(run->result);
    delete run;
}

EMSCRIPTEN_KEEPALIVE bool run_number(Run* run, const char* name, double value) {
    if (std::string_view(name) == "seed") {
        run->options.seed = static_cast<std::uint64_t>(value);
        return true;
    }
    return set_field(kIntegers, run->options, name, value) ||
           set_field(kReals, run->options, name, value) ||
           set_field(kWriteIntegers, run->write, name, value);
}

EMSCRIPTEN_KEEPALIVE bool run_text(Run* run, const char* name, const char* text) {
    if (set_field(kTables, run->tables, name, text)) return true;
    run->texts.emplace_back(text);
    return set_field(kTexts, run->options, name, run->texts.back().c_str());
}

EMSCRIPTEN_KEEPALIVE bool run_numbers(Run* run, const char* name, const double* numbers, int n) {
    const std::string_view key = name;
    pcvt_options& options = run->options;
    if (key == "lattice" && n == 4)
        std::copy(numbers, numbers + n, options.lattice);
    else if (key == "lattice3" && n == 9)
        std::copy(numbers, numbers + n, options.lattice3);
    else if (key == "origin" && n == 2)
        std::copy(numbers, numbers + n, options.origin);
    else if (key == "sites")
        keep(numbers, n, options.dimension, run->sites, options.sites, options.n_sites);
    else if (key == "areas")
        keep(numbers, n, 1, run->areas, options.areas, options.n_areas);
    else if (key == "weights")
        keep(numbers, n, 1, run->weights, options.weights, options.n_weights);
    else if (key == "site_phases")
        keep(numbers, n, 1, run->site_phases, options.site_phases, options.n_site_phases);
    else if (key == "orientations")
        keep(numbers, n, 3, run->orientations, options.orientations, options.n_orientations);
    else if (key == "fixed_sites")
        keep(numbers, n, 2, run->fixed, options.fixed_sites, options.n_fixed_sites);
    else
        return false;
    return true;
}

EMSCRIPTEN_KEEPALIVE int run_generate(Run* run, bool with_progress, bool with_sites) {
    if (with_progress) run->options.progress = on_progress;
    run->options.progress_data = &with_sites;
    if (const pcvt_status status = read_tables(*run); status != PCVT_OK) return status;
    const pcvt_status status = pcvt_generate(&run->options, &run->result);
    name_lines(*run, status);
    return status;
}

/// Writes energy, bound, residual, hexagons, iterations, evaluations, stop to `numbers`.
EMSCRIPTEN_KEEPALIVE int run_statistics(const Run* run, double* numbers) {
    pcvt_statistics found;
    const int status = pcvt_get_statistics(run->result, &found, sizeof found);
    if (status != PCVT_OK) return status;
    const double values[] = {found.energy,
                             found.energy_bound,
                             found.residual,
                             double(found.n_hexagons),
                             double(found.iterations),
                             double(found.evaluations),
                             double(found.stop)};
    std::copy(std::begin(values), std::end(values), numbers);
    return PCVT_OK;
}

EMSCRIPTEN_KEEPALIVE int run_valences(const Run* run, const std::int32_t** valences) {
    pcvt_statistics found;
    if (pcvt_get_statistics(run->result, &found, sizeof found) != PCVT_OK) return 0;
    *valences = found.valences;
    return found.n_valences;
}

/// Sets the address of the pairs of dropped sites; returns the number of numbers.
EMSCRIPTEN_KEEPALIVE int run_dropped(const Run* run, const std::int32_t** pairs) {
    pcvt_statistics found;
    if (pcvt_get_statistics(run->result, &found, sizeof found) != PCVT_OK) return -1;
    *pairs = found.dropped;
    return 2 * found.n_dropped;
}

/// Sets the address of the sites, two or three numbers each; returns the number of numbers.
EMSCRIPTEN_KEEPALIVE int run_sites(const Run* run, const double** numbers) {
    if (run->options.dimension == 3) {
        pcvt_cells cells;
        if (pcvt_get_cells(run->result, &cells, sizeof cells) != PCVT_OK) return -1;
        *numbers = cells.sites;
        return 3 * cells.n_cells;
    }
    pcvt_sites sites;
    if (pcvt_get_sites(run->result, &sites, sizeof sites) != PCVT_OK) return -1;
    *numbers = sites.points;
    return 2 * sites.n_sites;
}

/// Reads a table of the file system of the module.
/// @param use  a TableUse.
/// @returns TableContents::lines, nullptr for an error. The text is valid until the next call.
EMSCRIPTEN_KEEPALIVE const char* table_lines(const char* name, int use) {
    const pcvt_status status = look_at_table(name, static_cast<TableUse>(use), contents_of_table);
    return status == PCVT_OK ? contents_of_table.lines.c_str() : nullptr;
}

/// Sets the address of the sites of the table that was read last; returns the number of numbers.
EMSCRIPTEN_KEEPALIVE int table_points(const double** numbers) {
    *numbers = contents_of_table.points.data();
    return static_cast<int>(contents_of_table.points.size());
}

EMSCRIPTEN_KEEPALIVE void run_write_defaults(Run* run) {
    run->write = {};
    run->write.struct_size = sizeof run->write;
    run->write.replace = 1;
}

EMSCRIPTEN_KEEPALIVE int run_write(const Run* run, const char* path) {
    return pcvt_write(run->result, path, &run->write);
}

}  // extern "C"

}  // namespace pcvt::browser
