/* FLINT on the workloads: `flint-in-c bivariate|separable SAMPLES SECONDS`.
 *
 * Reads sweeps, each a name, a kind and nine lists of rationals with their lengths before them; answers each
 * by a line: the name, the bidegree, the median time in seconds, the hash of the doubles. */
#include "sweep.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* A sample takes at least as long, so that neither the clock nor its reading counts. */
static const double SHORTEST_SAMPLE = 2e-4;

static void fail(const char *reason)
{
    fprintf(stderr, "flint-in-c: %s\n", reason);
    exit(EXIT_FAILURE);
}

/* The next word, or none at the end. */
static char *word(void)
{
    char *own = NULL;
    return scanf("%ms", &own) == 1 ? own : NULL;
}

static enum kind kind(void)
{
    static const char *const names[KINDS] = {"oriented", "offset", "conical", "conical_inv", "involute"};
    char *own = word();
    slong found = 0;
    while (found < KINDS && (!own || strcmp(own, names[found])))
        found++;
    free(own);
    if (found == KINDS)
        fail("not a kind");
    return found;
}

static numbers list(slong least)
{
    numbers own;
    if (scanf("%" SCNd64, &own.length) != 1 || own.length < least)
        fail("not the length of a list");
    own.values = _fmpq_vec_init(own.length);
    for (slong i = 0; i < own.length; i++) {
        char *text = word();
        if (!text || fmpq_set_str(own.values + i, text, 10) || fmpz_is_zero(fmpq_denref(own.values + i)))
            fail("not a rational");
        fmpq_canonicalise(own.values + i);
        free(text);
    }
    return own;
}

static sweep sweep_read(void)
{
    sweep own = {.kind = kind()};
    own.re = list(1);
    own.im = list(1);
    own.h = list(0);
    own.start = list(2);
    own.profile_x = list(0);
    own.profile_z = list(0);
    own.profile_d = list(1);
    own.d = list(1);
    own.c = list(1);
    return own;
}

static void sweep_clear(sweep *own)
{
    numbers *all[] = {&own->re,        &own->im,        &own->h, &own->start, &own->profile_x,
                      &own->profile_z, &own->profile_d, &own->d, &own->c};
    for (slong i = 0; i < 9; i++)
        _fmpq_vec_clear(all[i]->values, all[i]->length);
}

/* FNV-1a 64 over the little-endian bytes. */
static uint64_t hash(const net *own)
{
    uint64_t value = 0xCBF29CE484222325, bits;
    for (slong i = 0; i < (own->du + 1) * (own->dv + 1) * COORDINATES; i++) {
        memcpy(&bits, own->doubles + i, sizeof bits);
        for (int shift = 0; shift < 64; shift += 8)
            value = (value ^ (bits >> shift & 0xFF)) * 0x100000001B3;
    }
    return value;
}

static double now(void)
{
    struct timespec own;
    clock_gettime(CLOCK_MONOTONIC, &own);
    return own.tv_sec + own.tv_nsec * 1e-9;
}

typedef net program(const sweep *);

/* Seconds of one run, by so many. */
static double sample(program *compile, const sweep *own, slong repetitions)
{
    double begin = now();
    for (slong i = 0; i < repetitions; i++)
        flint_free(compile(own).doubles);
    return (now() - begin) / repetitions;
}

static int ascending(const void *first, const void *second)
{
    double a = *(const double *)first, b = *(const double *)second;
    return (a > b) - (a < b);
}

/* The median of so many samples, or of as many as fit in a time. */
static double median(program *compile, const sweep *own, slong samples, double patience)
{
    double *times = flint_malloc(samples * sizeof *times), begin = now(), once = sample(compile, own, 1);
    slong repetitions = once < SHORTEST_SAMPLE ? SHORTEST_SAMPLE / once + 1 : 1, count = 0;
    while (count < samples && (!count || now() - begin < patience))
        times[count++] = sample(compile, own, repetitions);
    qsort(times, count, sizeof *times, ascending);
    double middle = (times[(count - 1) / 2] + times[count / 2]) / 2;
    flint_free(times);
    return middle;
}

int main(int count, char **arguments)
{
    int generic = count == 4 && !strcmp(arguments[1], "bivariate");
    if (count != 4 || (!generic && strcmp(arguments[1], "separable")))
        fail("usage: flint-in-c bivariate|separable SAMPLES SECONDS");
    program *compile = generic ? bivariate : separable;
    slong samples = FLINT_MAX(1, atol(arguments[2]));
    double patience = atof(arguments[3]);
    for (char *name; (name = word()); free(name)) {
        sweep own = sweep_read();
        net doubles = compile(&own);
        double seconds = median(compile, &own, samples, patience);
        printf("%s %ld %ld %.9e %016" PRIx64 "\n", name, doubles.du, doubles.dv, seconds, hash(&doubles));
        fflush(stdout);
        flint_free(doubles.doubles);
        sweep_clear(&own);
    }
    flint_cleanup();
    return EXIT_SUCCESS;
}
