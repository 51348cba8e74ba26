/* By the structure: polynomials in one variable, W = α(v) β(u). */
#include "sweep.h"

#include <flint/fmpz_vec.h>

/* The gcd of those whose coefficient on the other side is not zero. */
static void divide_by_gcd(fmpz_poly_struct *own, slong count, slong first)
{
    fmpz_poly_t factor;
    fmpz_poly_init(factor);
    fmpz_poly_set(factor, own + first);
    for (slong i = 0; i < count && fmpz_poly_degree(factor) > 0; i++)
        if (i != first)
            fmpz_poly_gcd(factor, factor, own + i);
    if (fmpz_poly_degree(factor) > 0)
        for (slong i = 0; i < count; i++)
            fmpz_poly_div(own + i, own + i, factor);
    fmpz_poly_clear(factor);
}

/* Whether X = λ β. */
static int dependent(const fmpz_poly_struct *profiles)
{
    const fmpz_poly_struct *x = profiles + PROFILE_X, *beta = profiles + BETA;
    if (fmpz_poly_degree(x) != fmpz_poly_degree(beta))
        return 0;
    fmpz_poly_t first, second;
    fmpz_poly_init(first);
    fmpz_poly_init(second);
    fmpz_poly_scalar_mul_fmpz(first, x, fmpz_poly_lead(beta));
    fmpz_poly_scalar_mul_fmpz(second, beta, fmpz_poly_lead(x));
    int equal = fmpz_poly_equal(first, second);
    fmpz_poly_clear(first);
    fmpz_poly_clear(second);
    return equal;
}

/* X = λ β: the coordinates are products, with A + λ B for A. */
static void join(fmpz_poly_struct *profiles, fmpz_poly_struct *parts)
{
    const fmpz *top = fmpz_poly_lead(profiles + PROFILE_X), *bottom = fmpz_poly_lead(profiles + BETA);
    for (slong i = 0; i < PARTS; i++)
        if (i != B_X && i != B_Y)
            fmpz_poly_scalar_mul_fmpz(parts + i, parts + i, bottom);
    fmpz_poly_scalar_addmul_fmpz(parts + A_X, parts + B_X, top);
    fmpz_poly_scalar_addmul_fmpz(parts + A_Y, parts + B_Y, top);
    fmpz_poly_zero(profiles + PROFILE_X);
}

static void reduce(fmpz_poly_struct *profiles, fmpz_poly_struct *parts)
{
    divide_by_gcd(profiles, PROFILES, BETA);
    if (dependent(profiles))
        join(profiles, parts);
    if (fmpz_poly_is_zero(profiles + PROFILE_X)) {
        fmpz_poly_zero(parts + B_X);
        fmpz_poly_zero(parts + B_Y);
    }
    if (fmpz_poly_is_zero(profiles + PROFILE_Z))
        fmpz_poly_zero(parts + C);
    divide_by_gcd(parts, PARTS, ALPHA);
}

static slong greatest_degree(const fmpz_poly_struct *own, slong count)
{
    slong greatest = 0;
    for (slong i = 0; i < count; i++)
        greatest = FLINT_MAX(greatest, fmpz_poly_degree(own + i));
    return greatest;
}

/* C(n,j) bⱼ: the coefficients of tⁿ⁻ʲ in q(1 + t), where q(y) = yⁿ p(1/y). */
static fmpz *scaled_bernstein(const fmpz_poly_t own, slong n)
{
    fmpz *coefficients = _fmpz_vec_init(n + 1);
    if (fmpz_poly_is_zero(own))
        return coefficients;
    fmpz_t shift;
    fmpz_init_set_ui(shift, 1);
    _fmpz_poly_reverse(coefficients, own->coeffs, own->length, n + 1);
    _fmpz_poly_taylor_shift(coefficients, shift, n + 1);
    _fmpz_poly_reverse(coefficients, coefficients, n + 1, n + 1);
    fmpz_clear(shift);
    return coefficients;
}

static void products(fmpz_mat_struct *coordinates, fmpz *const *in_u, fmpz *const *in_v)
{
    const fmpz *x = in_u[PROFILE_X], *z = in_u[PROFILE_Z], *beta = in_u[BETA];
    for (slong i = 0; i < fmpz_mat_nrows(coordinates); i++)
        for (slong j = 0; j < fmpz_mat_ncols(coordinates); j++) {
            fmpz_mul(fmpz_mat_entry(coordinates + W, i, j), beta + i, in_v[ALPHA] + j);
            fmpz_fmma(fmpz_mat_entry(coordinates + X, i, j), beta + i, in_v[A_X] + j, x + i, in_v[B_X] + j);
            fmpz_fmma(fmpz_mat_entry(coordinates + Y, i, j), beta + i, in_v[A_Y] + j, x + i, in_v[B_Y] + j);
            fmpz_mul(fmpz_mat_entry(coordinates + Z, i, j), z + i, in_v[C] + j);
        }
}

static net convert(const fmpz_poly_struct *profiles, const fmpz_poly_struct *parts)
{
    slong du = greatest_degree(profiles, PROFILES), dv = greatest_degree(parts, PARTS);
    fmpz *in_u[PROFILES], *in_v[PARTS];
    fmpz_mat_struct coordinates[COORDINATES];
    for (slong i = 0; i < PROFILES; i++)
        in_u[i] = scaled_bernstein(profiles + i, du);
    for (slong i = 0; i < PARTS; i++)
        in_v[i] = scaled_bernstein(parts + i, dv);
    matrices_init(coordinates, du, dv);
    products(coordinates, in_u, in_v);
    net result = rounded(coordinates);
    matrices_clear(coordinates);
    for (slong i = 0; i < PROFILES; i++)
        _fmpz_vec_clear(in_u[i], du + 1);
    for (slong i = 0; i < PARTS; i++)
        _fmpz_vec_clear(in_v[i], dv + 1);
    return result;
}

net separable(const sweep *own)
{
    fmpz_poly_struct profiles[PROFILES], parts[PARTS];
    polynomials_init(profiles, PROFILES);
    polynomials_init(parts, PARTS);
    profile(profiles, own);
    formula(parts, own, WITHOUT_H);
    reduce(profiles, parts);
    net result = convert(profiles, parts);
    polynomials_clear(profiles, PROFILES);
    polynomials_clear(parts, PARTS);
    return result;
}
