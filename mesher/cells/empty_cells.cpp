#include "mesher/cells/empty_cells.hpp"

#include <string>
#include <utility>

namespace pcvt {
namespace {

std::string names_of_empty_cells(const std::vector<int>& sites) {
    const std::string first = "site " + std::to_string(sites.front());
    const std::string remedy =
        " too small beside those of the neighbours; leave such sites out, or give larger weights";
    if (sites.size() == 1) {
        return "the cell of " + first + " is empty, because its weight is" + remedy;
    }
    return "the cells of " + std::to_string(sites.size()) +
           (sites.size() == EmptyCells::kMostNamed ? " sites or more" : " sites") +
           " are empty, the first that of " + first + ", because their weights are" + remedy;
}

}  // namespace

EmptyCells::EmptyCells(std::vector<int> sites)
    : InvalidInput(names_of_empty_cells(sites)), sites_(std::move(sites)) {}

TinyCell::TinyCell(int site, const std::string& remedy)
    : InvalidInput("the cell of site " + std::to_string(site) +
                   " is smaller than 1e-9 of the spacing: " + remedy),
      site_(site) {}

}  // namespace pcvt
