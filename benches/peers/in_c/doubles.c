/* The doubles nearest to quotients of integers. */
#include "sweep.h"

#include <float.h>
#include <math.h>
#include <stdint.h>

#include <flint/fmpz_vec.h>
#include <flint/longlong.h>

_Static_assert(FLINT_BITS == 64 && LDBL_MANT_DIG >= 64, "64-bit limbs, and a type that holds one exactly");

void matrices_init(fmpz_mat_struct *coordinates, slong du, slong dv)
{
    for (slong i = 0; i < COORDINATES; i++)
        fmpz_mat_init(coordinates + i, du + 1, dv + 1);
}

void matrices_clear(fmpz_mat_struct *coordinates)
{
    for (slong i = 0; i < COORDINATES; i++)
        fmpz_mat_clear(coordinates + i);
}

/* |x| is between high:low and high:low + 1, times a power of two; the first bit is set. */
typedef struct {
    uint64_t high, low;
    slong exponent;
} digits;

static digits leading(const fmpz_t x)
{
    if (!COEFF_IS_MPZ(*x)) {
        uint64_t own = FLINT_ABS(*x);
        int shift = own ? __builtin_clzll(own) : 0;
        return (digits){own << shift, 0, -64 - shift};
    }
    mpz_srcptr own = COEFF_TO_PTR(*x);
    slong size = mpz_size(own);
    const mp_limb_t *limbs = mpz_limbs_read(own);
    uint64_t first = limbs[size - 1], second = size > 1 ? limbs[size - 2] : 0, third = size > 2 ? limbs[size - 3] : 0;
    int shift = __builtin_clzll(first);
    if (shift) {
        first = first << shift | second >> (64 - shift);
        second = second << shift | third >> (64 - shift);
    }
    return (digits){first, second, 64 * (size - 2) - shift};
}

/* 64 or 63 bits of the quotient and whether there are more, rounded once by the hardware, also where the
 * result is subnormal. */
static double exactly(const fmpz_t a, const fmpz_t b)
{
    fmpz_t top, bottom, rest;
    fmpz_init(top);
    fmpz_init(bottom);
    fmpz_init(rest);
    fmpz_abs(top, a);
    fmpz_abs(bottom, b);
    slong shift = 63 - (slong)fmpz_bits(a) + (slong)fmpz_bits(b);
    if (shift >= 0)
        fmpz_mul_2exp(top, top, shift);
    else
        fmpz_mul_2exp(bottom, bottom, -shift);
    fmpz_tdiv_qr(top, rest, top, bottom);
    uint64_t quotient = fmpz_get_ui(top) | !fmpz_is_zero(rest);
    fmpz_clear(top);
    fmpz_clear(bottom);
    fmpz_clear(rest);
    int clamped = FLINT_MAX(-20000, FLINT_MIN(20000, -shift));
    return (double)ldexpl(quotient, clamped);
}

/* With 2¹²⁵ ≤ A < 2¹²⁶ and 2⁶³ ≤ B < 2⁶⁴, |a| in [A, A + 1) and |b| in [B, B + 1), but for powers of two,
 * |a/b| is between q − 1 and q + 1, q = ⌊A/B⌋: above since (A + 1)/B ≤ q + 1, below since A/B − A/(B + 1) < 1.
 * Where both round to the same double, so does all between them. */
static double nearest(const fmpz_t a, const fmpz_t b, digits below)
{
    if (fmpz_is_zero(a))
        return 0;
    digits own = leading(a);
    uint64_t quotient, rest;
    udiv_qrnnd(quotient, rest, own.high >> 2, own.high << 62 | own.low >> 2, below.high);
    (void)rest;
    double low = (double)(int64_t)(quotient - 1), high = (double)(int64_t)(quotient + 1);
    slong exponent = own.exponent + 2 - (below.exponent + 64);
    double magnitude;
    if (low == high && exponent > -960 && exponent < 960) {
        union { uint64_t bits; double power; } scale = {(uint64_t)(1023 + exponent) << 52};
        magnitude = low * scale.power;
    } else {
        magnitude = exactly(a, b);
    }
    return fmpz_sgn(a) == fmpz_sgn(b) ? magnitude : 0.0 - magnitude;
}

/* The products of the first weight with C(n,j): the weights of a net that is constant. */
static fmpz *constant(slong n, const fmpz_t first)
{
    fmpz *own = _fmpz_vec_init(n + 1);
    fmpz_set(own, first);
    for (slong j = 0; j < n; j++) {
        fmpz_mul_ui(own + j + 1, own + j, n - j);
        fmpz_divexact_ui(own + j + 1, own + j + 1, j + 1);
    }
    return own;
}

net rounded(const fmpz_mat_struct *coordinates)
{
    slong du = fmpz_mat_nrows(coordinates) - 1, dv = fmpz_mat_ncols(coordinates) - 1;
    net result = {du, dv, flint_malloc((du + 1) * (dv + 1) * COORDINATES * sizeof(double))};
    double *at = result.doubles;
    fmpz_t unit, binomial;
    fmpz_init(unit);
    fmpz_init_set_ui(binomial, 1);
    fmpz *along_v = constant(dv, fmpz_mat_entry(coordinates + W, 0, 0));
    for (slong i = 0; i <= du; i++) {
        for (slong j = 0; j <= dv; j++) {
            const fmpz *w = fmpz_mat_entry(coordinates + W, i, j);
            fmpz_mul(unit, along_v + j, binomial);
            digits one = leading(unit), below = fmpz_is_zero(w) ? one : leading(w);
            const fmpz *divisor = fmpz_is_zero(w) ? unit : w;
            for (slong k = X; k < COORDINATES; k++)
                *at++ = nearest(fmpz_mat_entry(coordinates + k, i, j), divisor, below);
            *at++ = nearest(w, unit, one);
        }
        fmpz_mul_ui(binomial, binomial, du - i);
        fmpz_divexact_ui(binomial, binomial, i + 1);
    }
    _fmpz_vec_clear(along_v, dv + 1);
    fmpz_clear(unit);
    fmpz_clear(binomial);
    return result;
}
