#include "sailnet_extremal.h"

#include <string.h>

#define STATES SAILNET_STATES
#define UNKNOWNS (2 * SAILNET_STATES)
/* Where lambda_u and lambda_v are among the unknowns. */
#define LAMBDA_U (STATES + STATES - (SAILNET_IN_SPACE ? 3 : 2))
#define LAMBDA_V (LAMBDA_U + 1)

/* Stages of Dormand and Prince's method of fifth order; the seventh is the first of the next step. */
#define STAGES 7
static const double stage_weights[STAGES - 1][STAGES - 1] = {
    {0.2, 0.0, 0.0, 0.0, 0.0, 0.0},
    {0.075, 0.225, 0.0, 0.0, 0.0, 0.0},
    {0.9777777777777777, -3.7333333333333334, 3.5555555555555554, 0.0, 0.0, 0.0},
    {2.9525986892242035, -11.595793324188385, 9.822892851699436, -0.2908093278463649, 0.0, 0.0},
    {2.8462752525252526, -10.757575757575758, 8.906422717743473, 0.2784090909090909, -0.2735313036020583, 0.0},
    {0.09114583333333333, 0.0, 0.44923629829290207, 0.6510416666666666, -0.322376179245283, 0.13095238095238096}};
static const double error_weights[STAGES] = {0.0012326388888888888,  0.0, -0.0042527702905061394, 0.03697916666666667,
                                             -0.05086379716981132, 0.0419047619047619, -0.025};

/* First and shortest step [TU]; a step is at most so much of the time in which the primer, the costates that the
   attitude depends on, would vanish: where it nearly does the attitude turns fast. */
#define FIRST_STEP 0.05
#define SHORTEST_STEP 1e-7
#define OF_PRIMER 0.3
/* By how much steps change at most. */
#define SHRINK 0.1
#define GROW 4.0
/* Halvings of the interval in which an event lies. */
#define HALVINGS 20
/* Newton's steps for the cone angle, and the tangent of the last one: what is left is its square. */
#define MOST_TURNS 5
#define LEAST_TURN 1e-5

/* An extremal on its way: between two events the law is smooth. */
typedef struct {
    const sailnet_problem *problem;
    double at_bound[2]; /* the force at the bound on the cone angle, radial and lateral */
    int32_t bound;      /* whether the cone angle is there */
    double side;        /* in the plane the sign that it has there */
} sailnet_arc;

SAILNET_TRACKER_API double sailnet_reciprocal_root(double value)
{
    uint64_t bits;
    double root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = UINT64_C(0x5FE6EB50C7B537A9) - (bits >> 1);
    (void)memcpy(&root, &bits, sizeof root);
    /* The bits err by 3.5 %: a step of fourth order and one of third leave rounding. */
    const double off = 1.0 - value * (root * root);
    root += root * off * ((0.5 + 0.375 * off) + 0.3125 * (off * off));
    const double rest = 1.0 - value * (root * root);
    return root + root * (rest * (0.5 + 0.375 * rest));
}

SAILNET_TRACKER_API double sailnet_root(double value)
{
    return value > 0.0 ? value * sailnet_reciprocal_root(value) : 0.0;
}

/* The force of a cone angle across the Sun line: radial, lateral. */
static void force_at(const sailnet_problem *problem, double cosine, double sine, double force[2])
{
    const double normal = problem->square * cosine + problem->linear;
    force[0] = cosine * (normal * cosine + problem->across * sine * sine);
    force[1] = cosine * sine * (normal - problem->across * cosine);
}

SAILNET_TRACKER_API double sailnet_work(const sailnet_problem *problem, const double costate[SAILNET_STATES],
                                        const sailnet_attitude *attitude)
{
    double force[2];
    double along = 0.0;
    force_at(problem, attitude->cosine, attitude->sine, force);
    for (int32_t i = 0; i < SAILNET_ACROSS; i++) {
        along += costate[STATES - SAILNET_ACROSS + i] * attitude->across[i];
    }
    return costate[STATES - SAILNET_ACROSS - 1] * force[0] + along * force[1];
}

SAILNET_TRACKER_API void sailnet_push_aside(sailnet_problem *problem, double tangential)
{
    const double c = problem->bound_cosine;
    const double s = sailnet_absolute(problem->bound_sine);
    problem->across += tangential;
    problem->edge_radial += tangential * s * (2.0 * c * c - s * s);
    problem->edge_lateral += tangential * c * (2.0 * s * s - c * c);
}

