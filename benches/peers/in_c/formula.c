/* The curve of a preimage, and the sweep over a common denominator.
 *
 * With w = a + ib let P = a² − b², Q = 2ab, N = a² + b²; the hodograph is h (P, Q), n = (Q, −P)/N,
 * t = (P, Q)/N. */
#include "sweep.h"

#include <flint/fmpz_vec.h>

void polynomials_init(fmpz_poly_struct *polynomials, slong count)
{
    for (slong i = 0; i < count; i++)
        fmpz_poly_init(polynomials + i);
}

void polynomials_clear(fmpz_poly_struct *polynomials, slong count)
{
    for (slong i = 0; i < count; i++)
        fmpz_poly_clear(polynomials + i);
}

/* The numbers times their common denominator. */
static fmpz *numerators(fmpz_t denominator, const numbers *own)
{
    fmpz *integers = _fmpz_vec_init(own->length);
    fmpz_one(denominator);
    for (slong i = 0; i < own->length; i++)
        fmpz_lcm(denominator, denominator, fmpq_denref(own->values + i));
    for (slong i = 0; i < own->length; i++) {
        fmpz_divexact(integers + i, denominator, fmpq_denref(own->values + i));
        fmpz_mul(integers + i, integers + i, fmpq_numref(own->values + i));
    }
    return integers;
}

/* Σ cᵢ vⁱ / denominator; takes the integers. */
static void polynomial(fmpq_poly_t result, fmpz *integers, slong length, const fmpz_t denominator)
{
    fmpq_poly_fit_length(result, length);
    _fmpq_poly_set_length(result, length);
    _fmpz_vec_swap(result->coeffs, integers, length);
    fmpz_set(result->den, denominator);
    fmpq_poly_canonicalise(result);
    _fmpz_vec_clear(integers, length);
}

static void from_powers(fmpq_poly_t result, const numbers *own)
{
    fmpz_t denominator;
    fmpz_init(denominator);
    fmpz *integers = numerators(denominator, own);
    polynomial(result, integers, own->length, denominator);
    fmpz_clear(denominator);
}

/* Σ bᵢ C(n,i) vⁱ (1−v)ⁿ⁻ⁱ: where p is this, yⁿ p(1/y) = q(y − 1) with q(t) = Σ bᵢ C(n,i) tⁿ⁻ⁱ. */
static void from_bernstein(fmpq_poly_t result, const numbers *own)
{
    slong length = own->length, n = length - 1;
    fmpz_t denominator, binomial, shift;
    fmpz_init(denominator);
    fmpz_init_set_ui(binomial, 1);
    fmpz_init_set_si(shift, -1);
    fmpz *integers = numerators(denominator, own);
    for (slong i = 0; i <= n; i++) {
        fmpz_mul(integers + i, integers + i, binomial);
        fmpz_mul_ui(binomial, binomial, n - i);
        fmpz_divexact_ui(binomial, binomial, i + 1);
    }
    _fmpz_poly_reverse(integers, integers, length, length);
    _fmpz_poly_taylor_shift(integers, shift, length);
    _fmpz_poly_reverse(integers, integers, length, length);
    polynomial(result, integers, length, denominator);
    fmpz_clear(denominator);
    fmpz_clear(binomial);
    fmpz_clear(shift);
}

/* Integer polynomials in the same proportion. */
static void over_common_denominator(fmpz_poly_struct *integral, const fmpq_poly_struct *own, slong count)
{
    fmpz_t denominator, factor;
    fmpz_init_set_ui(denominator, 1);
    fmpz_init(factor);
    for (slong i = 0; i < count; i++)
        fmpz_lcm(denominator, denominator, own[i].den);
    for (slong i = 0; i < count; i++) {
        fmpz_divexact(factor, denominator, own[i].den);
        fmpq_poly_get_numerator(integral + i, own + i);
        fmpz_poly_scalar_mul_fmpz(integral + i, integral + i, factor);
    }
    fmpz_clear(denominator);
    fmpz_clear(factor);
}

void profile(fmpz_poly_struct *polynomials, const sweep *own)
{
    fmpq_poly_struct rational[PROFILES];
    const numbers *given[PROFILES] = {&own->profile_x, &own->profile_z, &own->profile_d};
    for (slong i = 0; i < PROFILES; i++) {
        fmpq_poly_init(rational + i);
        from_powers(rational + i, given[i]);
    }
    over_common_denominator(polynomials, rational, PROFILES);
    for (slong i = 0; i < PROFILES; i++)
        fmpq_poly_clear(rational + i);
}

/* The hodograph h (p, q) with h n long vectors, and its integrals. */
typedef struct {
    fmpq_poly_t p, q, n, x, y, s;
} curve;

static void curve_init(curve *own)
{
    fmpq_poly_struct *all[] = {own->p, own->q, own->n, own->x, own->y, own->s};
    for (slong i = 0; i < 6; i++)
        fmpq_poly_init(all[i]);
}

static void curve_clear(curve *own)
{
    fmpq_poly_struct *all[] = {own->p, own->q, own->n, own->x, own->y, own->s};
    for (slong i = 0; i < 6; i++)
        fmpq_poly_clear(all[i]);
}

