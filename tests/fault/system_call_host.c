/* A host of the C interface: replaces an OBJ with its companions, and a report in another folder.
 *
 *     system_call_host SEED     ends with the exit code that the command has for the worst status
 */
#include <pcvt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int exit_code(pcvt_status status) {
    if (status >= 0) return 0;
    fprintf(stderr, "%s\n", pcvt_last_error());
    if (status == PCVT_ERROR_IO) return 3;
    if (status == PCVT_ERROR_MEMORY) return 4;
    return status == PCVT_ERROR_INTERNAL ? 1 : 2;
}

static pcvt_status write_file(const pcvt_result* result, const char* path, const char* report) {
    pcvt_write_options options;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.kind = PCVT_DELAUNAY;
    options.replace = 1;
    options.report = report;
    return pcvt_write(result, path, &options);
}

int main(int argc, char** argv) {
    pcvt_options options;
    pcvt_result* result = NULL;
    int code = exit_code(pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION));
    if (code != 0 || argc != 2) return 1;
    options.n_sites = 30;
    options.n_threads = 1;
    options.seed = (uint64_t)atoi(argv[1]);
    code = exit_code(pcvt_generate(&options, &result));
    if (code == 0) code = exit_code(write_file(result, "out/a.obj", "r.json"));
    pcvt_free(result);
    return code;
}