/*
 * The cone angle inside the bound that makes lambda_u f_r - lateral f_t least. Its slope, over the cube of the cosine, is of
 * third degree in the tangent, and in sine and cosine whatever their size. First the root of the quadratic next to it, which
 * for an ideal sail is the root; from there by Newton's steps.
 */
static void inside_the_bound(const sailnet_problem *problem, double lambda_u, double lateral, double *cosine,
                             double *sine)
{
    const double linear = problem->linear;
    const double across = problem->across;
    const double radial = 3.0 * problem->square - 2.0 * across;
    const double aside = problem->square - across;
    /* Near the cone angle of the largest force along, where tan^2 is 0.5. */
    const double length = 1.2247448713915890 * linear;
    const double x = -lambda_u * (radial + 0.5 * across + 2.0 * length);
    const double first = 2.0 * lateral * (2.0 * aside + length);
    const double last = 2.0 * lateral * (aside + length);
    const double size = sailnet_root(x * x + first * last);
    /* Of both forms of the root of first t^2 + 2 x t - last the exact one. */
    double c = x > 0.0 ? size + x : first;
    double s = x > 0.0 ? last : size - x;
    double step = ((linear != 0.0) || (across != 0.0)) ? 1.0 : 0.0;
    for (int32_t i = 0; (i < MOST_TURNS) && (sailnet_absolute(step) > LEAST_TURN); i++) {
        const double c2 = c * c;
        const double s2 = s * s;
        const double cubic = c * (c2 - 2.0 * s2);
        const double scaled = linear != 0.0 ? linear * sailnet_root(c2 + s2) : 0.0;
        const double slope = -lambda_u * (s * (radial * c2 + across * s2 + 2.0 * scaled * c)) -
                             lateral * (aside * cubic + scaled * (c2 - s2));
        const double bend = -lambda_u * (radial * cubic + 3.0 * across * c * s2 + 2.0 * scaled * (c2 - s2)) +
                            lateral * (s * (aside * (7.0 * c2 - 2.0 * s2) + 4.0 * scaled * c));
        step = bend > 0.0 ? -slope / bend : 0.0;
        const double turned = c - s * step;
        s += c * step;
        c = turned;
    }
    const double square2 = c * c + s * s;
    const double per = square2 > 0.0 ? sailnet_reciprocal_root(square2) : 0.0;
    *cosine = per > 0.0 ? c * per : 1.0;
    *sine = s * per;
}

/* Size of the costate across the Sun line. */
static double lateral_of(const double *unknown)
{
#if SAILNET_IN_SPACE
    return sailnet_root(unknown[LAMBDA_V] * unknown[LAMBDA_V] + unknown[LAMBDA_V + 1] * unknown[LAMBDA_V + 1]);
#else
    return sailnet_absolute(unknown[LAMBDA_V]);
#endif
}

/* Positive where the optimum is inside the bound. */
static double inner(const sailnet_problem *problem, const double *unknown)
{
    return unknown[LAMBDA_U] * problem->edge_radial - lateral_of(unknown) * problem->edge_lateral;
}

/* The force by the law of the present arc: radial, along, and in space northward. */
static void force_of(const sailnet_arc *arc, const double *unknown, double *force)
{
    const sailnet_problem *const problem = arc->problem;
    double in_plane[2] = {arc->at_bound[0], arc->at_bound[1]};
    const double lateral = lateral_of(unknown);
    if (arc->bound == 0) {
        double cosine;
        double sine;
        inside_the_bound(problem, unknown[LAMBDA_U], lateral, &cosine, &sine);
        force_at(problem, cosine, sine, in_plane);
    }
    force[0] = in_plane[0];
#if SAILNET_IN_SPACE
    const double per = lateral > 0.0 ? in_plane[1] / lateral : 0.0;
    force[1] = -per * unknown[LAMBDA_V];
    force[2] = -per * unknown[LAMBDA_V + 1];
#else
    const double side = arc->bound != 0 ? arc->side : (unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0);
    force[1] = side * in_plane[1];
#endif
}

