#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesher/plane/tile/tile.hpp"

namespace pcvt {

struct NoteTable;

/// The notes that a file holds on the sites of its tile, by which the file proves its site ids
/// without other files.
///
/// Example usage, of a writer and of a reader:
///   append_note_comments(text, "# pcvt ", tile, 1);
///   for (const StatedNote& stated : stated_notes(tile)) write(stated.note->array, stated.numbers);
///
///   SiteNotes notes;
///   take_note(*find_site_note("metric"), std::array{3.0, 30.0}, notes);
///   std::move(notes).give_to(tile);
struct SiteNotes {
    /// As the members of Tile with these names.
    int columns = 0;
    int rows = 0;
    double short_edges = 1;
    plane::Metric metric = {};
    Walls walls = Walls::kNone;
    /// Tile::site_positions and Tile::site_weights.
    std::vector<plane::Vec2> positions = {};
    std::vector<double> weights = {};
    /// Tile::holes, and the edges on them among Tile::wall_edges.
    std::vector<std::string> holes = {};
    std::vector<plane::WallEdge> hole_edges = {};

    /// Adds an edge of a hole, which may be new.
    /// @throws InvalidInput if the name has other characters than letters, digits, _ and -, or a
    ///         vertex is negative or too large for a mesh.
    void add_hole_edge(std::string_view name, double v0, double v1);
    /// Gives all quantities to a tile, which has its points and faces; positions without numbers of
    /// periods cover one.
    /// @throws InvalidInput if the edge of a hole ends at a vertex that does not exist.
    void give_to(plane::Tile& tile) &&;
};

/// One quantity in all formats: a row of the table of notes on sites. The next quantity
/// needs a member of SiteNotes, a row, and a property of OpenMesh (openmesh_properties.hpp).
struct SiteNote {
    /// The names of its numbers, of a site or of the tile: "x y". PLY has a property for each.
    std::string_view parts;
    std::size_t n_parts;
    /// The key of its comment; quantities of each site share the comments `site`.
    std::string_view comment;
    /// Its member of extras.periodic in glTF: a number, a list, or the accessor of each site.
    std::string_view member;
    /// Its array among the field data of VTK.
    std::string_view array;
    /// Its property of a mesh of OpenMesh; empty: "pcvt_sites" holds it.
    std::string_view property;
    /// The line that explains it to a reader of the file.
    const char* meaning;
    /// The numbers of a tile; of each site those of site 0, then site 1, ...
    std::vector<double> (*numbers)(const plane::Tile& tile);
    /// Stores the numbers, whose count is valid. @throws InvalidInput if one is out of range.
    void (*take)(std::span<const double> numbers, SiteNotes& notes);
    /// The numbers of most tiles, which a file does not state.
    std::vector<double> usual = {};
    bool of_each_site = false;
    bool of_integers = false;
    /// VTK files state the usual numbers, too.
    bool always_in_arrays = false;
};

/// The order of the rows is that in files; quantities of each site follow those of the tile.
std::span<const SiteNote> site_notes();

/// The note of the tile with this key; nullptr if there is none.
const SiteNote* find_site_note(std::string_view comment);

/// The names of the numbers of a site: "x", "y", "weight".
std::vector<std::string_view> site_parts();

/// A note with its numbers.
struct StatedNote {
    const SiteNote* note;
    std::vector<double> numbers;
};

/// Returns the notes that a file of the tile states: none where the tile does not have the
/// positions of its sites (mesher/plane/tile/site_positions.hpp).
/// @param of_arrays  whether SiteNote::always_in_arrays counts.
std::vector<StatedNote> stated_notes(const plane::Tile& tile, bool of_arrays = false);

/// Returns the notes as tables: those of the tile, `site` with a row a site, and `hole NAME` for
/// each hole, with the two vertices of each edge on it.
std::vector<NoteTable> note_tables(const plane::Tile& tile);

/// Appends all notes as lines of text: `MARKmetric 3 30`, one `MARKsite x y weight` a site, and
/// `MARKhole NAME v0 v1 v2 v3 ...`.
/// @param index_base  the number of the first vertex.
void append_note_comments(std::string& text, std::string_view mark, const plane::Tile& tile,
                          int index_base);

/// Appends one line a note that explains its comment to a reader of the file.
void append_note_meanings(std::string& text, std::string_view mark);

/// Takes the numbers of a note, those of more sites after those before.
/// @throws InvalidInput with a complaint if these are too few, too many or out of range.
void take_note(const SiteNote& note, std::span<const double> numbers, SiteNotes& notes);

/// Takes the numbers of a comment `site`: those of one site, of one note after the other.
/// @throws InvalidInput as take_note().
void take_site_note(std::span<const double> numbers, SiteNotes& notes);

/// Takes the words of a comment `hole`.
/// @param numbers  those after the name, less the index base.
/// @throws InvalidInput as SiteNotes::add_hole_edge(), or if there is a number too many.
void take_hole_note(std::string_view name, std::span<const double> numbers, SiteNotes& notes);

/// Whether both tiles have the same notes; true of a file without positions of sites. Both have the
/// same edges of holes in any case.
bool same_site_notes(const plane::Tile& file, const plane::Tile& tile);

}  // namespace pcvt
