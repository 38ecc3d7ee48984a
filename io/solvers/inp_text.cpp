#include "io/solvers/inp_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/solvers/fixed_width_numbers.hpp"
#include "io/solvers/inp_fields.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "mesher/cells/set_names.hpp"

namespace pcvt {
namespace {

constexpr std::size_t kIdsALine = 8;
/// Solvers read no more terms of an equation in a line.
constexpr int kTermsALine = 4;

/// Returns the largest absolute value of a coordinate or of a component of a translation.
double largest_number(const InpForm& form) {
    double largest = 0;
    for (const std::array<double, 3>& p : form.mesh.nodes) {
        for (const double x : p) largest = std::max(largest, std::abs(x));
    }
    for (const InpTie& tie : form.ties) {
        for (const double x : tie.translation) largest = std::max(largest, std::abs(x));
    }
    return largest;
}

/// Builds the text of one file, card by card.
class InpText {
   public:
    InpText(const InpForm& form, const std::string& path)
        : form_(form),
          dimension_(form.mesh.dimension),
          path_(path),
          numbers_(largest_number(form)) {}

    std::string write() {
        append_comments();
        append_nodes();
        append_elements();
        for (const InpSet& cell : form_.cells) append_set("*ELSET,ELSET=", cell);
        text_ += form_.orbits;
        for (const InpSet& set : form_.node_sets) append_set("*NSET,NSET=", set);
        if (form_.is_strained) text_ += "*NSET,NSET=" + upper_case(kFixedSet) + "\n1\n";
        append_surfaces();
        append_equations();
        text_ += form_.job;
        return std::move(text_);
    }

   private:
    /// The number of control node k, which counts from 1.
    int control(int k) const { return form_.mesh.n_nodes() + k; }

    void append_real(double value) {
        if (numbers_.append(text_, value)) return;
        throw InvalidInput(
            path_ +
            ": solvers read 20 characters of a number there, too few for this tile; "
            "choose a unit of length in which its coordinates lie between 0.1 and 1e6");
    }

    void append_comments() {
        text_ = form_.explanation + "** pcvt kind " + form_.kind + "\n** pcvt lattice";
        for (const double number : form_.mesh.periods) {
            text_ += ' ';
            append_number(text_, number);
        }
        text_ += '\n' + form_.notes;
    }

    void append_node(int number, const std::array<double, 3>& p) {
        append_number(text_, number);
        for (int k = 0; k < dimension_; ++k) {
            text_ += ',';
            append_real(p[k]);
        }
        text_ += dimension_ == 2 ? ",0\n" : "\n";
    }

    void append_nodes() {
        text_ += "*NODE,NSET=" + upper_case(kAllNodesSet) + "\n";
        for (int v = 0; v < form_.mesh.n_nodes(); ++v) {
            checkpoint_each(v);
            append_node(v + 1, form_.mesh.nodes[v]);
        }
        if (!form_.is_strained) return;
        for (int k = 1; k <= dimension_; ++k) {
            text_ += "*NODE,NSET=" + upper_case(kControlSet) + std::to_string(k) + "\n";
            append_node(control(k), form_.mesh.nodes.front());
        }
    }

    void append_elements() {
        text_ += "*ELEMENT,TYPE=" + form_.element + ",ELSET=" + upper_case(kAllElementsSet) + "\n";
        const ElementList& elements = form_.mesh.elements;
        for (int e = 0; e < elements.size(); ++e) {
            checkpoint_each(e);
            append_number(text_, e + 1);
            for (const int v : elements.nodes[e]) {
                text_ += ',';
                append_number(text_, v + 1);
            }
            text_ += '\n';
        }
    }

    void append_set(const char* card, const InpSet& set) {
        const std::vector<int>& members = set.members;
        if (members.empty()) return;
        text_ += card + set.name + (set.is_ordered ? ",UNSORTED\n" : "\n");
        for (std::size_t k = 0; k < members.size(); ++k) {
            append_number(text_, members[k] + 1);
            text_ += (k + 1) % kIdsALine == 0 || k + 1 == members.size() ? '\n' : ',';
        }
    }

    void append_surfaces() {
        for (const InpSurface& surface : form_.surfaces) {
            if (surface.sides.empty()) continue;
            text_ += "*SURFACE,NAME=" + surface.name + ",TYPE=ELEMENT\n";
            for (const auto& [element, side] : surface.sides) {
                append_number(text_, element + 1);
                text_ += ",S" + std::to_string(side) + "\n";
            }
        }
    }

    /// Appends `node,dof,coefficient` as term k, which counts from 0.
    void append_term(int k, int node, int dof, double coefficient) {
        if (k > 0) text_ += k % kTermsALine == 0 ? '\n' : ',';
        append_number(text_, node);
        text_ += "," + std::to_string(dof) + ",";
        append_real(coefficient);
    }

    void append_equation(const InpTie& tie, int i) {
        text_ += std::to_string(2 + dimension_) + "\n";
        append_term(0, tie.node + 1, i, 1);
        append_term(1, tie.representative + 1, i, -1);
        for (int j = 1; j <= dimension_; ++j) {
            append_term(1 + j, control(std::min(i, j)), std::max(i, j), -tie.translation[j - 1]);
        }
        text_ += '\n';
    }

    void append_equations() {
        if (!form_.is_strained) return;
        text_ += "*EQUATION\n";
        for (const InpTie& tie : form_.ties) {
            checkpoint_each(tie.node);
            for (int i = 1; i <= dimension_; ++i) append_equation(tie, i);
        }
    }

    const InpForm& form_;
    const int dimension_;
    const std::string& path_;
    FixedWidthNumbers numbers_;
    std::string text_;
};

}  // namespace

std::string inp_text(const InpForm& form, const std::string& path) {
    return InpText(form, path).write();
}

}  // namespace pcvt
