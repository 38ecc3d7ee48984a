/* Proofs of files and studies by a C99 host. */
#include "tests/support/claims.h"

static int n_calls = 0;
static int n_texts_of_runs = 0;
static double last_fraction = -1;

static int count_calls(const pcvt_progress* progress, void* phase) {
    ++n_calls;
    CHECK(progress->phase == *(int*)phase || progress->phase == PCVT_PHASE_WRITE);
    CHECK(progress->fraction <= 1 && strlen(progress->phase_text) > 0);
    n_texts_of_runs += strcmp(progress->phase_text, "3 of 3 runs") == 0;
    last_fraction = progress->fraction;
    return 0;
}

/* Cancels at the call that *last states. */
static int cancel(const pcvt_progress* progress, void* last) {
    (void)progress;
    return ++n_calls >= *(int*)last;
}

static void write_tile(const char* path) {
    pcvt_options options = options_for(40);
    pcvt_write_options how = {0};
    pcvt_result* result = generated(&options);
    how.struct_size = sizeof how;
    how.replace = 1;
    CHECK(pcvt_write(result, path, &how) == PCVT_OK);
    pcvt_free(result);
}

static pcvt_check_options properties(void) {
    pcvt_check_options options;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    return options;
}

/* Checks a file, and expects the status with a text that contains `word`: of the proof, or in an
 * error of the thread. */
static void checked(const char* path, const pcvt_check_options* options, pcvt_status status,
                    const char* word, int line) {
    pcvt_proof* proof = (pcvt_proof*)&n_failed;
    const pcvt_status found = pcvt_check(path, options, &proof);
    check(found == status, "the status", line);
    check((proof != NULL) == (status == PCVT_OK || status == PCVT_REFUTED), "a proof", line);
    check(strstr(proof == NULL ? pcvt_last_error() : pcvt_proof_text(proof), word) != NULL, word,
          line);
    check(strchr(pcvt_proof_text(proof), '\n') == NULL, "one line", line);
    if (status == PCVT_OK) check(strcmp(pcvt_last_error(), "") == 0, "no error", line);
    if (status == PCVT_REFUTED) {
        check(strncmp(pcvt_last_error(), pcvt_proof_text(proof), 1000) == 0, "the reason", line);
    }
    pcvt_free_proof(proof);
}

#define CHECKED(path, options, status, word) checked(path, options, status, word, __LINE__)

static void a_tile_is_proved_with_its_properties(void) {
    pcvt_check_options options = properties();
    CHECKED("pcvt_files_test.obj", NULL, PCVT_OK, "pcvt_files_test.obj: a periodic tile: ");
    options.cvt = 1e-5;
    CHECKED("pcvt_files_test.obj", &options, PCVT_OK, ", centroidal Voronoi within ");
    options.lattice[0] = options.lattice[3] = 1;
    CHECKED("pcvt_files_test.obj", &options, PCVT_OK, "stored pairs agree");
}

static void a_tile_without_a_property_is_refuted(void) {
    pcvt_check_options options = properties();
    options.lattice[0] = options.lattice[3] = 2;
    CHECKED("pcvt_files_test.obj", &options, PCVT_REFUTED,
            "pcvt_files_test.obj: not a periodic tile: the file states the lattice 1,0,0,1");
    options = properties();
    options.cvt = 1e-5;
    options.density = "1 + 9 * u";
    CHECKED("pcvt_files_test.obj", &options, PCVT_REFUTED, "not a periodic tile");
    CHECK(strcmp(pcvt_status_text(PCVT_REFUTED), "refuted") == 0);
}

static void a_refutation_names_fields_in_place_of_options(void) {
    FILE* file = fopen("pcvt_files_test_rounded.obj", "w");
    pcvt_check_options options = properties();
    options.lattice[0] = options.lattice[3] = 1;
    fputs("v 0 0 0\nv 1 0 0\nv 1 1.000001 0\nv 0 1 0\nf 1 2 3 4\n", file);
    fclose(file);
    CHECKED("pcvt_files_test_rounded.obj", &options, PCVT_REFUTED,
            "so tolerance 1.01e-06 accepts it");
    options.tolerance = 1e-5;
    CHECKED("pcvt_files_test_rounded.obj", &options, PCVT_OK, "periodic within 1e-06");
}

