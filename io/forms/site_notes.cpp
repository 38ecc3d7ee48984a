#include "io/forms/site_notes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "io/bytes/char_set.hpp"
#include "io/forms/note_table.hpp"
#include "io/forms/tile_file.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/tile/site_positions.hpp"
#include "mesher/plane/tile/tile_edges.hpp"

namespace pcvt {
namespace {

/// The width of the forms of comments, before their meanings.
constexpr std::size_t kMeaningColumn = 27;

constexpr CharSet kNameLetters("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-");
/// A bound above all indices of vertices.
constexpr double kMostHoleVertices = 2147483647;

std::vector<double> periods(const plane::Tile& tile) {
    return {double(tile.columns), double(tile.rows)};
}

void take_periods(std::span<const double> numbers, SiteNotes& notes) {
    for (const double n : numbers) {
        if (n >= 1 && n <= kMostPeriods) continue;
        throw InvalidInput("the number of periods is not from 1 to " +
                           std::to_string(kMostPeriods));
    }
    notes.columns = static_cast<int>(numbers[0]);
    notes.rows = static_cast<int>(numbers[1]);
}

std::vector<double> short_edges(const plane::Tile& tile) { return {tile.short_edges}; }

void take_short_edges(std::span<const double> numbers, SiteNotes& notes) {
    if (!(numbers[0] >= 0 && numbers[0] <= kLongestRemovedEdge)) {
        throw InvalidInput("the length of short edges is not from 0 to 1");
    }
    notes.short_edges = numbers[0];
}

std::vector<double> metric(const plane::Tile& tile) {
    return {tile.metric.ratio(), tile.metric.degrees()};
}

void take_metric(std::span<const double> numbers, SiteNotes& notes) {
    notes.metric = plane::Metric(numbers[0], numbers[1]);
}

std::vector<double> walls(const plane::Tile& tile) {
    const std::array<double, 2> numbers = walls_as_numbers(tile.walls);
    return {numbers.begin(), numbers.end()};
}

void take_walls(std::span<const double> numbers, SiteNotes& notes) {
    const WallsRow* const row = walls_of_numbers(numbers[0], numbers[1]);
    if (row == nullptr) throw InvalidInput("the walls across x and across y are not 0 or 1");
    notes.walls = row->walls;
}

std::vector<double> positions(const plane::Tile& tile) {
    std::vector<double> numbers;
    for (const plane::Vec2& p : site_positions(tile)) numbers.insert(numbers.end(), {p.x(), p.y()});
    return numbers;
}

void take_positions(std::span<const double> numbers, SiteNotes& notes) {
    for (std::size_t k = 0; k < numbers.size(); k += 2) {
        notes.positions.emplace_back(numbers[k], numbers[k + 1]);
    }
}

std::vector<double> weights(const plane::Tile& tile) { return tile.site_weights; }

void take_weights(std::span<const double> numbers, SiteNotes& notes) {
    notes.weights.insert(notes.weights.end(), numbers.begin(), numbers.end());
}

SiteNote note_of_walls() {
    return {.parts = "across_x across_y",
            .n_parts = 2,
            .comment = "walls",
            .member = "walls",
            .array = "Walls",
            .property = "pcvt_walls",
            .meaning = "1: the sides across that axis are walls, at 0 and at the period",
            .numbers = walls,
            .take = take_walls,
            .usual = {0, 0},
            .of_integers = true};
}

const std::array<SiteNote, 6>& rows() {
    static const std::array<SiteNote, 6> kRows{
        {{.parts = "columns rows",
          .n_parts = 2,
          .comment = "periods",
          .member = "periods",
          .array = "Periods",
          .property = "",
          .meaning = "a repeated tile has the sites of one period in each",
          .numbers = periods,
          .take = take_periods,
          .usual = {1, 1},
          .of_integers = true,
          .always_in_arrays = true},
         {.parts = "length",
          .n_parts = 1,
          .comment = "short_edges",
          .member = "shortEdges",
          .array = "ShortEdges",
          .property = "",
          .meaning = "edges of cells shorter than this, in units of h, were removed",
          .numbers = short_edges,
          .take = take_short_edges,
          .usual = {0},
          .always_in_arrays = true},
         {.parts = "ratio degrees",
          .n_parts = 2,
          .comment = "metric",
          .member = "metric",
          .array = "Metric",
          .property = "pcvt_metric",
          .meaning = "cells are ratio times as long along degrees from x as across",
          .numbers = metric,
          .take = take_metric,
          .usual = {1, 0}},
         note_of_walls(),
         {.parts = "x y",
          .n_parts = 2,
          .comment = "site",
          .member = "sitePositions",
          .array = "SitePositions",
          .property = "",
          .meaning = "where site 0, 1, ... lies: the image at its first face",
          .numbers = positions,
          .take = take_positions,
          .of_each_site = true},
         {.parts = "weight",
          .n_parts = 1,
          .comment = "site",
          .member = "siteWeights",
          .array = "SiteWeights",
          .property = "pcvt_site_weights",
          .meaning = "power cells: where |p - site|^2 - weight is least",
          .numbers = weights,
          .take = take_weights,
          .of_each_site = true}}};
    return kRows;
}

/// The numbers of each site, of one note after the other.
NoteTable site_table(const std::vector<StatedNote>& stated) {
    std::size_t n_sites = 0;
    std::size_t width = 0;
    std::string columns;
    for (const auto& [note, numbers] : stated) {
        if (!note->of_each_site) continue;
        n_sites = numbers.size() / note->n_parts;
        width += note->n_parts;
        (columns += columns.empty() ? "" : " ") += note->parts;
    }
    std::vector<double> rows;
    rows.reserve(n_sites * width);
    for (std::size_t s = 0; s < n_sites; ++s) {
        for (const auto& [note, numbers] : stated) {
            if (!note->of_each_site) continue;
            const auto first = numbers.begin() + std::ptrdiff_t(s * note->n_parts);
            rows.insert(rows.end(), first, first + std::ptrdiff_t(note->n_parts));
        }
    }
    return {.word = "site",
            .columns = std::move(columns),
            .of = NoteOf::kSites,
            .width = width,
            .numbers = std::move(rows)};
}

/// Adds a note a hole, the two vertices of each edge on it.
void add_holes(const plane::Tile& tile, std::vector<NoteTable>& notes) {
    const plane::WallEdge* before = nullptr;
    for (const plane::WallEdge& edge : tile.wall_edges) {
        if (!edge.wall.is_hole()) continue;
        if (before == nullptr || before->wall != edge.wall) {
            notes.push_back({.word = "hole " + wall_name(tile, edge.wall),
                             .n_indices = kSitesALine,
                             .numbers = std::vector<int>()});
        }
        auto& vertices = std::get<std::vector<int>>(notes.back().numbers);
        vertices.insert(vertices.end(), {edge.v0, edge.v1});
        before = &edge;
    }
}

}  // namespace

void SiteNotes::give_to(plane::Tile& tile) && {
    if (!positions.empty() && columns == 0) columns = this->rows = 1;
    tile.columns = columns;
    tile.rows = this->rows;
    tile.short_edges = short_edges;
    tile.metric = metric;
    tile.walls = walls;
    tile.wall_edges = edges_on_walls(tile);
    for (const plane::WallEdge& edge : hole_edges) {
        if (std::max(edge.v0, edge.v1) >= tile.n_vertices()) {
            throw InvalidInput("a hole has an edge at a vertex that does not exist");
        }
    }
    std::sort(hole_edges.begin(), hole_edges.end());
    tile.wall_edges.insert(tile.wall_edges.end(), hole_edges.begin(), hole_edges.end());
    tile.holes = std::move(holes);
    tile.site_positions = std::move(positions);
    tile.site_weights = std::move(weights);
}

void SiteNotes::add_hole_edge(std::string_view name, double v0, double v1) {
    if (name.empty() || kNameLetters.skip_in(name) < name.size()) {
        throw InvalidInput("a hole's name consists of letters, digits, _ and -");
    }
    for (const double v : {v0, v1}) {
        if (v >= 0 && v < kMostHoleVertices && v == std::floor(v)) continue;
        throw InvalidInput("the edge of a hole needs two vertices");
    }
    const auto known = std::find(holes.begin(), holes.end(), name);
    const plane::WallId wall = plane::WallId::hole(static_cast<int>(known - holes.begin()));
    if (known == holes.end()) holes.emplace_back(name);
    hole_edges.push_back({wall, static_cast<int>(v0), static_cast<int>(v1)});
}

std::span<const SiteNote> site_notes() { return rows(); }

const SiteNote* find_site_note(std::string_view comment) {
    const auto found = std::find_if(rows().begin(), rows().end(), [&](const SiteNote& note) {
        return !note.of_each_site && note.comment == comment;
    });
    return found == rows().end() ? nullptr : &*found;
}

std::vector<std::string_view> site_parts() {
    std::vector<std::string_view> parts;
    for (const SiteNote& note : rows()) {
        if (!note.of_each_site) continue;
        std::string_view rest = note.parts;
        for (std::size_t k = 0; k < note.n_parts; ++k) {
            parts.push_back(rest.substr(0, rest.find(' ')));
            rest.remove_prefix(std::min(parts.back().size() + 1, rest.size()));
        }
    }
    return parts;
}

std::vector<StatedNote> stated_notes(const plane::Tile& tile, bool of_arrays) {
    if (site_positions(tile).empty()) return {};
    std::vector<StatedNote> stated;
    for (const SiteNote& note : rows()) {
        std::vector<double> numbers = note.numbers(tile);
        const bool counts = of_arrays && note.always_in_arrays;
        if (counts || numbers != note.usual) stated.push_back({&note, std::move(numbers)});
    }
    return stated;
}

std::vector<NoteTable> note_tables(const plane::Tile& tile) {
    std::vector<NoteTable> notes;
    std::vector<StatedNote> stated = stated_notes(tile);
    for (StatedNote& note : stated) {
        if (note.note->of_each_site) continue;
        notes.push_back({.word = std::string(note.note->comment),
                         .width = note.note->n_parts,
                         .numbers = std::move(note.numbers)});
    }
    if (NoteTable sites = site_table(stated); !sites.reals().empty())
        notes.push_back(std::move(sites));
    add_holes(tile, notes);
    return notes;
}

void append_note_comments(std::string& text, std::string_view mark, const plane::Tile& tile,
                          int index_base) {
    for (const NoteTable& note : note_tables(tile)) append_note(text, mark, note, index_base);
}

void append_note_meanings(std::string& text, std::string_view mark) {
    std::string of_site = "site";
    for (const SiteNote& note : rows()) {
        const std::string key = note.of_each_site ? of_site : std::string(note.comment);
        std::string form = key + " " + std::string(note.parts);
        if (note.of_each_site) of_site = form;
        form.resize(std::max(form.size() + 1, kMeaningColumn), ' ');
        text += std::string(mark) + form + note.meaning + "\n";
    }
}

void take_note(const SiteNote& note, std::span<const double> numbers, SiteNotes& notes) {
    const bool is_whole =
        note.of_each_site ? numbers.size() % note.n_parts == 0 : numbers.size() == note.n_parts;
    const bool fits = !note.of_integers || std::all_of(numbers.begin(), numbers.end(),
                                                       [](double n) { return n == std::floor(n); });
    if (!is_whole || !fits) {
        throw InvalidInput("the note " + std::string(note.comment) + " is unclear; write its " +
                           (note.of_integers ? "integers: " : "numbers: ") +
                           std::string(note.parts));
    }
    note.take(numbers, notes);
}

void take_site_note(std::span<const double> numbers, SiteNotes& notes) {
    if (numbers.empty()) throw InvalidInput("a site lacks its numbers; write x and y");
    for (const SiteNote& note : rows()) {
        if (!note.of_each_site || numbers.empty()) continue;
        const std::size_t n = std::min(numbers.size(), note.n_parts);
        take_note(note, numbers.first(n), notes);
        numbers = numbers.subspan(n);
    }
    if (!numbers.empty()) throw InvalidInput("a site has more numbers than x, y and weight");
}

void take_hole_note(std::string_view name, std::span<const double> numbers, SiteNotes& notes) {
    if (numbers.empty() || numbers.size() % 2 != 0) {
        throw InvalidInput("the note hole is unclear; write a name and two vertices an edge");
    }
    for (std::size_t k = 0; k < numbers.size(); k += 2) {
        notes.add_hole_edge(name, numbers[k], numbers[k + 1]);
    }
}

bool same_site_notes(const plane::Tile& file, const plane::Tile& tile) {
    if (file.holes != tile.holes) return false;
    if (!tile.holes.empty() && file.wall_edges != tile.wall_edges) return false;
    if (file.site_positions.empty()) return true;
    return std::all_of(rows().begin(), rows().end(), [&](const SiteNote& note) {
        return note.numbers(file) == note.numbers(tile);
    });
}

}  // namespace pcvt
