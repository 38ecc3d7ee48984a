/* A host of the C interface for tests/same_bytes. Its arguments are its steps, in their order:
 *
 *   NAME=VALUE          sets a field of the options of the next runs; arrays have commas between
 *                       their numbers, a pointer without a value is NULL
 *   progress=print      prints each iteration and phase once, when it is first reported;
 *                       progress=sites also the sites; progress=cancel:K cancels at the K-th
 *   density=wave        a callback of the density; also nan, fail
 *   write.NAME=VALUE    sets a field of the options of the next write, progress among them
 *   reset               restores the defaults of both options
 *   generate            runs, prints status, words and message, and keeps the result
 *   views               prints all views of the result
 *   write FILE          writes a file, or only the report for FILE = -
 *   misuse              calls that break the rules, each with its status and message
 *
 * It uses only the header, so that a header of an earlier commit compiles it.
 */
#include <math.h>
#include <pcvt.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "tests/same_bytes_views.h"

enum form { INT32, INT64, SIZE, DOUBLES, NUMBERS, TEXT };

typedef struct field {
    const char* name;
    enum form form;
    size_t offset;
    int count;
} field;

#define OPTION(name, form, count) \
    { #name, form, offsetof(pcvt_options, name), count }
static const field option_fields[] = {OPTION(struct_size, SIZE, 1),
                                      OPTION(lattice, DOUBLES, 4),
                                      OPTION(origin, DOUBLES, 2),
                                      OPTION(sites, NUMBERS, 0),
                                      OPTION(n_sites, INT32, 1),
                                      OPTION(start, INT32, 1),
                                      OPTION(seed, INT64, 1),
                                      OPTION(solver, INT32, 1),
                                      OPTION(max_iterations, INT32, 1),
                                      OPTION(tolerance, DOUBLES, 1),
                                      OPTION(n_threads, INT32, 1),
                                      OPTION(columns, INT32, 1),
                                      OPTION(rows, INT32, 1),
                                      OPTION(grain_order, INT32, 1),
                                      OPTION(grain_size, DOUBLES, 1),
                                      OPTION(short_edges, DOUBLES, 1),
                                      OPTION(budget, INT64, 1),
                                      OPTION(density_source, TEXT, 1),
                                      OPTION(density_range, DOUBLES, 2),
                                      OPTION(grain_per_edge, INT32, 1),
                                      OPTION(find_origin, INT32, 1),
                                      OPTION(areas, NUMBERS, 0),
                                      OPTION(n_areas, INT32, 1),
                                      OPTION(reserved, INT32, 1),
                                      OPTION(area_law, TEXT, 1),
                                      OPTION(aspect, DOUBLES, 1),
                                      OPTION(aspect_degrees, DOUBLES, 1),
                                      OPTION(phases, TEXT, 1),
                                      OPTION(orientations, NUMBERS, 0),
                                      OPTION(n_orientations, INT32, 1),
                                      OPTION(random_orientations, INT32, 1),
                                      OPTION(symmetry, INT32, 1),
                                      OPTION(walls, INT32, 1),
                                      OPTION(wall_cells, INT32, 1),
                                      OPTION(reserved2, INT32, 1),
                                      OPTION(inclusions, TEXT, 1),
                                      OPTION(fibres, TEXT, 1),
                                      OPTION(fixed_sites, NUMBERS, 0),
                                      OPTION(n_fixed_sites, INT32, 1),
                                      OPTION(reserved3, INT32, 1),
                                      OPTION(holes, TEXT, 1),
                                      OPTION(dimension, INT32, 1),
                                      OPTION(reserved4, INT32, 1),
                                      OPTION(lattice3, DOUBLES, 9)};

#define CHOICE(name, form, count) \
    { #name, form, offsetof(pcvt_write_options, name), count }
static const field write_fields[] = {
    CHOICE(struct_size, SIZE, 1),   CHOICE(report, TEXT, 1),
    CHOICE(kind, INT32, 1),         CHOICE(outline, INT32, 1),
    CHOICE(replace, INT32, 1),      CHOICE(colour, INT32, 1),
    CHOICE(gltf_nodes, INT32, 1),   CHOICE(single_precision, INT32, 1),
    CHOICE(pixels, INT32, 1),       CHOICE(element, INT32, 1),
    CHOICE(cut_width, DOUBLES, 1),  CHOICE(background, TEXT, 1),
    CHOICE(voxels, INT32, 2),       CHOICE(job, INT32, 1),
    CHOICE(voxel_layers, INT32, 1), CHOICE(thickness, DOUBLES, 1),
    CHOICE(surface, INT32, 1),      CHOICE(reserved2, INT32, 1)};
#define N_FIELDS(fields) (sizeof(fields) / sizeof(fields)[0])

enum { MOST_NUMBERS = 4096 };

static void stop(const char* fault, const char* word) {
    fprintf(stderr, "same_bytes_host: %s: %s\n", fault, word);
    exit(2);
}

/* The numbers of a text with commas between them; in memory that is kept until the end. */
static double* read_numbers(const char* text) {
    double* numbers = malloc(MOST_NUMBERS * sizeof *numbers);
    int n = 0;
    char* end = NULL;
    if (numbers == NULL) stop("no memory", text);
    for (;; text = end + 1) {
        if (n == MOST_NUMBERS) stop("too many numbers", text);
        numbers[n++] = strtod(text, &end);
        if (*end != ',') return numbers;
    }
}

static void set_field(void* object, const field* f, const char* text) {
    char* place = (char*)object + f->offset;
    const char* const pointer = *text == '\0' ? NULL : text;
    const double* numbers = pointer == NULL || f->form == TEXT ? NULL : read_numbers(text);
    const int64_t whole = (int64_t)strtoull(text, NULL, 10);
    int k;
    for (k = 0; k < f->count && (f->form == DOUBLES || f->form == INT32); ++k) {
        const int32_t number = numbers == NULL ? 0 : (int32_t)numbers[k];
        if (f->form == DOUBLES) memcpy(place + 8 * k, &numbers[k], sizeof numbers[k]);
        if (f->form == INT32) memcpy(place + 4 * k, &number, sizeof number);
    }
    if (f->form == INT64 || f->form == SIZE) memcpy(place, &whole, sizeof whole);
    if (f->form == NUMBERS) memcpy(place, &numbers, sizeof numbers);
    if (f->form == TEXT) memcpy(place, &pointer, sizeof pointer);
}

/* What a callback of the progress does, and what it has printed. */
typedef struct watch {
    int prints_sites;
    int last; /* the report at which it cancels; negative: none */
    int n;
    int32_t phase, iteration;
} watch;

static int on_progress(const pcvt_progress* p, void* data) {
    watch* seen = data;
    pcvt_sites sites;
    /* Reports of the start and of long steps are a matter of time. */
    if (p->phase == PCVT_PHASE_START) return 0;
    if (p->phase == seen->phase && p->iteration == seen->iteration) return 0;
    seen->phase = p->phase;
    seen->iteration = p->iteration;
    printf("progress: phase %d \"%s\", iteration %d, evaluations %d, size %d\n", p->phase,
           p->phase_text, p->iteration, p->evaluations, p->struct_size >= sizeof *p);
    printf("  energy %.17g of %.17g, residual %.17g, %.17g\n", p->energy, p->energy_bound,
           p->residual, p->rms_residual);
    if (seen->prints_sites) {
        memset(&sites, 0, sizeof sites);
        if (said("pcvt_get_progress_sites", pcvt_get_progress_sites(&sites, sizeof sites)) == 0)
            print_doubles("points", sites.points, sites.n_sites, 2);
    }
    return ++seen->n == seen->last;
}

static watch watch_of(const char* word) {
    watch made = {0, -1, 0, -1, -1};
    made.prints_sites = strcmp(word, "sites") == 0;
    if (strncmp(word, "cancel:", 7) == 0) made.last = atoi(word + 7);
    return made;
}

/* A periodic density of the unit square. `data` is "wave", "nan" or "fail". */
static int on_density(const double* points, size_t n_points, double* values, void* data) {
    const char* const word = data;
    size_t k;
    for (k = 0; k < n_points; ++k)
        values[k] = strcmp(word, "nan") == 0 ? (double)NAN
                                             : 2 + sin(6.283185307179586 * points[2 * k]) *
                                                       cos(6.283185307179586 * points[2 * k + 1]);
    return strcmp(word, "fail") == 0 ? 7 : 0;
}

/* Calls that break the rules of the interface. */
static void misuse(const pcvt_options* options, const pcvt_result* result) {
    pcvt_options own = *options;
    pcvt_result* none = NULL;
    pcvt_sites sites;
    pcvt_statistics statistics;
    pcvt_cells cells;
    int32_t minimum;
    int status;
    for (status = -9; status <= 4; ++status) printf("%d: %s\n", status, pcvt_status_text(status));
    printf("version %s, interface %08x\n", pcvt_version(), (unsigned)pcvt_abi_version());
    said("init NULL", pcvt_options_init(NULL, sizeof own, PCVT_ABI_VERSION));
    said("init size 0", pcvt_options_init(&own, 0, PCVT_ABI_VERSION));
    said("init size + 1", pcvt_options_init(&own, sizeof own + 1, PCVT_ABI_VERSION));
    said("init version + 1", pcvt_options_init(&own, sizeof own, PCVT_ABI_VERSION + 1));
    said("init version 0", pcvt_options_init(&own, sizeof own, 0));
    said("generate NULL", pcvt_generate(NULL, &none));
    said("generate to NULL", pcvt_generate(options, NULL));
    said("sites of NULL", pcvt_get_sites(NULL, &sites, sizeof sites));
    said("sites to NULL", pcvt_get_sites(result, NULL, sizeof sites));
    said("sites size - 1", pcvt_get_sites(result, &sites, sizeof sites - 1));
    said("statistics size 3", pcvt_get_statistics(result, &statistics, 3));
    said("cells of NULL", pcvt_get_cells(NULL, &cells, sizeof cells));
    said("cells size - 1", pcvt_get_cells(result, &cells, sizeof cells - 1));
    said("minimum of NULL", pcvt_get_minimum(NULL, &minimum));
    said("minimum to NULL", pcvt_get_minimum(result, NULL));
    said("progress sites", pcvt_get_progress_sites(&sites, sizeof sites));
    said("write NULL", pcvt_write(NULL, "t.obj", NULL));
    said("write to NULL", pcvt_write(result, NULL, NULL));
    said("write to nothing", pcvt_write(result, "", NULL));
    print_mesh(result, 7);
    print_tile(result, -1, 0);
    print_tile(result, 0, 5);
    pcvt_free(NULL);
}

/* The state between the words of the command line. */
typedef struct state {
    pcvt_options options;
    char beyond_options[4096]; /* what a larger struct_size reaches: fields that are not zero */
    pcvt_write_options choices;
    char beyond_choices[4096];
    pcvt_result* result;
    watch of_run, of_write;
    char density[16];
} state;

static void reset(state* s) {
    said("pcvt_options_init", pcvt_options_init(&s->options, sizeof s->options, PCVT_ABI_VERSION));
    memset(s->beyond_options, 1, sizeof s->beyond_options);
    memset(&s->choices, 0, sizeof s->choices);
    memset(s->beyond_choices, 1, sizeof s->beyond_choices);
    s->choices.struct_size = sizeof s->choices;
}

/* Sets NAME=VALUE. */
static void assign(state* s, const char* word) {
    const int of_write = strncmp(word, "write.", 6) == 0;
    const char* const name = word + (of_write ? 6 : 0);
    const char* const value = strchr(name, '=') + 1;
    const size_t length = (size_t)(value - name) - 1,
                 n = of_write ? N_FIELDS(write_fields) : N_FIELDS(option_fields);
    const field* f = of_write ? write_fields : option_fields;
    size_t k;
    for (k = 0; k < n; ++k, ++f) {
        if (strlen(f->name) != length || strncmp(f->name, name, length) != 0) continue;
        set_field(of_write ? (void*)&s->choices : (void*)&s->options, f, value);
        return;
    }
    if (strncmp(name, "progress=", 9) == 0 && of_write) {
        s->choices.progress = on_progress;
        s->choices.progress_data = &s->of_write;
        s->of_write = watch_of(value);
    } else if (strncmp(name, "progress=", 9) == 0) {
        s->options.progress = on_progress;
        s->options.progress_data = &s->of_run;
        s->of_run = watch_of(value);
    } else if (strncmp(name, "density=", 8) == 0 && strlen(value) < sizeof s->density) {
        s->options.density = on_density;
        s->options.density_data = strcpy(s->density, value);
    } else {
        stop("unknown field", word);
    }
}

int main(int argc, char** argv) {
    static state s;
    int k;
    reset(&s);
    for (k = 1; k < argc; ++k) {
        printf("> %s\n", argv[k]);
        if (strchr(argv[k], '=') != NULL) {
            assign(&s, argv[k]);
        } else if (strcmp(argv[k], "reset") == 0) {
            reset(&s);
        } else if (strcmp(argv[k], "generate") == 0) {
            pcvt_free(s.result);
            s.result = NULL;
            said("pcvt_generate", pcvt_generate(&s.options, &s.result));
            printf("result: %s\n", s.result == NULL ? "none" : "yes");
        } else if (strcmp(argv[k], "views") == 0) {
            print_views(s.result);
        } else if (strcmp(argv[k], "misuse") == 0) {
            misuse(&s.options, s.result);
        } else if (strcmp(argv[k], "write") == 0 && k + 1 < argc) {
            const char* const path = argv[++k];
            printf("  to %s\n", path);
            said("pcvt_write",
                 pcvt_write(s.result, strcmp(path, "-") == 0 ? NULL : path, &s.choices));
        } else {
            stop("unknown word", argv[k]);
        }
    }
    pcvt_free(s.result);
    return 0;
}
