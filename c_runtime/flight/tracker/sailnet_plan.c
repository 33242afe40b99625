#include "sailnet_plan.h"

#include <string.h>

#define STATES SAILNET_STATES
/* What is unknown of a plan: all components of the direction but one, and the time to go. */
#define TIME (STATES - 1)

/* Longest step of Newton's method: of the direction, per its largest component, and of the time to go [TU]. */
#define LARGEST_TURN 0.2
#define LARGEST_SHIFT 0.5
/* By how much the direction is changed to differentiate by it. */
#define DIFFERENCE 1e-5
/* A shorter step is given up: derivatives are renewed, or there is no way. */
#define SHORTEST_SHARE 1e-3
/* Of the residual: derivatives that leave more of it are renewed. */
#define STALE 0.5
/* A component that was the largest is replaced when it is less than so much of the one that is. */
#define STILL_LARGE 0.4
#define LEAST_TIME 1e-4
/* With another beta an extremal of the same family takes longer by at most so many shares of the time to go for each
   share of beta, and by so much [TU]. */
#define LATER_PER_BETA 5.0
#define LATER 0.005
/* The goal far from arrival [AU, AU/TU], and its smallest share. */
#define LARGEST_GOAL 1e-6
#define SMALLEST_SHARE 1e-4
/* Of the goal: the local error of extremals. */
#define TOLERANCE 0.01
/* A residual of what cannot be flown. */
#define NOWHERE 1e9

static double size_of(double value)
{
    return value < 0.0 ? -value : value;
}

double sailnet_plan_goal(double time_to_go)
{
    const double square = time_to_go * time_to_go;
    const double share = square < 1.0 ? square : 1.0;
    return LARGEST_GOAL * (share > SMALLEST_SHARE ? share : SMALLEST_SHARE);
}

/* A plan that is tried. */
typedef struct {
    double direction[STATES];
    double time_to_go;
    double error[STATES];
    double residual;
    sailnet_end end;
} trial;

static void fly_back(const sailnet_problem *problem, const double state[STATES], trial *tried)
{
    const double tolerance = TOLERANCE * sailnet_plan_goal(tried->time_to_go);
    const int32_t steps = sailnet_extremal(problem, tried->direction, tried->time_to_go, tolerance, &tried->end);
    double worst = 0.0;
    for (int32_t n = 0; n < STATES; n++) {
        tried->error[n] = state[n] - tried->end.value[n];
        const double size = size_of(tried->error[n]);
        worst = size <= worst ? worst : size;
    }
    tried->residual = ((steps > 0) && (worst < NOWHERE)) ? worst : NOWHERE;
}

/* Another direction: its components, per the largest, plus a share of a step. */
static void turn(const double from[STATES], int32_t largest, const double step[STATES], double share, double to[STATES])
{
    const double per = 1.0 / size_of(from[largest]);
    double square = 0.0;
    int32_t k = 0;
    for (int32_t n = 0; n < STATES; n++) {
        to[n] = from[n] * per;
        if (n != largest) {
            to[n] += share * step[k];
            k++;
        }
        square += to[n] * to[n];
    }
    const double scale = sailnet_inverse_root(square);
    for (int32_t n = 0; n < STATES; n++) {
        to[n] *= scale;
    }
}

/* By which component the others are divided: the largest, or still the one that was. */
static void choose_largest(sailnet_plan *plan)
{
    int32_t largest = 0;
    for (int32_t n = 1; n < STATES; n++) {
        if (size_of(plan->direction[n]) > size_of(plan->direction[largest])) {
            largest = n;
        }
    }
    const int32_t known = ((plan->largest >= 0) && (plan->largest < STATES)) ? plan->largest : largest;
    const double size = size_of(plan->direction[known]);
    if ((known != plan->largest) || !(size >= STILL_LARGE * size_of(plan->direction[largest]))) {
        plan->largest = largest;
        plan->differentiated = 0;
    }
}

