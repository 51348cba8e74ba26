/* A sweep, its formula by polynomials in v, and the net of doubles that comes of it. */
#ifndef SWEEP_H
#define SWEEP_H

#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>

typedef struct {
    fmpq *values;
    slong length;
} numbers;

enum kind { ORIENTED, OFFSET, CONICAL, CONICAL_INV, INVOLUTE, KINDS };

/* The preimage `re` + i `im` by Bernstein coefficients, all else by powers; no `h` is h = 1. */
typedef struct {
    enum kind kind;
    numbers re, im, h, start, profile_x, profile_z, profile_d, d, c;
} sweep;

/* Points x y z w, u outside and v inside. */
typedef struct {
    slong du, dv;
    double *doubles;
} net;

/* Each coordinate is β(u) A(v) + X(u) B(v), or Z(u) C(v), over α(v) β(u). */
enum part { ALPHA, A_X, B_X, A_Y, B_Y, C, PARTS };
enum profile { PROFILE_X, PROFILE_Z, BETA, PROFILES };
enum coordinate { W, X, Y, Z, COORDINATES };

/* Whether n, p, q have the factor h, as polynomials that do not know what belongs together would. */
enum factor { WITHOUT_H, WITH_H };

void formula(fmpz_poly_struct *parts, const sweep *own, enum factor factor);
void profile(fmpz_poly_struct *polynomials, const sweep *own);

void polynomials_init(fmpz_poly_struct *polynomials, slong count);
void polynomials_clear(fmpz_poly_struct *polynomials, slong count);

void matrices_init(fmpz_mat_struct *coordinates, slong du, slong dv);
void matrices_clear(fmpz_mat_struct *coordinates);

/* The doubles nearest to the points of scaled Bernstein coefficients. */
net rounded(const fmpz_mat_struct *coordinates);

net bivariate(const sweep *own);
net separable(const sweep *own);

#endif
