/* Eq. (1) and its integration. The second copy of the equations of motion, held equal to the first by test. */
#include <math.h>

#include "parts.h"
#include "sailnet_plant.h"

#define STAGES 7
#define RIGHT_ANGLE 1.57079632679489661923

/* A step below this share of the whole is a sail in the Sun. */
#define SMALLEST_STEP 1e-9

/* What is integrated: in the plane all but the last two. The dose steers nothing, and its error does not count. */
enum { DOSE, R, THETA, U, V, LATITUDE, W, NUMBERS };
#define FIRST_THAT_STEERS R
#define IN_PLANE LATITUDE

/* Of the sail on a unit of 1 / r^2: acceleration, and light that falls on it. */
typedef struct {
    double radial, transverse, northward, light;
} force;

static force force_at(const plant_optics *optics, double beta, const plant_turn *turn, double angle)
{
    const double cut = fmax(-RIGHT_ANGLE, fmin(RIGHT_ANGLE, angle));
    const double along = cos(cut);
    const double aside = sin(cut);
    const double c = along * turn->first[0] + aside * turn->second[0];
    const double t = along * turn->first[1] + aside * turn->second[1];
    const double n = along * turn->first[2] + aside * turn->second[2];
    const double normal = beta * (optics->normal_square * c + optics->normal_linear) * c;
    const double tangential = beta * optics->tangential * c;
    const force result = {
        .radial = normal * c + (tangential * t * t + tangential * n * n),
        .transverse = normal * t - tangential * t * c,
        .northward = normal * n - tangential * n * c,
        .light = c,
    };
    return result;
}

/* The first `count` of the derivatives: in the plane latitude and northward speed are 0, and stay so. */
static inline void derivative(const double y[NUMBERS], const force *sail, int count, double dy[NUMBERS])
{
    const double inverse = 1.0 / y[R];
    const double square = inverse * inverse;
    const double turn = y[V] * inverse;
    dy[R] = y[U];
    dy[THETA] = turn;
    dy[U] = (sail->radial - 1.0) * square + y[V] * turn;
    dy[V] = sail->transverse * square - y[U] * turn;
    dy[DOSE] = sail->light * square;
    if (count > IN_PLANE) {
        const double climb = y[W] * inverse;
        const double twist = turn * tan(y[LATITUDE]);
        dy[THETA] /= cos(y[LATITUDE]);
        dy[LATITUDE] = climb;
        dy[U] += y[W] * climb;
        dy[V] += y[W] * twist;
        dy[W] = sail->northward * square - y[U] * climb - y[V] * twist;
    }
}

/* J. R. Dormand and P. J. Prince, "A family of embedded Runge-Kutta formulae", 1980: order 5 with an
   estimate of order 4. The last row is the solution, so that the last slope is the next step's first. */
static const double NODES[STAGES] = {0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0};
static const double WEIGHTS[STAGES][STAGES - 1] = {
    {0.0},
    {1.0 / 5.0},
    {3.0 / 40.0, 9.0 / 40.0},
    {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
    {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
    {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
    {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0},
};
static const double ERROR[STAGES] = {
    71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0,
};

/* One step from `y`, whose slope is slopes[0]; returns its error in units of the tolerance. */
static inline double step_from(const plant_rules *rules, const plant_optics *optics, double beta, const plant_turn *turn,
                        double angle, const force *held, int count, const double y[NUMBERS], double step,
                        double slopes[STAGES][NUMBERS], double next[NUMBERS])
{
    for (int stage = 1; stage < STAGES; stage++) {
        for (int i = 0; i < count; i++) {
            double sum = 0.0;
            for (int k = 0; k < stage; k++) {
                sum += WEIGHTS[stage][k] * slopes[k][i];
            }
            next[i] = y[i] + step * sum;
        }
        force now = *held;
        if (turn->rate != 0.0) {
            now = force_at(optics, beta, turn, angle + turn->rate * NODES[stage] * step);
        }
        derivative(next, &now, count, slopes[stage]);
    }
    double largest = 0.0;
    for (int i = FIRST_THAT_STEERS; i < count; i++) {
        double sum = 0.0;
        for (int k = 0; k < STAGES; k++) {
            sum += ERROR[k] * slopes[k][i];
        }
        const double error = fabs(step * sum) / (1.0 + fabs(next[i]));
        if (!(error <= largest)) { /* keeps a NaN */
            largest = error;
        }
    }
    return largest / rules->tolerance;
}

/* Integrate the first `count` of the numbers. */
static inline int integrate(const plant_rules *rules, const plant_optics *optics, double beta, const plant_turn *turn,
                     int count, double duration, double y[NUMBERS], double *step)
{
    double slopes[STAGES][NUMBERS];
    double next[NUMBERS];
    double left = duration;
    double trial = *step > 0.0 ? *step : duration;
    int inside = 1;
    const force held = force_at(optics, beta, turn, turn->angle);
    derivative(y, &held, count, slopes[0]);
    while (inside && left > 0.0) {
        const int last = trial >= left;
        const double taken = last ? left : trial;
        const double angle = turn->angle + turn->rate * (duration - left);
        const double error = step_from(rules, optics, beta, turn, angle, &held, count, y, taken, slopes, next);
        if (error <= 1.0) {
            for (int i = 0; i < count; i++) {
                y[i] = next[i];
                slopes[0][i] = slopes[STAGES - 1][i];
            }
            left = last ? 0.0 : left - taken;
            inside = y[R] > rules->least_radius && y[R] < rules->largest_radius;
        }
        else {
            inside = taken > SMALLEST_STEP * duration;
        }
        /* The usual control; a NaN shrinks the step, and a step cut short by the end does not. */
        if (!(last && error <= 1.0)) {
            const double factor = 0.9 * pow(error, -0.2);
            trial = taken * (factor > 0.2 ? fmin(factor, 4.0) : 0.2);
        }
        else if (error < 1e-3) {
            trial = fmax(trial, 2.0 * taken);
        }
    }
    *step = trial;
    return inside;
}

/* Over a pole and down the other side: there north and east are the other way. */
static void fold(double y[NUMBERS])
{
    if (fabs(y[LATITUDE]) > RIGHT_ANGLE) {
        y[LATITUDE] = copysign(2.0 * RIGHT_ANGLE, y[LATITUDE]) - y[LATITUDE];
        y[THETA] += 2.0 * RIGHT_ANGLE;
        y[V] = -y[V];
        y[W] = -y[W];
    }
}

int plant_hold(const plant_rules *rules, const plant_optics *optics, double beta, const plant_turn *turn,
               double duration, plant_state *state, double *step)
{
    double y[NUMBERS] = {
        [DOSE] = state->dose,
        [R] = state->r,
        [THETA] = state->theta,
        [U] = state->u,
        [V] = state->v,
        [LATITUDE] = state->latitude,
        [W] = state->w,
    };
    /* Two calls: so that a compiler may unroll the loops over the numbers of either. */
    const int inside = plant_in_space(rules)
                           ? integrate(rules, optics, beta, turn, NUMBERS, duration, y, step)
                           : integrate(rules, optics, beta, turn, IN_PLANE, duration, y, step);
    fold(y);
    state->dose = y[DOSE];
    state->r = y[R];
    state->theta = y[THETA];
    state->u = y[U];
    state->v = y[V];
    state->latitude = y[LATITUDE];
    state->w = y[W];
    return inside;
}
