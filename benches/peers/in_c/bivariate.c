/* Without the structure: polynomials in u and v, their gcd, exact division. */
#include "sweep.h"

#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_vec.h>

enum variable { U, V, VARIABLES };

static const fmpz_mpoly_ctx_struct *ring(void)
{
    static fmpz_mpoly_ctx_t own;
    static int known;
    if (!known)
        fmpz_mpoly_ctx_init(own, VARIABLES, ORD_LEX);
    known = 1;
    return own;
}

static void in_variable(fmpz_mpoly_struct *result, const fmpz_poly_struct *own, slong count, enum variable variable)
{
    for (slong i = 0; i < count; i++) {
        fmpz_mpoly_init(result + i, ring());
        fmpz_mpoly_set_fmpz_poly(result + i, own + i, variable, ring());
    }
}

static void forget(fmpz_mpoly_struct *own, slong count)
{
    for (slong i = 0; i < count; i++)
        fmpz_mpoly_clear(own + i, ring());
}

/* β A + X B */
static void together(fmpz_mpoly_t result, const fmpz_mpoly_struct *in_u, const fmpz_mpoly_t a, const fmpz_mpoly_t b)
{
    fmpz_mpoly_t second;
    fmpz_mpoly_init(second, ring());
    fmpz_mpoly_mul(result, in_u + BETA, a, ring());
    fmpz_mpoly_mul(second, in_u + PROFILE_X, b, ring());
    fmpz_mpoly_add(result, result, second, ring());
    fmpz_mpoly_clear(second, ring());
}

static void construct(fmpz_mpoly_struct *coordinates, const sweep *own)
{
    fmpz_poly_struct profiles[PROFILES], parts[PARTS];
    fmpz_mpoly_struct in_u[PROFILES], in_v[PARTS];
    polynomials_init(profiles, PROFILES);
    polynomials_init(parts, PARTS);
    profile(profiles, own);
    formula(parts, own, WITH_H);
    in_variable(in_u, profiles, PROFILES, U);
    in_variable(in_v, parts, PARTS, V);
    fmpz_mpoly_mul(coordinates + W, in_u + BETA, in_v + ALPHA, ring());
    together(coordinates + X, in_u, in_v + A_X, in_v + B_X);
    together(coordinates + Y, in_u, in_v + A_Y, in_v + B_Y);
    fmpz_mpoly_mul(coordinates + Z, in_u + PROFILE_Z, in_v + C, ring());
    forget(in_u, PROFILES);
    forget(in_v, PARTS);
    polynomials_clear(profiles, PROFILES);
    polynomials_clear(parts, PARTS);
}

static void reduce(fmpz_mpoly_struct *coordinates)
{
    fmpz_mpoly_t factor;
    fmpz_mpoly_init(factor, ring());
    fmpz_mpoly_set(factor, coordinates + W, ring());
    for (slong i = X; i < COORDINATES && !fmpz_mpoly_is_fmpz(factor, ring()); i++)
        if (!fmpz_mpoly_gcd(factor, factor, coordinates + i, ring()))
            flint_throw(FLINT_ERROR, "no gcd");
    if (!fmpz_mpoly_is_fmpz(factor, ring()))
        for (slong i = 0; i < COORDINATES; i++)
            fmpz_mpoly_divexact(coordinates + i, coordinates + i, factor, ring());
    fmpz_mpoly_clear(factor, ring());
}

/* From power coefficients aᵢ, in the order n, …, 0, to scaled Bernstein coefficients in that order:
   Σ aᵢ (1 + x)ⁿ⁻ⁱ xⁱ is the polynomial with these coefficients, shifted by 1 and reversed. */
static void to_bernstein(fmpz *reversed, slong n)
{
    fmpz_t one;
    fmpz_init_set_ui(one, 1);
    _fmpz_poly_taylor_shift(reversed, one, n + 1);
    fmpz_clear(one);
}

static void convert(fmpz_mat_t net, const fmpz_mpoly_t own)
{
    slong du = fmpz_mat_nrows(net) - 1, dv = fmpz_mat_ncols(net) - 1, degrees[VARIABLES];
    for (slong i = 0; i < fmpz_mpoly_length(own, ring()); i++) {
        fmpz_mpoly_get_term_exp_si(degrees, own, i, ring());
        fmpz_mpoly_get_term_coeff_fmpz(fmpz_mat_entry(net, degrees[U], dv - degrees[V]), own, i, ring());
    }
    for (slong i = 0; i <= du; i++) {
        to_bernstein(net->rows[i], dv);
        _fmpz_poly_reverse(net->rows[i], net->rows[i], dv + 1, dv + 1);
    }
    fmpz *column = _fmpz_vec_init(du + 1);
    for (slong j = 0; j <= dv; j++) {
        for (slong i = 0; i <= du; i++)
            fmpz_swap(column + du - i, fmpz_mat_entry(net, i, j));
        to_bernstein(column, du);
        for (slong i = 0; i <= du; i++)
            fmpz_swap(column + du - i, fmpz_mat_entry(net, i, j));
    }
    _fmpz_vec_clear(column, du + 1);
}

net bivariate(const sweep *own)
{
    fmpz_mpoly_struct coordinates[COORDINATES];
    fmpz_mat_struct matrices[COORDINATES];
    slong greatest[VARIABLES] = {0, 0}, degrees[VARIABLES];
    for (slong i = 0; i < COORDINATES; i++)
        fmpz_mpoly_init(coordinates + i, ring());
    construct(coordinates, own);
    reduce(coordinates);
    for (slong i = 0; i < COORDINATES; i++) {
        fmpz_mpoly_degrees_si(degrees, coordinates + i, ring());
        for (slong k = 0; k < VARIABLES; k++)
            greatest[k] = FLINT_MAX(greatest[k], degrees[k]);
    }
    matrices_init(matrices, greatest[U], greatest[V]);
    for (slong i = 0; i < COORDINATES; i++)
        convert(matrices + i, coordinates + i);
    net result = rounded(matrices);
    matrices_clear(matrices);
    forget(coordinates, COORDINATES);
    return result;
}