static void files_and_options_that_do_not_fit_are_refused(void) {
    pcvt_check_options options = properties();
    CHECKED("pcvt_files_missing.obj", NULL, PCVT_ERROR_ARGUMENT, "pcvt_files_missing.obj: ");
    CHECKED("pcvt_files_test.xyz", NULL, PCVT_ERROR_ARGUMENT, "not a format that is read back");
    CHECKED("", NULL, PCVT_ERROR_ARGUMENT, "path is empty");
    CHECKED(NULL, NULL, PCVT_ERROR_ARGUMENT, "path is empty");
    CHECK(pcvt_check("pcvt_files_test.obj", NULL, NULL) == PCVT_ERROR_ARGUMENT);
    options.density = "1";
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "density is for cvt");
    options = properties();
    options.density_range[1] = 2;
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "density_range without density");
    options = properties();
    options.cvt = -1;
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "cvt is not a positive");
    options = properties();
    options.tolerance = -1;
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "tolerance is not a positive");
    options = properties();
    options.lattice[0] = 1;
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "period vector");
    options = properties();
    options.areas = "equal";
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "areas is a law");
    options = properties();
    options.volumes = "0.5*equal@1+0.5*equal@2";
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "volumes is a law");
    options.volumes = "pcvt_files_missing.txt";
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "pcvt_files_missing.txt: ");
    options = properties();
    options.areas = "pcvt_files_missing.txt";
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "pcvt_files_missing.txt: ");
    options = properties();
    options.inclusions = "pcvt_files_missing.txt";
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ARGUMENT, "pcvt_files_missing.txt: ");
    options.struct_size = 8;
    CHECKED("pcvt_files_test.obj", &options, PCVT_ERROR_ABI, "pcvt_check_options has size 8");
    pcvt_free_proof(NULL);
    CHECK(strcmp(pcvt_proof_text(NULL), "") == 0);
}

static void a_check_shows_progress_and_is_cancelled(void) {
    int phase = PCVT_PHASE_PROVE, first = 1;
    pcvt_check_options options = properties();
    options.progress = count_calls;
    options.progress_data = &phase;
    n_calls = 0;
    CHECKED("pcvt_files_test.obj", &options, PCVT_OK, "a periodic tile");
    CHECK(n_calls > 0);
    options.progress = cancel;
    options.progress_data = &first;
    CHECKED("pcvt_files_test.obj", &options, PCVT_CANCELLED, "cancelled");
}

static pcvt_study_options study_of(const int32_t* sites, int32_t n_sites) {
    pcvt_study_options options;
    memset(&options, 0xFF, sizeof options);
    CHECK(pcvt_study_options_init(&options, sizeof options, PCVT_ABI_VERSION, "fig11") == PCVT_OK);
    CHECK(strcmp(options.name, "fig11") == 0 && options.n_sites == 8 && options.sites[7] == 150);
    CHECK(options.runs == 5000 && options.seed == 0 && options.path == NULL);
    options.sites = sites;
    options.n_sites = n_sites;
    options.runs = 3;
    options.replace = 1;
    return options;
}

static pcvt_study_result* studied(const pcvt_study_options* options) {
    pcvt_study_result* study = NULL;
    CHECK(pcvt_study(options, &study) == PCVT_OK && study != NULL);
    return study;
}

static void a_study_has_its_tables_and_pictures(void) {
    const int32_t sites[2] = {4, 6};
    pcvt_study_options options = study_of(sites, 2);
    pcvt_study_result* study = studied(&options);
    pcvt_study_contents contents;
    pcvt_table table;
    pcvt_picture picture;
    CHECK(pcvt_get_study_contents(study, &contents, sizeof contents) == PCVT_OK);
    CHECK(contents.n_tables == 3 && contents.n_pictures == 2);
    CHECK(strncmp(contents.text, "n  runs  all_hexagon", 20) == 0);
    CHECK(pcvt_get_table(study, 0, &table, sizeof table) == PCVT_OK);
    CHECK(strcmp(table.name, "fig11") == 0 && table.n_rows == 2);
    CHECK(strcmp(table.columns[1], "runs") == 0);
    CHECK(strcmp(table.cells[table.n_columns], "6") == 0);
    CHECK(pcvt_get_table(study, 2, &table, sizeof table) == PCVT_OK);
    CHECK(strcmp(table.name, "fig11-runs") == 0 && table.n_rows == 6);
    CHECK(table.n_notes > 1 && strstr(table.notes[0], "--sites 4,6 --runs 3 --seed 0") != NULL);
    CHECK(pcvt_get_table(study, 3, &table, sizeof table) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_table(study, -1, &table, sizeof table) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_table(study, 0, &table, 8) == PCVT_ERROR_ABI);
    CHECK(pcvt_get_picture(study, 1, &picture, sizeof picture) == PCVT_OK);
    CHECK(strcmp(picture.name, "fig11-shares") == 0 && strstr(picture.svg, "<svg") != NULL);
    CHECK(pcvt_get_picture(study, 2, &picture, sizeof picture) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_get_picture(NULL, 0, &picture, sizeof picture) == PCVT_ERROR_ARGUMENT);
    pcvt_free_study(study);
    pcvt_free_study(NULL);
}

