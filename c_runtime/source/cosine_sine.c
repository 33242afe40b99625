/* 1 / (2k)! and 1 / (2k + 1)! with alternating signs: what is left out is below rounding at pi/4. */
#ifdef SAILNET_FLOAT64
#define SAILNET_SERIES 9
static const sailnet_real sailnet_cosine_series[SAILNET_SERIES] = {
    4.779477332387385e-14, -1.1470745597729725e-11, 2.08767569878681e-09, -2.755731922398589e-07,
    2.48015873015873e-05,  -0.001388888888888889,   0.041666666666666664, -0.5,
    1.0};
static const sailnet_real sailnet_sine_series[SAILNET_SERIES] = {
    2.8114572543455206e-15, -7.647163731819816e-13, 1.6059043836821613e-10, -2.505210838544172e-08,
    2.7557319223985893e-06, -0.0001984126984126984, 0.008333333333333333,   -0.16666666666666666,
    1.0};
#else
#define SAILNET_SERIES 5
static const sailnet_real sailnet_cosine_series[SAILNET_SERIES] = {2.48015873e-05f, -0.00138888889f, 0.0416666667f,
                                                                   -0.5f, 1.0f};
static const sailnet_real sailnet_sine_series[SAILNET_SERIES] = {2.75573192e-06f, -0.000198412698f, 0.00833333333f,
                                                                 -0.166666667f, 1.0f};
#endif

/* cos and sin of an angle of at most pi/2, from the series at its half, where they are short. */
SAILNET_INLINE void sailnet_cosine_sine(sailnet_real angle, sailnet_real *cosine, sailnet_real *sine)
{
    const sailnet_real half = R(0.5) * angle;
    const sailnet_real square = half * half;
    sailnet_real c = sailnet_cosine_series[0];
    sailnet_real s = sailnet_sine_series[0];
    for (int32_t k = 1; k < SAILNET_SERIES; k++) {
        c = sailnet_cosine_series[k] + square * c;
        s = sailnet_sine_series[k] + square * s;
    }
    s *= half;
    *cosine = R(1.0) - R(2.0) * s * s;
    *sine = R(2.0) * s * c;
}
