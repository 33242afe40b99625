#include "sailnet_plan.h"

#include <string.h>

#define STATES SAILNET_STATES
/* What is unknown of a plan: all components of the direction but one, and the time to go. */
#define TIME (STATES - 1)

/* Longest step of Newton's method: of the direction, per its largest component, and of the time to go [TU]. */
#define LARGEST_TURN 0.2
#define LARGEST_SHIFT 0.1
/* By how much the direction is changed to differentiate by it. */
#define DIFFERENCE 1e-5
/* A shorter step is given up: derivatives are renewed, or there is no way. */
#define SHORTEST_SHARE 1e-3
/* Of the residual: derivatives that leave more of it are renewed. */
#define STALE 0.5
/* Of the goal: a residual in which integration errors are a part. */
#define FLOOR 0.1
/* A component that was the largest is replaced when it is less than so much of the one that is. */
#define STILL_LARGE 0.4
#define LEAST_TIME 1e-4
/* The goal far from arrival [AU, AU/TU], and its smallest share. */
#define LARGEST_GOAL 4e-6
#define SMALLEST_SHARE 1e-4
/* Of the goal: the local error of extremals. */
#define TOLERANCE 0.03
/* A residual of what cannot be flown. */
#define NOWHERE 1e9

SAILNET_TRACKER_API double sailnet_plan_goal(double time_to_go)
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

static void compare(const double state[STATES], trial *tried)
{
    double worst = 0.0;
    for (int32_t n = 0; n < STATES; n++) {
        tried->error[n] = state[n] - tried->end.value[n];
        /* What is not a number leads nowhere. */
        const double size = sailnet_absolute(tried->error[n]);
        const double counted = size < NOWHERE ? size : NOWHERE;
        worst = counted > worst ? counted : worst;
    }
    tried->residual = worst;
}

static void fly_back(const sailnet_problem *problem, const double state[STATES], trial *tried)
{
    const double tolerance = TOLERANCE * sailnet_plan_goal(tried->time_to_go);
    const int32_t steps = sailnet_extremal(problem, tried->direction, tried->time_to_go, tolerance, &tried->end);
    compare(state, tried);
    tried->residual = steps > 0 ? tried->residual : NOWHERE;
}

/* Another direction: its components, per the largest, plus a share of a step. */
static void turn_direction(const double from[STATES], int32_t largest, const double step[STATES], double share,
                           double to[STATES])
{
    const double per = 1.0 / sailnet_absolute(from[largest]);
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
    const double scale = sailnet_reciprocal_root(square);
    for (int32_t n = 0; n < STATES; n++) {
        to[n] *= scale;
    }
}

/* By which component the others are divided: the largest, or still the one that was. */
static void choose_largest(sailnet_plan *plan)
{
    int32_t largest = 0;
    for (int32_t n = 1; n < STATES; n++) {
        if (sailnet_absolute(plan->direction[n]) > sailnet_absolute(plan->direction[largest])) {
            largest = n;
        }
    }
    const int32_t known = ((plan->largest >= 0) && (plan->largest < STATES)) ? plan->largest : largest;
    const double size = sailnet_absolute(plan->direction[known]);
    if ((known != plan->largest) || !(size >= STILL_LARGE * sailnet_absolute(plan->direction[largest]))) {
        plan->largest = largest;
        plan->differentiated = 0;
    }
}

/* The derivatives by differences. */
static void differentiate(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, const trial *at)
{
    trial near = *at;
    plan->differentiated = 1;
    for (int32_t k = 0; k < TIME; k++) {
        double step[STATES] = {0.0};
        step[k] = DIFFERENCE;
        turn_direction(at->direction, plan->largest, step, 1.0, near.direction);
        fly_back(problem, state, &near);
        if (near.residual >= NOWHERE) {
            plan->differentiated = 0;
        }
        for (int32_t n = 0; n < STATES; n++) {
            plan->jacobian[n][k] = (near.end.value[n] - at->end.value[n]) / DIFFERENCE;
        }
    }
}

SAILNET_TRACKER_API sailnet_problem sailnet_problem_of(const sailnet_problem *problem, const sailnet_plan *plan)
{
    sailnet_problem own = *problem;
    own.beta = plan->beta;
    sailnet_push_aside(&own, plan->across - problem->across);
    return own;
}

SAILNET_TRACKER_API int32_t sailnet_is_for(const sailnet_plan *plan, const sailnet_problem *problem)
{
    return ((plan->beta == problem->beta) && (plan->across == problem->across)) ? 1 : 0;
}

/* The derivative by what differs of another vehicle, `change`; of a plan that cannot be flown by that it is none. */
static void differentiate_by_one(const sailnet_problem *other, const double state[STATES], double change,
                                 sailnet_plan *plan, double derivative[STATES])
{
    trial near;
    (void)memset(&near, 0, sizeof near);
    (void)memcpy(near.direction, plan->direction, sizeof near.direction);
    near.time_to_go = plan->time_to_go;
    fly_back(other, state, &near);
    if (near.residual >= NOWHERE) {
        plan->differentiated = 1;
    }
    for (int32_t n = 0; n < STATES; n++) {
        derivative[n] = (near.end.value[n] - plan->end.value[n]) / change;
    }
}

