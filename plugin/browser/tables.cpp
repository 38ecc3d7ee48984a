#include "plugin/browser/tables.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "io/bytes/bad_file.hpp"
#include "io/bytes/input_file.hpp"
#include "io/run_files/area_reader.hpp"
#include "io/run_files/site_table.hpp"
#include "io/run_files/size_column.hpp"
#include "io/run_files/table_reader.hpp"
#include "mesher/cells/target_areas.hpp"
#include "plugin/abi/guard.hpp"
#include "plugin/abi/options.hpp"
#include "plugin/job/job_start.hpp"

namespace pcvt::browser {
namespace {

/// Calls read() and turns exceptions into a status. Messages about files are those of the command.
template <class Read>
pcvt_status reading(const Read& read) {
    return abi::guarded([&](const std::fenv_t& /*host*/) -> pcvt_status {
        try {
            read();
        } catch (const BadFile& fault) {
            abi::set_last_error(fault.what());
            return PCVT_ERROR_ARGUMENT;
        }
        return PCVT_OK;
    });
}

/// The columns of the table of the sites that count: options win over them.
SiteColumns wanted_columns(const Run& run) {
    const pcvt_options& options = run.options;
    const bool has_inclusions = options.inclusions != nullptr || options.fibres != nullptr;
    const bool has_areas = options.areas != nullptr || !run.tables.areas.empty();
    const bool has_angles = options.orientations != nullptr || options.random_orientations != 0;
    return {.weights = options.weights == nullptr && run.tables.weights.empty() && !has_areas,
            .phases = options.phases == nullptr && !has_inclusions,
            .orientations = !has_angles && !has_inclusions};
}

void set_weights(const Eigen::VectorXd& weights, Run& run) {
    run.weights.assign(weights.begin(), weights.end());
    run.options.weights = run.weights.data();
    run.options.n_weights = static_cast<std::int32_t>(run.weights.size());
}

void take_weight_column(const WeightFile& weights, Run& run) {
    const char* const fault =
        run.options.max_iterations != 0
            ? ", whose cells keep them where they are; add --max-iterations 0, or take"
        : run.options.density_source != nullptr
            ? ", which do not work with --density or --stability; leave these out, or take"
            : nullptr;
    if (fault != nullptr) {
        throw BadFile(weights.name + ": the sites have weights" + fault +
                      " only the positions, --input " + run.tables.input + ":x,y");
    }
    set_weights(weights.weights, run);
}

void take_phases(const PhaseFile& phases, Run& run) {
    for (const std::string& name : phases.names) {
        run.phase_names += (run.phase_names.empty() ? "" : ",") + name;
    }
    run.site_phases.assign(phases.site_phases.begin(), phases.site_phases.end());
    run.options.phases = run.phase_names.c_str();
    run.options.site_phases = run.site_phases.data();
    run.options.n_site_phases = static_cast<std::int32_t>(run.site_phases.size());
}

void take_orientations(const std::vector<BungeAngles>& angles, Run& run) {
    for (const BungeAngles& own : angles) {
        run.orientations.insert(run.orientations.end(), {own.phi1, own.Phi, own.phi2});
    }
    run.options.orientations = run.orientations.data();
    run.options.n_orientations = static_cast<std::int32_t>(angles.size());
}

template <int kDimension>
void take_sites(Run& run) {
    const SiteTable<kDimension> table =
        read_site_table<kDimension>(parse_table_name(run.tables.input), wanted_columns(run));
    const auto& points = table.sites.points;
    run.sites.assign(points.data(), points.data() + points.size());
    run.options.sites = run.sites.data();
    run.options.n_sites = static_cast<std::int32_t>(points.cols());
    run.site_file = table.sites.name;
    run.site_lines = table.sites.lines;
    if (table.weights) take_weight_column(*table.weights, run);
    if (table.phases) take_phases(*table.phases, run);
    if (!table.orientations.empty()) take_orientations(table.orientations, run);
}

/// Takes the areas of a file that exists; else their text is a law.
void take_areas(Run& run) {
    const std::string& text = run.tables.areas;
    const TableName name = area_table(text);
    std::error_code unknown;
    if (names_area_law(text) || !std::filesystem::exists(name.path, unknown)) {
        run.options.area_law = text.c_str();
        return;
    }
    const AreaFile file = read_areas(name);
    require_areas(file, run.options.n_sites);
    run.areas.assign(file.areas.begin(), file.areas.end());
    run.options.areas = run.areas.data();
    run.options.n_areas = static_cast<std::int32_t>(run.areas.size());
}

void take_weights(Run& run) {
    const WeightFile file = read_weights(weight_table(run.tables.weights));
    require_weights(file, run.options.n_sites);
    set_weights(file.weights, run);
}

/// Refuses coincident sites by their lines.
template <int kDimension>
void refuse_duplicates(const Run& run) {
    using Points = Eigen::Matrix<double, kDimension, Eigen::Dynamic>;
    Job job = abi::make_job(run.options);
    try {
        settle_duplicates(job);
    } catch (const DuplicateSites& duplicate) {
        throw duplicate_lines(
            SiteFileOf<kDimension>{
                run.site_file,
                Eigen::Map<const Points>(run.sites.data(), kDimension, run.options.n_sites),
                run.site_lines},
            duplicate);
    }
}

/// The first site that a message names, "the cell of site 3 is empty"; -1 without one.
int named_site(std::string_view message) {
    constexpr std::string_view kWord = "site ";
    for (std::size_t k = message.find(kWord); k != std::string_view::npos;
         k = message.find(kWord, k + 1)) {
        std::string_view rest = message.substr(k + kWord.size());
        rest = rest.substr(0, rest.find_first_not_of("0123456789"));
        if (!rest.empty() && rest.size() < 10) return std::stoi(std::string(rest));
    }
    return -1;
}

bool are_digits(std::string_view field) {
    return !field.empty() && field.find_first_not_of("0123456789") == std::string_view::npos;
}

/// Refuses a first row such as "1,5", which may be one number or two.
void require_clear_commas(TableScanner& scanner) {
    if (scanner.separator() != Separator::kComma || !scanner.next()) return;
    const std::vector<std::string_view>& fields = scanner.fields();
    if (!std::all_of(fields.begin(), fields.end(), are_digits)) return;
    scanner.refuse("'" + std::string(fields[0]) + "," + std::string(fields[1]) +
                   "' may be one number or two; choose sites, or for sizes write decimal points");
}

TableUse use_of_header(const TableScanner& scanner, const TableName& name) {
    if (scanner.find("x") && scanner.find("y")) return TableUse::kSites;
    const bool has_sizes =
        std::any_of(scanner.header().begin(), scanner.header().end(),
                    [](const TableColumn& column) { return stated_size(column.name).has_value(); });
    if (has_sizes || scanner.n_columns() == 1) return TableUse::kSizes;
    scanner.refuse_header(
        "no columns are called x and y, and none area or diameter; name the "
        "columns of the coordinates, " +
        with_columns(name, "", "X,Y") + ", or that of the sizes, " +
        with_columns(name, "area", "COLUMN") + " or " + with_columns(name, "diameter", "COLUMN"));
}

TableUse guessed_use(const TableName& name, std::string_view text) {
    if (!name.prefix.empty()) return TableUse::kSizes;
    if (!name.columns.empty()) {
        return name.columns.size() == 1 ? TableUse::kSizes : TableUse::kSites;
    }
    TableScanner scanner(name.path, text);
    if (scanner.has_header()) return use_of_header(scanner, name);
    if (scanner.n_columns() == 1) return TableUse::kSizes;
    if (scanner.n_columns() == 2) require_clear_commas(scanner);
    return TableUse::kSites;
}

/// The lines of a table's contents.
struct ContentLines {
    const char* use;
    std::size_t n_rows;
    std::string name;
    std::string quantity;
    std::string columns = {};
    std::string unit = {};
};

std::string text_of(const ContentLines& lines) {
    return std::string(lines.use) + '\n' + std::to_string(lines.n_rows) + '\n' + lines.name + '\n' +
           lines.quantity + '\n' + lines.columns + '\n' + lines.unit;
}

void add_column(const TableScanner& scanner, std::size_t column, ContentLines& contents) {
    const std::string name =
        scanner.has_header() ? scanner.header()[column].name : std::to_string(column + 1);
    contents.columns += (contents.columns.empty() ? "" : "\t") + name;
    if (scanner.has_header()) contents.unit = scanner.header()[column].unit;
}

ContentLines contents_of_sites(const TableName& name, std::string_view text,
                               std::vector<double>& points) {
    const SiteFile file = parse_sites<2>(name, text);
    points.assign(file.points.data(), file.points.data() + file.points.size());
    ContentLines contents{.use = "sites",
                          .n_rows = file.lines.size(),
                          .name = with_columns(name, "", ""),
                          .quantity = "sites"};
    TableScanner scanner(name.path, text);
    if (!name.columns.empty()) {
        for (const std::size_t column : scanner.choose(name.columns)) {
            add_column(scanner, column, contents);
        }
        contents.name = with_columns(name, "", name.columns[0] + "," + name.columns[1]);
    } else if (scanner.has_header()) {
        for (const char* const column : {"x", "y"}) {
            add_column(scanner, *scanner.find(column), contents);
        }
        const bool has_more =
            scanner.find("weight") || scanner.find("phase") || scanner.find("phi1");
        if (has_more) contents.name = with_columns(name, "", "x,y");
    }
    return contents;
}

ContentLines contents_of_sizes(const TableName& name, std::string_view text) {
    const AreaFile file = parse_areas(name, text);
    TableScanner scanner(name.path, text);
    const SizeColumn found = find_sizes(scanner, name);
    ContentLines contents{
        .use = "sizes",
        .n_rows = file.lines.size(),
        .name = with_columns(name, name.prefix, name.columns.empty() ? "" : name.columns[0]),
        .quantity = size_words(found.kind).plural};
    if (scanner.has_header() || !name.columns.empty()) add_column(scanner, found.column, contents);
    return contents;
}

}  // namespace

pcvt_status read_tables(Run& run) {
    const TableTexts& tables = run.tables;
    return reading([&] {
        if (!tables.input.empty()) {
            run.options.dimension == 3 ? take_sites<3>(run) : take_sites<2>(run);
        }
        if (!tables.areas.empty()) take_areas(run);
        if (!tables.weights.empty()) take_weights(run);
    });
}

void name_lines(const Run& run, pcvt_status status) {
    // Without the sites that are left out, the others have other numbers.
    if (status != PCVT_ERROR_GEOMETRY || run.site_lines.empty() || run.options.duplicates != 0) {
        return;
    }
    const std::string message = abi::last_error();
    const pcvt_status found = reading([&] {
        run.options.dimension == 3 ? refuse_duplicates<3>(run) : refuse_duplicates<2>(run);
    });
    if (found == PCVT_ERROR_ARGUMENT) return;
    const int site = named_site(message);
    const bool is_known = site >= 0 && site < std::ssize(run.site_lines);
    const std::string place =
        is_known ? run.site_file + ":" + std::to_string(run.site_lines[std::size_t(site)]) + ": "
                 : "";
    abi::set_last_error((place + message).c_str());
}

pcvt_status look_at_table(const std::string& text, TableUse use, TableContents& contents) {
    return reading([&] {
        contents = {};
        const TableName name = parse_table_name(text, {"area", "diameter", "radius"});
        const std::string bytes = read_whole_file(name.path, kSiteInput);
        const TableUse chosen = use == TableUse::kGuessed ? guessed_use(name, bytes) : use;
        contents.lines =
            text_of(chosen == TableUse::kSites ? contents_of_sites(name, bytes, contents.points)
                                               : contents_of_sizes(name, bytes));
    });
}

}  // namespace pcvt::browser