/* Eq. (15): rates of the unknowns by the time to go, which are those by time with another sign. */
static void rates(const sailnet_arc *arc, const double *unknown, double *rate)
{
    const sailnet_problem *const problem = arc->problem;
    const double per_r = 1.0 / unknown[0];
    const double push = problem->beta * per_r * per_r;
    double force[3] = {0.0, 0.0, 0.0};
    force_of(arc, unknown, force);
#if SAILNET_IN_SPACE
    const double t = unknown[1];
    const double u = unknown[2];
    const double v = unknown[3];
    const double w = unknown[4];
    const double l_r = unknown[5];
    const double l_t = unknown[6];
    const double l_u = unknown[7];
    const double l_v = unknown[8];
    const double l_w = unknown[9];
    const double square = 1.0 + t * t;
    const double turn = v * t;
    const double work = push * (l_u * force[0] + l_v * force[1] + l_w * force[2]);
    rate[0] = -u;
    rate[1] = -square * w * per_r;
    rate[2] = -((v * v + w * w) * per_r - per_r * per_r + push * force[0]);
    rate[3] = (u * v - w * turn) * per_r - push * force[1];
    rate[4] = (u * w + v * turn) * per_r - push * force[2];
    rate[5] = -per_r * (per_r * (l_t * square * w + l_u * (v * v + w * w) - l_v * (u * v - w * turn) -
                                 l_w * (u * w + v * turn) - 2.0 * l_u * per_r) +
                        2.0 * work);
    rate[6] = per_r * (2.0 * l_t * t * w + v * (l_v * w - l_w * v));
    rate[7] = l_r - (l_v * v + l_w * w) * per_r;
    rate[8] = per_r * (2.0 * l_u * v - l_v * (u - w * t) - 2.0 * l_w * turn);
    rate[9] = per_r * (l_t * square + 2.0 * l_u * w + l_v * turn - l_w * u);
#else
    const double u = unknown[1];
    const double v = unknown[2];
    const double l_r = unknown[3];
    const double l_u = unknown[4];
    const double l_v = unknown[5];
    const double work = push * (l_u * force[0] + l_v * force[1]);
    rate[0] = -u;
    rate[1] = -(v * v * per_r - per_r * per_r + push * force[0]);
    rate[2] = u * v * per_r - push * force[1];
    rate[3] = -per_r * (per_r * (l_u * v * v - l_v * u * v - 2.0 * l_u * per_r) + 2.0 * work);
    rate[4] = l_r - l_v * v * per_r;
    rate[5] = per_r * (2.0 * l_u * v - l_v * u);
#endif
}

/* One step from `unknown`, whose rates are the first of the stages; returned is the estimate of its error. */
static double step_by(const sailnet_arc *arc, const double *unknown, double step, double stage[STAGES][UNKNOWNS],
                      double *reached)
{
    for (int32_t i = 0; i < (STAGES - 1); i++) {
        (void)memcpy(reached, unknown, UNKNOWNS * sizeof reached[0]);
        for (int32_t j = 0; j <= i; j++) {
            const double share = step * stage_weights[i][j];
            for (int32_t n = 0; n < UNKNOWNS; n++) {
                reached[n] += share * stage[j][n];
            }
        }
        rates(arc, reached, stage[i + 1]);
    }
    double size = 0.0;
    for (int32_t n = STATES; n < UNKNOWNS; n++) {
        size += sailnet_absolute(unknown[n]);
    }
    double error = 0.0;
    for (int32_t n = 0; n < UNKNOWNS; n++) {
        double sum = 0.0;
        for (int32_t j = 0; j < STAGES; j++) {
            sum += error_weights[j] * stage[j][n];
        }
        const double own = sailnet_absolute(step * sum);
        /* Relative to the size of all costates; what is not a number stays none. */
        const double counted = n < STATES ? own : own / size;
        error = counted <= error ? error : counted;
    }
    return error;
}

/*
 * The two functions that end an arc where they become negative: of the bound, and in the plane of the side there. In
 * space the thrust turns about the Sun line without a jump.
 */
static double guard(const sailnet_arc *arc, const double *unknown, int32_t which)
{
    const double inside = inner(arc->problem, unknown);
    double value = arc->bound != 0 ? -inside : inside;
    if (which != 0) {
        value = arc->bound != 0 ? -arc->side * unknown[LAMBDA_V] : 1.0;
    }
    return value;
}

/* Its slope: every guard is linear in the costates, but for the size of what is across the Sun line. */
static double guard_slope(const sailnet_arc *arc, const double *unknown, const double *rate, int32_t which)
{
    const sailnet_problem *const problem = arc->problem;
#if SAILNET_IN_SPACE
    const double lateral = lateral_of(unknown);
    const double change = (unknown[LAMBDA_V] * rate[LAMBDA_V] + unknown[LAMBDA_V + 1] * rate[LAMBDA_V + 1]) /
                          (lateral > 0.0 ? lateral : 1.0);
#else
    const double change = unknown[LAMBDA_V] < 0.0 ? -rate[LAMBDA_V] : rate[LAMBDA_V];
#endif
    const double inside = rate[LAMBDA_U] * problem->edge_radial - change * problem->edge_lateral;
    double slope = arc->bound != 0 ? -inside : inside;
    if (which != 0) {
        slope = arc->bound != 0 ? -arc->side * rate[LAMBDA_V] : 0.0;
    }
    return slope;
}

