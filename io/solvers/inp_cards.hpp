#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/bytes/text.hpp"

namespace pcvt {

/// An equation of an input: the sum of coefficient x displacement over its terms is 0.
struct InpEquation {
    struct Term {
        int node;
        int direction;
        double coefficient;
    };
    int line;
    std::vector<Term> terms;
};

/// Parses the cards of an Abaqus or CalculiX input that a mesh needs, and hands their items to a
/// derived class: nodes, elements, the sets CELL_s, equations, and the comments of pcvt.
///
/// Example usage:
///     class NodeCounter final : public InpCards {
///         void take_node(int, const Position&) override { ++n; }
///     };
class InpCards {
   public:
    using Words = std::vector<std::string_view>;
    using Position = std::array<double, 3>;

    /// @param text  must outlive this object.
    InpCards(const std::string& name, std::string_view text) : name_(name), scanner_(name, text) {}
    virtual ~InpCards() = default;
    InpCards(const InpCards&) = delete;
    InpCards& operator=(const InpCards&) = delete;

    /// Parses all cards; others are skipped.
    /// @throws BadFile with the line.
    void parse();

   protected:
    const std::string& name() const { return name_; }
    const LineScanner& scanner() const { return scanner_; }
    const std::vector<InpEquation>& equations() const { return equations_; }
    /// The number of control node k + 1, if the file has it.
    const std::optional<int>& control(std::size_t k) const { return controls_[k]; }
    bool is_control(int node) const;

    [[noreturn]] void throw_bad_file(int line, const std::string& complaint) const;

   private:
    /// A comment "** pcvt KEY VALUE ...".
    virtual void take_comment(std::string_view key, const Words& values) = 0;
    virtual void take_node(int number, const Position& position) = 0;
    /// Returns the number of nodes of elements of a type; refuses others.
    virtual std::size_t n_element_nodes(const std::string& type) = 0;
    virtual void take_element(int number, std::vector<int> nodes) = 0;
    virtual void take_cell_member(int element, int cell) = 0;

    using Handler = void (InpCards::*)(const Words& fields);

    void parse_line();
    void parse_card(const Words& fields);
    void require_fields(const Words& fields, std::size_t least, std::size_t most) const;
    void parse_node(const Words& fields);
    void parse_element(const Words& fields);
    void parse_cell(const Words& fields);
    void parse_equation(const Words& fields);

    std::string name_;
    LineScanner scanner_;
    Handler handler_ = nullptr;
    /// The name of the set that the current card fills; empty if it has none.
    std::string set_;
    std::size_t n_element_nodes_ = 0;
    std::array<std::optional<int>, 3> controls_;
    std::vector<InpEquation> equations_;
    int n_pending_ = 0;
};

}  // namespace pcvt
