#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace pcvt {

/// Base of every exception that pcvt throws on purpose. Its message is one line of printable
/// characters, whatever input it quotes: a line end or a tab becomes a blank, another control
/// character a question mark.
///
/// Example usage:
///
///     try {
///         const Sites sites(lattice, points);
///     } catch (const InvalidInput& error) {
///         std::cerr << error.what() << '\n';  // the caller can correct the input
///     }
class Error : public std::runtime_error {
   public:
    explicit Error(std::string what);
};

/// The caller can correct the cause: an argument, a file or a lattice violates a documented
/// condition.
class InvalidInput : public Error {
   public:
    using Error::Error;
};

/// A site that coincides with an earlier one. Ids number the sites of the input from 0.
struct CoincidentSite {
    int site;
    int earlier;

    friend bool operator==(const CoincidentSite&, const CoincidentSite&) = default;
};

/// Lists coincident sites in words, "line 9 with line 3, line 12 with line 3 and 7 more"; of more
/// than a thousand, the first thousand.
/// @param name  the name of a site: "line 9".
std::string coincidence_list(const std::vector<CoincidentSite>& pairs,
                             const std::function<std::string(int)>& name);

/// Sites coincide modulo the lattice.
class DuplicateSites : public InvalidInput {
   public:
    DuplicateSites(int first, int second) : DuplicateSites({{second, first}}) {}
    /// @pre there is at least one pair.
    explicit DuplicateSites(std::vector<CoincidentSite> pairs);

    const std::vector<CoincidentSite>& pairs() const { return pairs_; }
    /// The sites of the first pair, the earlier one first.
    int first() const { return pairs_.front().earlier; }
    int second() const { return pairs_.front().site; }

   private:
    std::vector<CoincidentSite> pairs_;
};

/// The problem is too large for pcvt or for its integer types.
class LimitExceeded : public Error {
   public:
    using Error::Error;
};

/// An invariant of the library does not hold: a bug in pcvt, not an error of its user.
class InternalError : public Error {
   public:
    using Error::Error;
};

}  // namespace pcvt
