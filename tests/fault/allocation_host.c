/* A host of the C interface whose allocations fail, one after the other.
 *
 *     allocation_host cold|warm once|for-ever FIRST STEP      in an empty folder
 *
 * cold: each allocation fails in a process that has not called the library before. warm: all
 * allocations fail in one process, which must not lose a block of memory by them. Each failure is
 * followed by the same calls with memory, whose results and files must have the bytes of a run
 * without failures.
 *
 * Writes one line: the number of allocations, of runs, and of the runs that ended with each status.
 */
#include <dirent.h>
#include <pcvt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/fault/allocation_shim.h"

/* A block that stays once is looked for by repeating its failure; more than a few are a leak. */
enum { REPETITIONS = 3, MOST_KEPT = 2 };

enum { N_SITES = 50, N_SITES_IN_SPACE = 6, N_STATUSES = 11, LOWEST_STATUS = -7 };

/* The files that the host writes, and the kind of tile in them. */
static const struct {
    const char* path;
    int32_t kind;
} outputs[] = {{"a.obj", PCVT_DELAUNAY}, {"a.ply", PCVT_VORONOI}, {"a.glb", PCVT_VORONOI},
               {"a.gltf", PCVT_GRAINS},  {"a.om", PCVT_DELAUNAY}, {"a.msh", PCVT_GRAINS},
               {"a.inp", PCVT_DELAUNAY}, {"a.vtu", PCVT_VORONOI}, {"a.svg", PCVT_VORONOI},
               {"a.png", PCVT_VORONOI},  {"a.dxf", PCVT_VORONOI}, {"a.html", PCVT_DELAUNAY},
               {"a.foam", PCVT_VORONOI}, {"a.vti", PCVT_VORONOI}, {"a.csv", PCVT_VORONOI},
               {"a.txt", PCVT_VORONOI}};
enum { N_OUTPUTS = sizeof outputs / sizeof outputs[0] };

typedef unsigned long long hash_number;

static hash_number mix(hash_number hash, const void* data, size_t size) {
    const unsigned char* bytes = data;
    size_t k;
    for (k = 0; k < size; ++k) hash = (hash ^ bytes[k]) * 1099511628211ULL;
    return hash;
}

static void stop(const char* what, const char* detail) {
    fprintf(stderr, "allocation_host: %s: %s\n", what, detail);
    exit(1);
}

static int keep_running(const pcvt_progress* progress, void* data) {
    (void)progress;
    (void)data;
    return 0;
}

/* Mixes every file below a folder, in any order. Hidden files are left temporaries. */
static hash_number mix_folder(const char* folder) {
    hash_number sum = 0;
    DIR* open = opendir(folder);
    struct dirent* entry;
    while ((entry = readdir(open)) != NULL) {
        char path[1024];
        static char bytes[1 << 20];
        FILE* file;
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0) continue;
        if (entry->d_name[0] == '.') stop("a temporary file is left", entry->d_name);
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        if (entry->d_type == DT_DIR) {
            sum += mix_folder(path);
            continue;
        }
        file = fopen(path, "rb");
        sum += mix(mix(14695981039346656037ULL, path, strlen(path)), bytes,
                   fread(bytes, 1, sizeof bytes, file));
        fclose(file);
    }
    closedir(open);
    return sum;
}

/* Takes every view of a result and writes every file. */
static pcvt_status use_result(const pcvt_result* result, hash_number* hash) {
    pcvt_sites sites;
    pcvt_statistics statistics;
    pcvt_mesh mesh;
    pcvt_tile tile;
    pcvt_status status;
    int32_t kind;
    size_t k;
    if ((status = pcvt_get_sites(result, &sites, sizeof sites)) < 0) return status;
    *hash = mix(*hash, sites.points, 2 * sizeof(double) * N_SITES);
    if ((status = pcvt_get_statistics(result, &statistics, sizeof statistics)) < 0) return status;
    *hash = mix(*hash, &statistics.energy, sizeof statistics.energy);
    if ((status = pcvt_get_minimum(result, &kind)) < 0) return status;
    *hash = mix(*hash, &kind, sizeof kind);
    for (kind = PCVT_VORONOI; kind <= PCVT_DELAUNAY; ++kind) {
        if ((status = pcvt_get_mesh(result, kind, &mesh, sizeof mesh)) < 0) return status;
        *hash = mix(*hash, mesh.opposite, sizeof(int32_t) * mesh.n_corners);
    }
    for (kind = PCVT_VORONOI; kind <= PCVT_GRAINS; ++kind) {
        status = pcvt_get_tile(result, kind, kind == PCVT_DELAUNAY ? PCVT_WHOLE : PCVT_BOX, &tile,
                               sizeof tile);
        if (status < 0) return status;
        *hash = mix(*hash, tile.points, 2 * sizeof(double) * tile.n_vertices);
        *hash = mix(*hash, tile.edge_pairs, sizeof(pcvt_edge_pair) * tile.n_edge_pairs);
    }
    for (k = 0; k < N_OUTPUTS; ++k) {
        pcvt_write_options options;
        memset(&options, 0, sizeof options);
        options.struct_size = sizeof options;
        options.kind = outputs[k].kind;
        options.replace = 1;
        options.pixels = strcmp(outputs[k].path, "a.png") == 0 ? 64 : 0;
        if (strcmp(outputs[k].path, "a.vti") == 0) options.voxels[0] = options.voxels[1] = 16;
        options.progress = keep_running;
        if ((status = pcvt_write(result, outputs[k].path, &options)) < 0) return status;
    }
    return PCVT_OK;
}