/* Both derivatives by the vehicle: two extremals. */
static void differentiate_by_vehicle(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan)
{
    const sailnet_problem own = sailnet_problem_of(problem, plan);
    sailnet_problem stronger = own;
    sailnet_problem aside = own;
    const double change = DIFFERENCE * plan->beta;
    stronger.beta += change;
    sailnet_push_aside(&aside, DIFFERENCE);
    plan->differentiated = 2;
    differentiate_by_one(&stronger, state, change, plan, plan->per_beta);
    differentiate_by_one(&aside, state, DIFFERENCE, plan, plan->per_across);
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
            pivot = sailnet_absolute(m[i][c]) > sailnet_absolute(m[pivot][c]) ? i : pivot;
        }
        solved = sailnet_absolute(m[pivot][c]) > 0.0 ? solved : 0;
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
    const double turned = square > 0.0 ? square * sailnet_reciprocal_root(square) : 0.0;
    const double by_turn = turned > LARGEST_TURN ? LARGEST_TURN / turned : 1.0;
    const double shift = sailnet_absolute(step[TIME]);
    const double by_shift = shift > LARGEST_SHIFT ? LARGEST_SHIFT / shift : 1.0;
    return by_turn < by_shift ? by_turn : by_shift;
}

/* Broyden's update: derivatives that say of the last step what it did, and of the change of the vehicle, by beta and by
   the force along the surface, which what was before has in it as predicted. */
static void mend(sailnet_plan *plan, const trial *before, const trial *after, const double step[STATES], double share,
                 const double change[2])
{
    double moved[STATES];
    double square = change[0] * change[0] + change[1] * change[1];
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
        plan->per_beta[n] += innovation * change[0] / square;
        plan->per_across[n] += innovation * change[1] / square;
    }
}

static void differentiate_by_time(sailnet_plan *plan, const sailnet_end *end)
{
    for (int32_t n = 0; n < STATES; n++) {
        plan->jacobian[n][TIME] = end->rate[n];
    }
}

SAILNET_TRACKER_API void sailnet_bring_up(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          sailnet_plan *plan)
{
    const sailnet_problem own = sailnet_problem_of(problem, plan);
    trial now;
    int32_t steps = 1;
    if (plan->age > 0.0) {
        const double tolerance = TOLERANCE * sailnet_plan_goal(plan->time_to_go);
        steps = sailnet_move_end(&own, plan->age, tolerance, &plan->end);
        plan->age = 0.0;
    }
    now.end = plan->end;
    compare(state, &now);
    plan->residual = steps > 0 ? now.residual : NOWHERE;
}

/* How far a correction has come. */
typedef struct {
    trial best;
    double damped;
    /* Whether `best` is where an extremal is predicted to end, and none that was flown; and then by how much the vehicle
       changes, in beta and in the force along the surface. */
    int32_t predicted;
    double change[2];
    /* Whether the derivatives are those of `best`. */
    int32_t fresh;
} search;

/* The plan as it is predicted to be now, or as it is. Returned are the extremals that were computed. */
static int32_t begin(const sailnet_problem *problem, const double state[STATES], int32_t most, sailnet_plan *plan,
                     search *at)
{
    trial *const best = &at->best;
    (void)memset(at, 0, sizeof *at);
    (void)memcpy(best->direction, plan->direction, sizeof best->direction);
    best->time_to_go = plan->time_to_go > LEAST_TIME ? plan->time_to_go : LEAST_TIME;
    at->damped = 1.0;
    choose_largest(plan);
    at->predicted = ((plan->differentiated != 0) && (most > 1)) ? 1 : 0;
    if (at->predicted != 0) {
        at->change[0] = problem->beta - plan->beta;
        at->change[1] = problem->across - plan->across;
        sailnet_bring_up(problem, state, plan);
        best->end = plan->end;
        for (int32_t n = 0; n < STATES; n++) {
            best->end.value[n] += plan->per_beta[n] * at->change[0] + plan->per_across[n] * at->change[1];
        }
        compare(state, best);
    } else {
        fly_back(problem, state, best);
    }
    return 1 - at->predicted;
}

/* Take one damped step; 0 if it came no nearer. Derivatives learn nothing from a residual in which integration errors are a
   part. */
static int32_t advance(const sailnet_problem *problem, const double state[STATES], sailnet_plan *plan, search *at)
{
    double step[STATES];
    int32_t nearer = 0;
    if (solve(plan, at->best.error, step) != 0) {
        const double share = at->damped * share_within(step);
        const double later = at->best.time_to_go + share * step[TIME];
        trial tried;
        tried = at->best;
        tried.time_to_go = later > LEAST_TIME ? later : LEAST_TIME;
        turn_direction(at->best.direction, plan->largest, step, share, tried.direction);
        fly_back(problem, state, &tried);
        const int32_t within = tried.residual <= (FLOOR * sailnet_plan_goal(plan->time_to_go)) ? 1 : 0;
        nearer = ((within != 0) || (tried.residual < at->best.residual)) ? 1 : 0;
        if ((nearer != 0) && (within == 0)) {
            const int32_t stale = tried.residual > (STALE * at->best.residual) ? 1 : 0;
            mend(plan, &at->best, &tried, step, share, at->change);
            plan->differentiated = ((stale != 0) && (at->fresh == 0)) ? 0 : plan->differentiated;
        }
        if (nearer != 0) {
            at->best = tried;
        }
    }
    return nearer;
}