/* The derivatives by differences. */
static void differentiate(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, const trial *at)
{
    trial near;
    plan->differentiated = 1;
    for (int32_t k = 0; k < TIME; k++) {
        double step[STATES] = {0.0};
        step[k] = DIFFERENCE;
        turn(at->direction, plan->largest, step, 1.0, near.direction);
        near.time_to_go = at->time_to_go;
        fly_back(problem, state, &near);
        if (near.residual >= NOWHERE) {
            plan->differentiated = 0;
        }
        for (int32_t n = 0; n < STATES; n++) {
            plan->jacobian[n][k] = (near.end.value[n] - at->end.value[n]) / DIFFERENCE;
        }
    }
}

/* Newton's step: solve jacobian step = error by elimination with pivots; 0 if there is no solution. */
static int32_t solve(const sailnet_plan *plan, const double error[STATES], double step[STATES])
{
    double m[STATES][STATES + 1];
    int32_t solved = 1;
    for (int32_t i = 0; i < STATES; i++) {
        (void)memcpy(m[i], plan->jacobian[i], sizeof plan->jacobian[i]);
        m[i][STATES] = error[i];
    }
    for (int32_t c = 0; c < STATES; c++) {
        int32_t pivot = c;
        for (int32_t i = c + 1; i < STATES; i++) {
            pivot = size_of(m[i][c]) > size_of(m[pivot][c]) ? i : pivot;
        }
        solved = size_of(m[pivot][c]) > 0.0 ? solved : 0;
        for (int32_t j = 0; j <= STATES; j++) {
            const double other = m[c][j];
            m[c][j] = m[pivot][j];
            m[pivot][j] = other;
        }
        for (int32_t i = 0; i < STATES; i++) {
            const double factor = i != c ? m[i][c] / m[c][c] : 0.0;
            for (int32_t j = c; j <= STATES; j++) {
                m[i][j] -= factor * m[c][j];
            }
        }
    }
    for (int32_t i = 0; i < STATES; i++) {
        step[i] = m[i][STATES] / m[i][i];
        solved = step[i] == step[i] ? solved : 0;
    }
    return solved;
}

/* The share of a step of Newton's method that is within bounds. */
static double share_within(const double step[STATES])
{
    double square = 0.0;
    for (int32_t k = 0; k < TIME; k++) {
        square += step[k] * step[k];
    }
    const double turned = square > 0.0 ? square * sailnet_inverse_root(square) : 0.0;
    const double by_turn = turned > LARGEST_TURN ? LARGEST_TURN / turned : 1.0;
    const double shift = size_of(step[TIME]);
    const double by_shift = shift > LARGEST_SHIFT ? LARGEST_SHIFT / shift : 1.0;
    return by_turn < by_shift ? by_turn : by_shift;
}

/* Broyden's update: derivatives that say of the last step what it did. */
static void mend(sailnet_plan *plan, const trial *before, const trial *after, const double step[STATES], double share)
{
    double moved[STATES];
    double square = 0.0;
    for (int32_t k = 0; k < STATES; k++) {
        moved[k] = k < TIME ? share * step[k] : after->time_to_go - before->time_to_go;
        square += moved[k] * moved[k];
    }
    for (int32_t n = 0; n < STATES; n++) {
        double innovation = after->end.value[n] - before->end.value[n];
        for (int32_t k = 0; k < STATES; k++) {
            innovation -= plan->jacobian[n][k] * moved[k];
        }
        for (int32_t k = 0; k < STATES; k++) {
            plan->jacobian[n][k] += innovation * moved[k] / square;
        }
    }
}

/* Take one damped step; 0 if it came no nearer. */
static int32_t advance(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, trial *best,
                       const double step[STATES], double share)
{
    trial tried;
    const double later = best->time_to_go + share * step[TIME];
    tried.time_to_go = later > LEAST_TIME ? later : LEAST_TIME;
    turn(best->direction, plan->largest, step, share, tried.direction);
    fly_back(problem, state, &tried);
    const int32_t nearer = tried.residual < best->residual ? 1 : 0;
    if (nearer != 0) {
        mend(plan, best, &tried, step, share);
        *best = tried;
    }
    return nearer;
}