/* The share of a step after which a guard is negative: by the cubic of its values and slopes at both ends. */
static double share_until(double g0, double slope0, double g1, double slope1)
{
    double low = 0.0;
    double high = 1.0;
    for (int32_t i = 0; i < HALVINGS; i++) {
        const double x = 0.5 * (low + high);
        const double q = 1.0 - x;
        const double value =
            q * q * ((1.0 + 2.0 * x) * g0 + x * slope0) + x * x * ((3.0 - 2.0 * x) * g1 - q * slope1);
        if (value < 0.0) {
            high = x;
        } else {
            low = x;
        }
    }
    return high;
}

/* Which arc begins at `unknown`. */
static void begin_arc(sailnet_arc *arc, const double *unknown)
{
    arc->bound = inner(arc->problem, unknown) > 0.0 ? 0 : 1;
    arc->side = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
}

/* Which guard a step ends with, and when; -1 if it ends none. */
static int32_t event_in(const sailnet_arc *arc, const double *before, const double *after,
                        double stage[STAGES][UNKNOWNS], double *step)
{
    int32_t which = -1;
    const double whole = *step;
    for (int32_t i = 0; i < (SAILNET_IN_SPACE ? 1 : 2); i++) {
        const double g1 = guard(arc, after, i);
        if (g1 < 0.0) {
            /* Where the arc has just begun rounding may have left it a little below 0. */
            const double g0 = guard(arc, before, i);
            const double slope0 = guard_slope(arc, before, stage[0], i) * whole;
            const double slope1 = guard_slope(arc, after, stage[STAGES - 1], i) * whole;
            const double at = whole * share_until(g0 > 0.0 ? g0 : 0.0, slope0, g1, slope1);
            if ((which < 0) || (sailnet_absolute(at) < sailnet_absolute(*step))) {
                *step = at;
                which = i;
            }
        }
    }
    return which;
}

/* The fifth root of a positive number, to 3.4 %: of its bits, which are nearly its logarithm, and of which the upper half
   is divided by 5. */
static double about_fifth_root(double value)
{
    uint64_t bits;
    double root;
    (void)memcpy(&bits, &value, sizeof bits);
    bits = UINT64_C(0x3325CFAACD9E8600) + (bits >> 32) * UINT64_C(0x33333333);
    (void)memcpy(&root, &bits, sizeof root);
    return root;
}

/* What the next step is multiplied by. */
static double factor_of(double tolerance, double error)
{
    double factor = SHRINK;
    if (error <= 1e-6 * tolerance) {
        factor = GROW;
    } else if (error == error) {
        factor = 0.9 * about_fifth_root(tolerance / error);
    } else {
        /* It is not a number: much shorter. */
    }
    factor = factor > SHRINK ? factor : SHRINK;
    return factor < GROW ? factor : GROW;
}

/* A step, or the longest that the primer leaves. */
static double limited_step(const double *unknown, const double *rate, double step)
{
    double primer = 0.0;
    double change = 0.0;
    double limited = step;
#if SAILNET_IN_SPACE
    /* Where the thrust turns about the Sun line, it is what is across that line. */
    const int32_t first = unknown[LAMBDA_U] > 0.0 ? LAMBDA_V : LAMBDA_U;
#else
    const int32_t first = LAMBDA_U;
#endif
    for (int32_t n = first; n < UNKNOWNS; n++) {
        primer += unknown[n] * unknown[n];
        change += rate[n] * rate[n];
    }
    if (!(step * step * change <= OF_PRIMER * OF_PRIMER * primer)) {
        const double longest = OF_PRIMER * sailnet_root(primer / change);
        limited = longest > SHORTEST_STEP ? longest : SHORTEST_STEP;
    }
    return limited < step ? limited : step;
}

