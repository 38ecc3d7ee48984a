#pragma once

#include <stdexcept>
#include <string>

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

/// Two sites coincide modulo the lattice. Ids number the sites of the input from 0.
class DuplicateSites : public InvalidInput {
   public:
    DuplicateSites(int first, int second)
        : InvalidInput("sites " + std::to_string(first) + " and " + std::to_string(second) +
                       " coincide modulo the lattice; remove one"),
          first_(first),
          second_(second) {}
    int first() const { return first_; }
    int second() const { return second_; }

   private:
    int first_;
    int second_;
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
