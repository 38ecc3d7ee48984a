#pragma once

#include <array>
#include <string>
#include <string_view>

#include "io/forms/element_types.hpp"
#include "io/solvers/msh_rows.hpp"

namespace pcvt {

/// Parses an ASCII MSH 4.1 file as pcvt or Gmsh writes it, one entry per line, and hands its items
/// to a derived class, which reads the words of the current row from rows().
///
/// Example usage:
///     class NodeCounter final : public MshSections {
///         void take_node(int, int, const Position&) override { ++n; }
///     };
class MshSections {
   public:
    using Position = std::array<double, 3>;

    /// @param text  must outlive this object.
    MshSections(const std::string& name, std::string_view text) : name_(name), rows_(name, text) {}
    virtual ~MshSections() = default;
    MshSections(const MshSections&) = delete;
    MshSections& operator=(const MshSections&) = delete;

    /// Parses all sections.
    /// @throws BadFile with the line.
    void parse();

   protected:
    const std::string& name() const { return name_; }
    MshRows& rows() { return rows_; }

   private:
    /// The row is one of $Comments.
    virtual void take_comment() = 0;
    /// Parses a section of another kind up to its last row; returns false to skip it.
    virtual bool take_section(std::string_view /*section*/) { return false; }
    /// @param line  that of the number.
    virtual void take_node(int number, int line, const Position& position) = 0;
    /// All nodes were taken.
    virtual void end_nodes() {}
    /// Returns whether to take the elements of a block; without it they are skipped.
    /// @param type    null: none of kElementTypes.
    /// @param number  Gmsh's number of the type.
    virtual bool takes(const ElementType* type, int number) = 0;
    /// The row holds the number of an element and those of its nodes.
    virtual void take_element(const ElementType& type, int dimension, int entity) = 0;
    /// Returns whether a view of this name states sites; others are skipped.
    virtual bool states_sites(std::string_view view, bool /*of_nodes*/) {
        return view == "cell_id";
    }
    /// Returns whether to take such a view of nodes or elements; without it it is skipped.
    /// @param n_values  the number of its values.
    virtual bool takes_sites(bool of_nodes, int n_values) = 0;
    /// The row holds the number of a node or an element, and its site.
    virtual void take_site(bool of_nodes) = 0;

    void parse_section();
    void parse_format();
    void parse_nodes();
    void parse_elements();
    bool parse_view(bool of_nodes);

    std::string name_;
    MshRows rows_;
};

}  // namespace pcvt
