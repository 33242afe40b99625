/*
 * 2^octaves, for at most 60 octaves: whole ones by their bits, what is left of them, in [-1/2, 1/2], by its best
 * polynomial, to 3e-9 (float) and 2e-17 (double). Exact for whole numbers.
 */
SAILNET_INLINE sailnet_real sailnet_exp2(sailnet_real octaves)
{
    const sailnet_real r = sailnet_fraction(octaves);
    const sailnet_real r2 = r * r;
    const sailnet_real r4 = r2 * r2;
#ifdef SAILNET_FLOAT64
    const sailnet_real lower =
        (1.0 + 0.693147180559945697 * r) + r2 * (0.24022650695910098 + 0.055504108664790396 * r);
    const sailnet_real middle = (0.00961812910760700282 + 0.00133335581534396772 * r) +
                                r2 * (0.000154035304415713795 + 1.52527273854276346e-5 * r);
    const sailnet_real upper = (1.32154426757972389e-6 + 1.0180647576596453e-7 * r) +
                               r2 * (7.07257032075841552e-9 + 4.07808253608618615e-10 * r);
    return (lower + r4 * (middle + r4 * upper)) * sailnet_power(octaves);
#else
    const sailnet_real lower =
        (1.0f + 0.693147214967486407f * r) + r2 * (0.24022652782749014f + 0.0555031055199524971f * r);
    const sailnet_real upper =
        (0.00961769299262505856f + 0.00134066435875363325f * r) + 0.000155946720956918391f * r2;
    return (lower + r4 * upper) * sailnet_power(octaves);
#endif
}