static void squares(curve *own, const sweep *given)
{
    fmpq_poly_t a, b;
    fmpq_poly_init(a);
    fmpq_poly_init(b);
    from_bernstein(a, &given->re);
    from_bernstein(b, &given->im);
    fmpq_poly_mul(own->q, a, b);
    fmpq_poly_scalar_mul_si(own->q, own->q, 2);
    fmpq_poly_mul(a, a, a);
    fmpq_poly_mul(b, b, b);
    fmpq_poly_sub(own->p, a, b);
    fmpq_poly_add(own->n, a, b);
    fmpq_poly_clear(a);
    fmpq_poly_clear(b);
}

/* The integral of h times the polynomial, which gets the factor h if it is to have it. */
static void integrate(fmpq_poly_t result, fmpq_poly_t own, const fmpq_poly_t h, enum factor factor)
{
    if (fmpq_poly_is_one(h)) {
        fmpq_poly_integral(result, own);
        return;
    }
    fmpq_poly_mul(result, own, h);
    if (factor == WITH_H)
        fmpq_poly_set(own, result);
    fmpq_poly_integral(result, result);
}

static void integrals(curve *own, const sweep *given, enum factor factor)
{
    fmpq_poly_t h;
    fmpq_poly_init(h);
    fmpq_poly_one(h);
    if (given->h.length)
        from_powers(h, &given->h);
    integrate(own->x, own->p, h, factor);
    integrate(own->y, own->q, h, factor);
    fmpq_poly_set_coeff_fmpq(own->x, 0, given->start.values);
    fmpq_poly_set_coeff_fmpq(own->y, 0, given->start.values + 1);
    if (factor == WITH_H || (given->kind != ORIENTED && given->kind != OFFSET))
        integrate(own->s, own->n, h, factor);
    fmpq_poly_clear(h);
}

/* What depends on the direction of the profile. */
static const enum part TURNING[] = {B_X, B_Y, C};

static void oriented(fmpq_poly_struct *parts, const curve *own)
{
    fmpq_poly_mul(parts + A_X, own->x, parts + ALPHA);
    fmpq_poly_mul(parts + A_Y, own->y, parts + ALPHA);
    fmpq_poly_set(parts + B_X, own->q);
    fmpq_poly_neg(parts + B_Y, own->p);
    fmpq_poly_set(parts + C, own->n);
}

/* The profile's X moves along x only; the curve moves along its normal. */
static void offset(fmpq_poly_struct *parts, const curve *own, const fmpq_t d)
{
    fmpq_poly_scalar_mul_fmpq(parts + B_X, parts + B_X, d);
    fmpq_poly_scalar_mul_fmpq(parts + B_Y, parts + B_Y, d);
    fmpq_poly_add(parts + A_X, parts + A_X, parts + B_X);
    fmpq_poly_add(parts + A_Y, parts + A_Y, parts + B_Y);
    fmpq_poly_set(parts + B_X, own->n);
    fmpq_poly_zero(parts + B_Y);
}

/* The profile grows with the length, up to 1. */
static void conical(fmpq_poly_struct *parts, curve *own)
{
    fmpq_t whole;
    fmpz_t end;
    fmpq_init(whole);
    fmpz_init_set_ui(end, 1);
    fmpq_poly_evaluate_fmpz(whole, own->s, end);
    fmpq_poly_scalar_div_fmpq(own->s, own->s, whole);
    for (slong i = 0; i < 3; i++)
        fmpq_poly_mul(parts + TURNING[i], parts + TURNING[i], own->s);
    fmpq_clear(whole);
    fmpz_clear(end);
}

/* The profile shrinks as c / (s + c), whose denominator is in α already. */
static void conical_inv(fmpq_poly_struct *parts, const fmpq_t c)
{
    for (slong i = 0; i < 3; i++)
        fmpq_poly_scalar_mul_fmpq(parts + TURNING[i], parts + TURNING[i], c);
}

static void involute(fmpq_poly_struct *parts, const curve *own)
{
    fmpq_poly_mul(parts + B_X, own->s, own->p);
    fmpq_poly_mul(parts + B_Y, own->s, own->q);
    fmpq_poly_sub(parts + A_X, parts + A_X, parts + B_X);
    fmpq_poly_sub(parts + A_Y, parts + A_Y, parts + B_Y);
    fmpq_poly_set(parts + B_X, own->p);
    fmpq_poly_set(parts + B_Y, own->q);
}

static void combine(fmpq_poly_struct *parts, curve *own, const sweep *given)
{
    fmpq_poly_set(parts + ALPHA, own->n);
    if (given->kind == CONICAL_INV) {
        fmpq_poly_set_coeff_fmpq(own->s, 0, given->c.values);
        fmpq_poly_mul(parts + ALPHA, own->n, own->s);
    }
    oriented(parts, own);
    if (given->kind == OFFSET)
        offset(parts, own, given->d.values);
    else if (given->kind == CONICAL)
        conical(parts, own);
    else if (given->kind == CONICAL_INV)
        conical_inv(parts, given->c.values);
    else if (given->kind == INVOLUTE)
        involute(parts, own);
}

void formula(fmpz_poly_struct *parts, const sweep *given, enum factor factor)
{
    fmpq_poly_struct rational[PARTS];
    curve own;
    curve_init(&own);
    for (slong i = 0; i < PARTS; i++)
        fmpq_poly_init(rational + i);
    squares(&own, given);
    integrals(&own, given, factor);
    combine(rational, &own, given);
    over_common_denominator(parts, rational, PARTS);
    for (slong i = 0; i < PARTS; i++)
        fmpq_poly_clear(rational + i);
    curve_clear(&own);
}