SAILNET_TRACKER_API int32_t sailnet_correct_plan(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                                 int32_t most, sailnet_plan *plan)
{
    search at;
    const trial *const best = &at.best;
    const double goal = sailnet_plan_goal(plan->time_to_go);
    int32_t going = 1;
    const int32_t limit = most < SAILNET_MOST_EXTREMALS ? most : SAILNET_MOST_EXTREMALS;
    int32_t count = begin(problem, state, limit, plan, &at);
    while ((going != 0) && (count < limit) &&
           ((at.predicted != 0) || ((best->residual < NOWHERE) && ((best->residual > goal) || (plan->differentiated == 0))))) {
        choose_largest(plan);
        const int32_t renewed = plan->differentiated == 0 ? TIME : 0;
        going = count < (limit - renewed) ? 1 : 0;
        if ((going != 0) && (renewed != 0)) {
            differentiate(problem, state, plan, best);
            count += TIME;
            at.fresh = 1;
        }
        differentiate_by_time(plan, &best->end);
        going = plan->differentiated != 0 ? going : 0;
        if (going != 0) {
            count++;
            if (advance(problem, state, plan, &at) != 0) {
                at.fresh = 0;
                at.damped = at.damped < 0.5 ? 2.0 * at.damped : 1.0;
            } else if (at.fresh == 0) {
                plan->differentiated = 0;
                if (at.predicted != 0) {
                    fly_back(problem, state, &at.best);
                    count++;
                }
            } else {
                at.damped *= 0.25;
                going = at.damped > SHORTEST_SHARE ? 1 : 0;
            }
            at.predicted = 0;
            at.change[0] = 0.0;
            at.change[1] = 0.0;
        }
    }
    (void)memcpy(plan->direction, best->direction, sizeof best->direction);
    plan->time_to_go = best->time_to_go;
    plan->beta = problem->beta;
    plan->across = problem->across;
    plan->residual = best->residual;
    plan->end = best->end;
    plan->age = 0.0;
    plan->differentiated = best->residual < NOWHERE ? plan->differentiated : 0;
    /* It is no more than the limit: the comparison shows that to an analyser. */
    return count < limit ? count : limit;
}

SAILNET_TRACKER_API int32_t sailnet_plan_is_solved(const sailnet_plan *plan)
{
    return plan->residual <= sailnet_plan_goal(plan->time_to_go) ? 1 : 0;
}

SAILNET_TRACKER_API int32_t sailnet_track(const sailnet_problem *problem, const double state[SAILNET_STATES],
                                          double largest, int32_t most, sailnet_plan *plan)
{
    const double stronger = problem->beta - plan->beta;
    const double aside = problem->across - plan->across;
    const double by_beta = sailnet_absolute(stronger) / plan->beta;
    const double by_aside = sailnet_absolute(aside);
    const double by = by_beta > by_aside ? by_beta : by_aside;
    int32_t count = 0;
    int32_t moves = by > 0.0 ? most - 2 : 0;
    if (moves > 0) {
        sailnet_problem next = *problem;
        if (by > largest) {
            const double share = largest / by;
            next.beta = plan->beta + share * stronger;
            sailnet_push_aside(&next, (share - 1.0) * aside);
        }
        if ((plan->differentiated == 1) && (moves > 3)) {
            sailnet_bring_up(problem, state, plan);
            differentiate_by_vehicle(problem, state, plan);
            count = 2;
        }
        sailnet_plan moved = *plan;
        count += sailnet_correct_plan(&next, state, moves - count, &moved);
        if (sailnet_plan_is_solved(&moved) != 0) {
            *plan = moved;
        } else {
            moves = 0;
        }
    }
    if (moves <= 0) {
        const sailnet_problem own = sailnet_problem_of(problem, plan);
        count += sailnet_correct_plan(&own, state, most - count, plan);
    }
    return count;
}

SAILNET_TRACKER_API void sailnet_planned_attitude(const sailnet_problem *problem, const sailnet_end *end,
                                                  double ahead, double costates[SAILNET_STATES],
                                                  sailnet_attitude *attitude)
{
    double product = 0.0;
    for (int32_t n = 0; n < STATES; n++) {
        costates[n] = end->value[STATES + n] - ahead * end->rate[STATES + n];
        /* Rates are by the time to go. */
        product += end->value[STATES + n] * end->rate[n];
    }
    sailnet_optimal_attitude(problem, costates, attitude);
    for (int32_t n = 0; n < STATES; n++) {
        costates[n] = product != 0.0 ? costates[n] / product : 0.0;
    }
}
