#pragma once

#include <stdexcept>
#include <string>

namespace pcvt {

/// Base of every exception that pcvt throws on purpose.
class Error : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
};

/// The caller can mend it: an argument, a file or a lattice outside of what is stated.
class InvalidInput : public Error {
   public:
    using Error::Error;
};

/// Two sites lie on one orbit of the lattice. Ids are the order of the input, from 0.
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

/// The task is larger than pcvt, or its integers, can hold.
class LimitExceeded : public Error {
   public:
    using Error::Error;
};

/// A law of the library does not hold: a fault of pcvt, never of its user.
class InternalError : public Error {
   public:
    using Error::Error;
};

}  // namespace pcvt