int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES], int32_t most,
                             sailnet_plan *plan, sailnet_end *end)
{
    trial best;
    double step[STATES] = {0.0};
    const double goal = sailnet_plan_goal(plan->time_to_go);
    int32_t fresh = 0;
    int32_t going = 1;
    double scale = 1.0;
    (void)memcpy(best.direction, plan->direction, sizeof best.direction);
    best.time_to_go = plan->time_to_go > LEAST_TIME ? plan->time_to_go : LEAST_TIME;
    fly_back(problem, state, &best);
    const int32_t limit = most < SAILNET_MOST_EXTREMALS ? most : SAILNET_MOST_EXTREMALS;
    int32_t count = 1;
    while ((going != 0) && (count < limit) && (best.residual > goal) && (best.residual < NOWHERE)) {
        choose_largest(plan);
        const int32_t renewed = plan->differentiated == 0 ? TIME : 0;
        going = count < (limit - renewed) ? 1 : 0;
        if ((going != 0) && (renewed != 0)) {
            differentiate(problem, state, plan, &best);
            count += TIME;
            fresh = 1;
            scale = 1.0;
        }
        for (int32_t n = 0; n < STATES; n++) {
            plan->jacobian[n][TIME] = best.end.rate[n];
        }
        if ((going != 0) && (plan->differentiated != 0)) {
            plan->differentiated = solve(plan, best.error, step);
        }
        going = plan->differentiated != 0 ? going : 0;
        if (going != 0) {
            const double before = best.residual;
            const double share = scale * share_within(step);
            count++;
            if (advance(problem, state, plan, &best, step, share) != 0) {
                plan->differentiated = ((best.residual > STALE * before) && (fresh == 0)) ? 0 : 1;
                fresh = 0;
                scale = scale < 0.5 ? 2.0 * scale : 1.0;
            } else if (fresh == 0) {
                plan->differentiated = 0;
            } else {
                scale *= 0.25;
                going = scale > SHORTEST_SHARE ? 1 : 0;
            }
        }
    }
    (void)memcpy(plan->direction, best.direction, sizeof best.direction);
    plan->time_to_go = best.time_to_go;
    plan->residual = best.residual;
    *end = best.end;
    /* It is no more than the limit: the comparison shows that to an analyser. */
    return count < limit ? count : limit;
}

/* Whether a plan passes through the state that it was corrected for. */
static int32_t is_solved(const sailnet_plan *plan)
{
    return plan->residual <= sailnet_plan_goal(plan->time_to_go) ? 1 : 0;
}

int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES], double beta, int32_t most,
                      sailnet_plan *plan, sailnet_end *end)
{
    sailnet_problem own = *problem;
    const double largest = SAILNET_BETA_STEP * plan->beta;
    const double change = beta - plan->beta;
    const double step = change > largest ? largest : (change < -largest ? -largest : change);
    int32_t count = 0;
    int32_t moves = ((is_solved(plan) != 0) && (size_of(step) > 0.0)) ? most / 2 : 0;
    if (moves > 0) {
        sailnet_plan moved = *plan;
        moved.beta += step;
        own.beta = moved.beta;
        count = sailnet_correct_plan(&own, state, moves, &moved, end);
        const double later = moved.time_to_go - plan->time_to_go;
        const double tolerated = LATER_PER_BETA * size_of(step) / plan->beta * plan->time_to_go + LATER;
        if ((is_solved(&moved) != 0) && (later <= tolerated)) {
            *plan = moved;
        } else {
            moves = 0;
        }
    }
    if (moves == 0) {
        own.beta = plan->beta;
        count += sailnet_correct_plan(&own, state, most - count, plan, end);
    }
    return count;
}

void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end, double ahead,
                              sailnet_attitude *attitude)
{
    double costate[STATES];
    for (int32_t n = 0; n < STATES; n++) {
        costate[n] = end->value[STATES + n] - ahead * end->rate[STATES + n];
    }
    sailnet_optimal_attitude(problem, costate, attitude);
}
