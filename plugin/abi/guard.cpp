#include "plugin/abi/guard.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string_view>

#include "io/bytes/output_error.hpp"
#include "mesher/cells/empty_cells.hpp"
#include "mesher/finite_volume/mpas_grid.hpp"
#include "mesher/plane/density/density.hpp"
#include "plugin/job/features.hpp"

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

/// The name of an option as hosts know it: its field, or else the option without its hyphens.
std::string_view field_name(std::string_view option, std::array<char, kLongestText>& room) {
    const FeatureRow* const feature = find_option(option);
    if (feature != nullptr && !feature->fields.empty() &&
        feature->fields.find(' ') == std::string_view::npos) {
        return feature->fields;
    }
    option.remove_prefix(2);
    std::replace_copy(option.begin(), option.end(), room.begin(), '-', '_');
    return {room.data(), option.size()};
}

/// The option of the command that names an output; hosts give the path as an argument.
constexpr std::string_view kOutputOption = "-o ";

/// Calls append_part(part) for each part of a text in which the names of options are replaced:
/// --wall-cells by wall_cells, --size by grain_size, "-o tile.obj: ..." by "tile.obj: ...".
template <class AppendPart>
void append_in_fields(std::string_view text, const AppendPart& append_part) {
    if (text.substr(0, kOutputOption.size()) == kOutputOption) {
        text.remove_prefix(kOutputOption.size());
    }
    std::array<char, kLongestText> room;
    for (std::size_t k = 0; k < text.size();) {
        const bool begins = text.substr(k, 2) == "--" && (k == 0 || text[k - 1] == ' ');
        const std::size_t end =
            begins ? std::min(text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", k), text.size())
                   : k + 1;
        const std::string_view part = text.substr(k, end - k);
        append_part(begins ? field_name(part, room) : part);
        k = end;
    }
}

/// The same for the message of this thread, without an allocation.
void name_fields() {
    std::array<char, kLongestText> result;
    std::size_t n = 0;
    append_in_fields(text_of_thread, [&](std::string_view part) {
        part = part.substr(0, std::min(part.size(), kLongestText - 1 - n));
        std::copy(part.begin(), part.end(), result.begin() + static_cast<std::ptrdiff_t>(n));
        n += part.size();
    });
    result[n] = '\0';
    std::memcpy(text_of_thread, result.data(), n + 1);
}

/// Notes a message that names options of a job.
pcvt_status note_job(pcvt_status status, const char* text) {
    note(status, text);
    name_fields();
    return status;
}

}  // namespace

const char* last_error() { return text_of_thread; }

void set_last_error(const char* text) {
    const std::size_t length = append(0, text);
    std::replace(text_of_thread, text_of_thread + length, '\n', ' ');
}

std::string in_fields(const std::string& message) {
    std::string text;
    append_in_fields(message, [&](std::string_view part) { text += part; });
    return text;
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
        return note_job(PCVT_ERROR_GEOMETRY, error.what());
    } catch (const DuplicateSites& error) {
        return note(PCVT_ERROR_GEOMETRY, error.what());
    } catch (const EmptyCells& error) {
        return note(PCVT_ERROR_GEOMETRY, error.what());
    } catch (const UnsuitableCells& error) {
        return note_job(PCVT_ERROR_GEOMETRY, error.what());
    } catch (const InvalidInput& error) {
        return note_job(PCVT_ERROR_ARGUMENT, error.what());
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
