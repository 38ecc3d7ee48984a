#include "plugin/abi/guard.hpp"

#include <algorithm>
#include <cstring>
#include <new>
#include <stdexcept>

#include "io/bytes/output_error.hpp"
#include "mesher/finite_volume/mpas_grid.hpp"
#include "mesher/plane/density/density.hpp"

namespace pcvt::abi {
namespace {

constexpr std::size_t kLongestText = 1024;

/// Plain bytes: a thread-local object with a destructor would keep the library loaded.
constinit thread_local char text_of_thread[kLongestText] = "";

/// Appends as much of the text as there is room for; returns the length of the whole.
std::size_t append(std::size_t length, const char* text) {
    const std::size_t n = std::min(std::strlen(text), kLongestText - 1 - length);
    std::memcpy(text_of_thread + length, text, n);
    text_of_thread[length + n] = '\0';
    return length + n;
}

pcvt_status note(pcvt_status status, const char* text, const char* advice = "") {
    set_last_error(text);
    append(std::strlen(text_of_thread), advice);
    return status;
}

/// Replaces the names of options by those of fields and arguments: --wall-cells by wall_cells.
void name_fields() {
    const auto belongs = [](char c) { return ('a' <= c && c <= 'z') || c == '-'; };
    const char* from = text_of_thread;
    char* to = text_of_thread;
    for (bool at_word = true; *from != '\0'; ++from) {
        if (!at_word || std::strncmp(from, "--", 2) != 0) {
            at_word = *from == ' ';
            *to++ = *from;
            continue;
        }
        for (from += 2; belongs(*from); ++from) *to++ = *from == '-' ? '_' : *from;
        --from;
        at_word = false;
    }
    *to = '\0';
}

}  // namespace

const char* last_error() { return text_of_thread; }

void set_last_error(const char* text) {
    const std::size_t length = append(0, text);
    std::replace(text_of_thread, text_of_thread + length, '\n', ' ');
}

pcvt_status note_failure(const std::exception_ptr& exception) noexcept {
    try {
        std::rethrow_exception(exception);
    } catch (const AbiMismatch& error) {
        return note(PCVT_ERROR_ABI, error.what());
    } catch (const CallbackFault& error) {
        return note(PCVT_ERROR_DOMAIN, error.what());
    } catch (const plane::BadDensity& error) {
        return note(PCVT_ERROR_DOMAIN, error.what());
    } catch (const BadGeometry& error) {
        return note(PCVT_ERROR_GEOMETRY, error.what());
    } catch (const DuplicateSites& error) {
        return note(PCVT_ERROR_GEOMETRY, error.what());
    } catch (const UnsuitableCells& error) {
        return note(PCVT_ERROR_GEOMETRY, error.what());
    } catch (const InvalidInput& error) {
        note(PCVT_ERROR_ARGUMENT, error.what());
        name_fields();
        return PCVT_ERROR_ARGUMENT;
    } catch (const OutputExists& error) {
        return note(PCVT_ERROR_IO, error.what(), "; set replace");
    } catch (const OutputError& error) {
        return note(PCVT_ERROR_IO, error.what());
    } catch (const LimitExceeded& error) {
        return note(PCVT_ERROR_MEMORY, error.what());
    } catch (const std::bad_alloc&) {
        return note(PCVT_ERROR_MEMORY, "out of memory; take fewer sites or a larger machine");
    } catch (const std::length_error&) {
        return note(PCVT_ERROR_MEMORY, "too large for this machine; take fewer sites");
    } catch (const std::exception& error) {
        return note(PCVT_ERROR_INTERNAL, error.what());
    } catch (...) {
        return note(PCVT_ERROR_INTERNAL, "an unknown exception");
    }
}

}  // namespace pcvt::abi