/* The first trial of `step` from `unknown` that ends an arc, or none: as in event_in; and to the event itself. */
static int32_t end_at_event(const sailnet_arc *arc, const double *unknown, double stage[STAGES][UNKNOWNS],
                            double *reached, double left, double *step)
{
    const int32_t which = event_in(arc, unknown, reached, stage, step);
    if (which >= 0) {
        (void)step_by(arc, unknown, *step, stage, reached);
        /* By one step of Newton's method. */
        const double slope = guard_slope(arc, reached, stage[STAGES - 1], which);
        const double more = slope != 0.0 ? -guard(arc, reached, which) / slope : 0.0;
        if ((sailnet_absolute(more) < 0.1 * sailnet_absolute(*step)) && (sailnet_absolute(*step + more) < left)) {
            *step += more;
            (void)step_by(arc, unknown, *step, stage, reached);
        }
    }
    return which;
}

/*
 * An end of an extremal, `span` [TU] farther from arrival; nearer, if that is negative. Its rates are computed.
 * Returns the steps it took; 0 if it did not get there.
 */
static int32_t fly(const sailnet_problem *problem, double span, double tolerance, sailnet_end *end)
{
    sailnet_arc arc = {problem, {0.0, 0.0}, 0, 1.0};
    double *const unknown = end->value;
    double stage[STAGES][UNKNOWNS];
    double reached[UNKNOWNS];
    const double sign = span < 0.0 ? -1.0 : 1.0;
    double left = sailnet_absolute(span);
    double wanted = FIRST_STEP;
    int32_t steps = 0;
    force_at(problem, problem->bound_cosine, problem->bound_sine, arc.at_bound);
    begin_arc(&arc, unknown);
    rates(&arc, unknown, stage[0]);
    while ((left > 0.0) && (steps < SAILNET_MOST_STEPS)) {
        const double longest = limited_step(unknown, stage[0], wanted);
        double step = sign * (longest < left ? longest : left);
        const double error = step_by(&arc, unknown, step, stage, reached);
        steps++;
        wanted = sign * step * factor_of(tolerance, error);
        if (error <= tolerance) {
            const int32_t which = end_at_event(&arc, unknown, stage, reached, left, &step);
            (void)memcpy(unknown, reached, sizeof reached);
            left = sign * step < left ? left - sign * step : 0.0;
            if (which == 0) {
                arc.bound = 1 - arc.bound;
                arc.side = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
            } else if (which > 0) {
                arc.side = -arc.side;
            } else {
                /* The same arc goes on. */
            }
            if (which >= 0) {
                wanted = FIRST_STEP;
                rates(&arc, unknown, stage[0]);
            } else {
                (void)memcpy(stage[0], stage[STAGES - 1], sizeof stage[0]);
            }
        }
    }
    (void)memcpy(end->rate, stage[0], sizeof end->rate);
    return left > 0.0 ? 0 : steps;
}

SAILNET_TRACKER_API int32_t sailnet_extremal(const sailnet_problem *problem, const double direction[SAILNET_STATES],
                                             double tau, double tolerance, sailnet_end *end)
{
    (void)memset(end->value, 0, sizeof end->value);
    end->value[0] = problem->target_radius;
    end->value[STATES - 1 - SAILNET_IN_SPACE] = sailnet_reciprocal_root(problem->target_radius);
    (void)memcpy(&end->value[STATES], direction, (size_t)STATES * sizeof direction[0]);
    return fly(problem, tau > 0.0 ? tau : 0.0, tolerance, end);
}

SAILNET_TRACKER_API int32_t sailnet_move_end(const sailnet_problem *problem, double lapse, double tolerance,
                                             sailnet_end *end)
{
    return fly(problem, -lapse, tolerance, end);
}

SAILNET_TRACKER_API void sailnet_optimal_attitude(const sailnet_problem *problem,
                                                  const double costate[SAILNET_STATES], sailnet_attitude *attitude)
{
    double unknown[UNKNOWNS] = {0.0};
    (void)memcpy(&unknown[STATES], costate, (size_t)STATES * sizeof costate[0]);
    const double lateral = lateral_of(unknown);
    if (inner(problem, unknown) > 0.0) {
        inside_the_bound(problem, unknown[LAMBDA_U], lateral, &attitude->cosine, &attitude->sine);
    } else {
        attitude->cosine = problem->bound_cosine;
        attitude->sine = problem->bound_sine;
    }
#if SAILNET_IN_SPACE
    const double per = lateral > 0.0 ? 1.0 / lateral : 0.0;
    attitude->across[0] = lateral > 0.0 ? -per * unknown[LAMBDA_V] : 1.0;
    attitude->across[1] = -per * unknown[LAMBDA_V + 1];
#else
    attitude->across[0] = unknown[LAMBDA_V] > 0.0 ? -1.0 : 1.0;
#endif
}