/* Takes the views of a result in three dimensions and writes its files. */
static pcvt_status use_cells(const pcvt_result* result, hash_number* hash) {
    static const char* const paths[] = {"b.vtu", "b.foam", "b.msh", "b.obj",
                                        "b.ply", "b.glb",  "b.txt"};
    pcvt_cells cells;
    pcvt_statistics statistics;
    pcvt_status status;
    size_t k;
    if ((status = pcvt_get_cells(result, &cells, sizeof cells)) < 0) return status;
    *hash = mix(*hash, cells.points, 3 * sizeof(double) * cells.n_points);
    *hash = mix(*hash, cells.partner, sizeof(int32_t) * (cells.n_faces - cells.n_inner_faces));
    *hash = mix(*hash, cells.volumes, sizeof(double) * cells.n_cells);
    if ((status = pcvt_get_statistics(result, &statistics, sizeof statistics)) < 0) return status;
    *hash = mix(*hash, statistics.valences, sizeof(int32_t) * statistics.n_valences);
    for (k = 0; k < sizeof paths / sizeof paths[0]; ++k) {
        pcvt_write_options options;
        memset(&options, 0, sizeof options);
        options.struct_size = sizeof options;
        options.replace = 1;
        options.progress = keep_running;
        if ((status = pcvt_write(result, paths[k], &options)) < 0) return status;
    }
    return PCVT_OK;
}

static pcvt_status run_in_space(pcvt_options options, hash_number* hash) {
    pcvt_result* result;
    pcvt_status status;
    options.dimension = 3;
    options.n_sites = N_SITES_IN_SPACE;
    options.lattice3[4] = 2;
    status = pcvt_generate(&options, &result);
    if (status >= 0) status = use_cells(result, hash);
    pcvt_free(result);
    return status;
}

/* Proves files of the runs before. */
static pcvt_status prove_files(hash_number* hash) {
    static const char* const paths[] = {"a.obj", "a.glb", "a.vti", "b.vtu"};
    pcvt_check_options options;
    size_t k;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.progress = keep_running;
    for (k = 0; k < sizeof paths / sizeof paths[0]; ++k) {
        pcvt_proof* proof;
        const pcvt_status status = pcvt_check(paths[k], &options, &proof);
        if (status < 0) return status;
        *hash = mix(*hash, pcvt_proof_text(proof), strlen(pcvt_proof_text(proof)));
        pcvt_free_proof(proof);
    }
    return PCVT_OK;
}

/* Makes a study with its files. */
static pcvt_status make_study(hash_number* hash) {
    const int32_t n = 4;
    pcvt_study_options options;
    pcvt_study_result* study;
    pcvt_study_contents contents;
    pcvt_status status =
        pcvt_study_options_init(&options, sizeof options, PCVT_ABI_VERSION, "fig11");
    if (status < 0) return status;
    options.sites = &n;
    options.n_sites = options.runs = options.n_threads = options.replace = 1;
    options.path = "study/";
    options.progress = keep_running;
    status = pcvt_study(&options, &study);
    if (status >= 0) status = pcvt_get_study_contents(study, &contents, sizeof contents);
    if (status >= 0) *hash = mix(*hash, contents.text, strlen(contents.text));
    pcvt_free_study(study);
    return status;
}

static pcvt_status whole_run(hash_number* hash) {
    pcvt_options options;
    pcvt_result* result;
    pcvt_status status = pcvt_options_init(&options, sizeof options, PCVT_ABI_VERSION);
    if (status < 0) return status;
    options.n_sites = N_SITES;
    options.n_threads = 1;
    options.progress = keep_running;
    status = pcvt_generate(&options, &result);
    *hash = 14695981039346656037ULL;
    if (status >= 0) status = use_result(result, hash);
    pcvt_free(result);
    if (status >= 0) status = run_in_space(options, hash);
    if (status >= 0) status = prove_files(hash);
    return status >= 0 ? make_study(hash) : status;
}