static void not_studied(const pcvt_study_options* options, pcvt_status status, const char* word,
                        int line) {
    pcvt_study_result* study = (pcvt_study_result*)&n_failed;
    check(pcvt_study(options, &study) == status, "the status", line);
    check(study == NULL, "no study", line);
    check(strstr(pcvt_last_error(), word) != NULL, word, line);
}

#define NOT_STUDIED(options, status, word) not_studied(options, status, word, __LINE__)

static void studies_that_do_not_fit_are_refused(void) {
    const int32_t sites[2] = {4, 4};
    pcvt_study_options options = study_of(sites, 2);
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "4 sites are given twice");
    options.n_sites = -1;
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "n_sites");
    options = study_of(NULL, 2);
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "n_sites");
    options = study_of(sites, 1);
    options.runs = 0;
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "runs is below 1");
    options = study_of(sites, 1);
    options.n_threads = -1;
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "n_threads is not between");
    options = study_of(sites, 1);
    options.path = "fig11.txt";
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "fig11.txt: neither .csv");
    options.path = "";
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "path is empty");
    options.path = "/dev/null/fig11.csv";
    NOT_STUDIED(&options, PCVT_ERROR_IO, "/dev/null");
    options.struct_size = 8;
    NOT_STUDIED(&options, PCVT_ERROR_ABI, "size 8");
    NOT_STUDIED(NULL, PCVT_ERROR_ARGUMENT, "null pointer");
    options = study_of(sites, 1);
    options.name = "fig12";
    NOT_STUDIED(&options, PCVT_ERROR_ARGUMENT, "unknown; take one of");
    CHECK(pcvt_study(&options, NULL) == PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_study_options_init(&options, sizeof options, PCVT_ABI_VERSION, "fig12") ==
          PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_study_options_init(&options, sizeof options, PCVT_ABI_VERSION, NULL) ==
          PCVT_ERROR_ARGUMENT);
    CHECK(pcvt_study_options_init(&options, sizeof options, PCVT_ABI_VERSION + 1, "fig11") ==
          PCVT_ERROR_ABI);
}

static void a_study_shows_progress_and_is_cancelled_without_files(void) {
    const int32_t sites[1] = {30};
    int phase = PCVT_PHASE_OPTIMISE, fifth = 5;
    pcvt_study_options options = study_of(sites, 1);
    options.progress = count_calls;
    options.progress_data = &phase;
    pcvt_free_study(studied(&options));
    CHECK(n_texts_of_runs > 0 && last_fraction == 1);
    options.path = "pcvt_files_test_study.csv";
    pcvt_free_study(studied(&options));
    options.replace = 0;
    NOT_STUDIED(&options, PCVT_ERROR_IO, "set replace");
    options.runs = 1000000;
    options.progress = cancel;
    options.progress_data = &fifth;
    options.path = "pcvt_files_test_cancelled.csv";
    n_calls = 0;
    NOT_STUDIED(&options, PCVT_CANCELLED, "cancelled");
    CHECK(n_calls == 5);
    CHECK(fopen("pcvt_files_test_cancelled.csv", "r") == NULL);
}

int main(void) {
    write_tile("pcvt_files_test.obj");
    a_tile_is_proved_with_its_properties();
    a_tile_without_a_property_is_refuted();
    a_refutation_names_fields_in_place_of_options();
    files_and_options_that_do_not_fit_are_refused();
    a_check_shows_progress_and_is_cancelled();
    a_study_has_its_tables_and_pictures();
    studies_that_do_not_fit_are_refused();
    a_study_shows_progress_and_is_cancelled_without_files();
    return end_of_claims();
}
