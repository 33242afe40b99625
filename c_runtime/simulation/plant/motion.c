/* Eq. (1) and its integration. The second copy of the equations of motion, held equal to the first by test. */
#include <math.h>

#include "sailnet_plant.h"

#define COMPONENTS 5
#define STAGES 7
#define RIGHT_ANGLE 1.57079632679489661923

/* A step below this share of the whole is a sail in the Sun. */
#define SMALLEST_STEP 1e-9

/* Of the sail on a unit of 1 / r^2: acceleration, and light that falls on it. */
typedef struct {
    double radial, transverse, light;
} force;

static force force_at(const plant_optics *optics, double beta, double angle)
{
    const double cut = fmax(-RIGHT_ANGLE, fmin(RIGHT_ANGLE, angle));
    const double c = cos(cut);
    const double s = sin(cut);
    const double normal = beta * (optics->normal_square * c + optics->normal_linear) * c;
    const double tangential = beta * optics->tangential * c * s;
    const force result = {normal * c + tangential * s, normal * s - tangential * c, c};
    return result;
}

static void derivative(const double y[COMPONENTS], const force *sail, double dy[COMPONENTS])
{
    const double inverse = 1.0 / y[0];
    const double square = inverse * inverse;
    const double turn = y[3] * inverse;
    dy[0] = y[2];
    dy[1] = turn;
    dy[2] = (sail->radial - 1.0) * square + y[3] * turn;
    dy[3] = sail->transverse * square - y[2] * turn;
    dy[4] = sail->light * square;
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
static double step_from(const plant_rules *rules, const plant_optics *optics, double beta, double angle, double rate,
                        const force *held, const double y[COMPONENTS], double step,
                        double slopes[STAGES][COMPONENTS], double next[COMPONENTS])
{
    for (int stage = 1; stage < STAGES; stage++) {
        for (int i = 0; i < COMPONENTS; i++) {
            double sum = 0.0;
            for (int k = 0; k < stage; k++) {
                sum += WEIGHTS[stage][k] * slopes[k][i];
            }
            next[i] = y[i] + step * sum;
        }
        force now = *held;
        if (rate != 0.0) {
            now = force_at(optics, beta, angle + rate * NODES[stage] * step);
        }
        derivative(next, &now, slopes[stage]);
    }
    double largest = 0.0;
    for (int i = 0; i < COMPONENTS - 1; i++) { /* the dose steers nothing */
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

int plant_hold(const plant_rules *rules, const plant_optics *optics, double beta, double angle, double rate,
               double duration, plant_state *state, double *step)
{
    double y[COMPONENTS] = {state->r, state->theta, state->u, state->v, state->dose};
    double slopes[STAGES][COMPONENTS];
    double next[COMPONENTS];
    double left = duration;
    double trial = *step > 0.0 ? *step : duration;
    int inside = 1;
    const force held = force_at(optics, beta, angle);
    derivative(y, &held, slopes[0]);
    while (inside && left > 0.0) {
        const int last = trial >= left;
        const double taken = last ? left : trial;
        const double error =
            step_from(rules, optics, beta, angle + rate * (duration - left), rate, &held, y, taken, slopes, next);
        if (error <= 1.0) {
            for (int i = 0; i < COMPONENTS; i++) {
                y[i] = next[i];
                slopes[0][i] = slopes[STAGES - 1][i];
            }
            left = last ? 0.0 : left - taken;
            inside = y[0] > rules->least_radius && y[0] < rules->largest_radius;
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
    state->r = y[0];
    state->theta = y[1];
    state->u = y[2];
    state->v = y[3];
    state->dose = y[4];
    return inside;
}