/* One run with failures and one without, which must have the hashes of the reference. */
static pcvt_status fail_and_repeat(long allocation, int for_ever, const hash_number* reference) {
    hash_number hash;
    pcvt_status failed;
    char name[32];
    snprintf(name, sizeof name, "allocation %ld", allocation);
    fault_arm(allocation, for_ever);
    failed = whole_run(&hash);
    fault_arm(0, 0);
    if (failed >= 0 && (hash != reference[0] || mix_folder(".") != reference[1])) {
        stop(name, "a run that succeeded differs");
    }
    if (failed < 0 && failed != PCVT_ERROR_MEMORY) stop(name, pcvt_last_error());
    if (whole_run(&hash) < 0) stop(name, pcvt_last_error());
    if (hash != reference[0] || mix_folder(".") != reference[1])
        stop(name, "the run after it differs");
    return failed;
}

/* Runs in a child, which has not called the library. */
static pcvt_status in_child(long allocation, int for_ever, const hash_number* reference) {
    int state;
    const pid_t child = fork();
    if (child == 0) _exit(fail_and_repeat(allocation, for_ever, reference) - LOWEST_STATUS + 100);
    waitpid(child, &state, 0);
    if (WIFEXITED(state) && WEXITSTATUS(state) >= 100)
        return WEXITSTATUS(state) - 100 + LOWEST_STATUS;
    {
        char text[100];
        snprintf(text, sizeof text, "allocation %ld: wait status 0x%x", allocation,
                 (unsigned)state);
        stop("the library ends its host", text);
    }
    return 0;
}

/* Runs a first time in a child: hashes and number of allocations. */
static void reference_of_child(hash_number* reference, long* n) {
    int ends[2];
    int state;
    if (pipe(ends) != 0) stop("pipe", "failed");
    if (fork() == 0) {
        fault_arm(0, 0);
        if (whole_run(&reference[0]) < 0) stop("the run without failures", pcvt_last_error());
        *n = fault_allocations();
        reference[1] = mix_folder(".");
        if (write(ends[1], reference, 16) != 16 || write(ends[1], n, sizeof *n) < 0) _exit(1);
        _exit(0);
    }
    wait(&state);
    if (state != 0) exit(1);
    if (read(ends[0], reference, 16) != 16 || read(ends[0], n, sizeof *n) < 0) exit(1);
}

/* Stops if the failure has lost a block. A leak loses blocks at each repetition; a block that the
 * system keeps for later calls stays once. */
static void require_no_leak(long allocation, int for_ever, const hash_number* reference,
                            long* blocks, int* n_kept) {
    const long lost = fault_live_blocks() - *blocks;
    int repetition;
    if (lost == 0) return;
    *blocks += lost;
    for (repetition = 0; repetition < REPETITIONS; ++repetition)
        fail_and_repeat(allocation, for_ever, reference);
    if (fault_live_blocks() != *blocks || ++*n_kept > MOST_KEPT) {
        char text[80];
        snprintf(text, sizeof text, "allocation %ld leaves %ld blocks", allocation, lost);
        stop("leak", text);
    }
}

int main(int argc, char** argv) {
    hash_number reference[2];
    long n = 0;
    long k;
    long runs = 0;
    long blocks = 0;
    int n_kept = 0;
    long ends[N_STATUSES] = {0};
    const int cold = argc == 5 && strcmp(argv[1], "cold") == 0;
    const int for_ever = argc == 5 && strcmp(argv[2], "for-ever") == 0;
    const long step = argc == 5 ? atol(argv[4]) : 0;
    if (step < 1) stop("usage", "allocation_host cold|warm once|for-ever FIRST STEP");
    reference_of_child(reference, &n);
    if (!cold) {
        hash_number hash;
        whole_run(&hash);
        whole_run(&hash);
        fault_arm(0, 0);
        blocks = fault_live_blocks();
        whole_run(&hash);
        n = fault_allocations();
        if (fault_live_blocks() != blocks) stop("leak", "a run without failures keeps blocks");
    }
    for (k = atol(argv[3]); k <= n; k += step) {
        const pcvt_status status =
            cold ? in_child(k, for_ever, reference) : fail_and_repeat(k, for_ever, reference);
        ++ends[status - LOWEST_STATUS];
        ++runs;
        if (!cold) require_no_leak(k, for_ever, reference, &blocks, &n_kept);
    }
    printf("%ld %ld", n, runs);
    for (k = 0; k < N_STATUSES; ++k) {
        if (ends[k] > 0) printf(" %ld:%ld", k + LOWEST_STATUS, ends[k]);
    }
    printf("\n");
    return 0;
}
