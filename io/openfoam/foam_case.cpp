#include "io/openfoam/foam_case.hpp"

#include "io/bytes/text.hpp"

namespace pcvt {

std::string foam_seam_form(Eigen::Index n_periods) {
    std::string form = "seam";
    for (Eigen::Index k = 0; k < n_periods; ++k) form.append("_").append(1, "IJK"[k]);
    return form;
}

std::string foam_kind_note(std::string_view kind) {
    return "// pcvt kind " + std::string(kind) + "\n";
}

std::string foam_notes(std::string_view kind, const Eigen::MatrixXd& periods) {
    std::string text = "// A periodic tile, written by pcvt: " + foam_seam_form(periods.cols()) +
                       " is answered at";
    for (Eigen::Index k = 0; k < periods.cols(); ++k) {
        text.append(" + ").append(1, "IJK"[k]).append(" ").append(1, "abc"[k]);
    }
    text += "\n" + foam_kind_note(kind) + "// pcvt lattice";
    for (const auto& period : periods.colwise()) {
        for (const double number : period) append_number(text += ' ', number);
    }
    return text + "\n";
}

}  // namespace pcvt
