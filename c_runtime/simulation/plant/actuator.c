/* What becomes of a command: when it takes effect, how fast the sail turns, where it points then. */
#include <math.h>

#include "parts.h"
#include "sailnet_plant.h"

/* A rounding error is not a period. */
plant_lateness plant_delay(const plant_rules *rules)
{
    const double whole = floor(rules->delay / rules->period + 1e-9);
    const plant_lateness late = {
        .whole = (uint64_t)whole,
        .rest = fmax(0.0, rules->delay - whole * rules->period),
        .slots = (uint64_t)whole + 2u,
    };
    return late;
}

uint64_t plant_queue_slots(const plant_rules *rules)
{
    return plant_delay(rules).slots;
}

double plant_step_between(const plant_rules *rules, const plant_attitude *from, const plant_attitude *to)
{
    return plant_in_space(rules) ? plant_angle_between(from, to) : to->cone_angle - from->cone_angle;
}

/* The normal is turned about the northward direction. */
plant_attitude plant_misaligned(const plant_rules *rules, const plant_sail *sail, const plant_attitude *attitude)
{
    plant_attitude real = *attitude;
    if (!plant_in_space(rules)) {
        real.cone_angle += sail->misalignment;
    }
    else if (sail->misalignment != 0.0) {
        const double c = cos(sail->misalignment);
        const double s = sin(sail->misalignment);
        double normal[3];
        plant_normal_of(attitude, normal);
        const plant_turn turned = {
            .first = {c * normal[0] - s * normal[1], s * normal[0] + c * normal[1], normal[2]},
        };
        real = plant_attitude_at(&turned, 0.0);
    }
    return real;
}

/* About the plane's normal. */
static plant_turn in_plane(double cone_angle, double rate)
{
    const plant_turn turn = {
        .first = {1.0, 0.0, 0.0},
        .second = {0.0, 1.0, 0.0},
        .angle = cone_angle,
        .rate = rate,
    };
    return turn;
}

/* The way from one attitude to another at 1 rad/TU, and how far it is [rad]. In the plane the cone angle has a sign. */
static double way_between(const plant_rules *rules, const plant_attitude *from, const plant_attitude *to,
                          plant_turn *turn)
{
    if (plant_in_space(rules)) {
        return plant_turn_between(from, to, turn);
    }
    const double change = to->cone_angle - from->cone_angle;
    *turn = in_plane(from->cone_angle, copysign(1.0, change));
    return fabs(change);
}

static plant_optics optics_of(const plant_rules *rules, const plant_sail *sail)
{
    plant_optics own = rules->optics;
    own.normal_square += sail->optics_error.normal_square;
    own.normal_linear += sail->optics_error.normal_linear;
    own.tangential += sail->optics_error.tangential;
    return own;
}

/* Turn steadily to the attitude `end`, or stay where it is at rate 0; in the plane the rate has a sign. */
static int hold(const plant_rules *rules, plant_sail *sail, double beta, const plant_attitude *end, double rate,
                double duration, plant_flown *flown)
{
    const plant_attitude from = plant_misaligned(rules, sail, &sail->attitude);
    const plant_attitude to = plant_misaligned(rules, sail, end);
    plant_turn turn = in_plane(from.cone_angle, rate);
    flown->widest = fmax(flown->widest, fmax(fabs(from.cone_angle), fabs(to.cone_angle)));
    if (!plant_in_space(rules)) {
        flown->integral += 0.5 * (from.cone_angle + to.cone_angle) * duration;
    }
    else if (rate > 0.0) {
        const double way = plant_turn_between(&from, &to, &turn);
        turn.rate *= rate;
        flown->widest = fmax(flown->widest, plant_widest_between(&turn, way));
    }
    else {
        plant_keep(&from, &turn);
    }
    const plant_optics optics = optics_of(rules, sail);
    const int inside = plant_hold(rules, &optics, beta, &turn, duration, &sail->state, &sail->step);
    sail->attitude = *end;
    return inside;
}

/* Where a way ends that is not flown to its end. */
static plant_attitude part_of_the_way(const plant_rules *rules, const plant_turn *turn, double done,
                                      const plant_attitude *from, const plant_attitude *to)
{
    plant_attitude end = {.cone_angle = turn->angle + turn->rate * done, .clock_angle = 0.0};
    if (plant_in_space(rules)) {
        end = plant_attitude_at(turn, turn->angle + done);
        /* Not beyond both ends by a rounding error. */
        const double widest = fmax(fmax(from->cone_angle, to->cone_angle), plant_widest_between(turn, done));
        end.cone_angle = fmin(end.cone_angle, widest);
    }
    return end;
}

int plant_obey(const plant_rules *rules, plant_sail *sail, double beta, const plant_attitude *wanted, double duration,
               plant_flown *flown)
{
    if (!(duration > 0.0)) {
        return 1;
    }
    const plant_attitude before = sail->attitude;
    double left = duration;
    int inside = 1;
    plant_turn turn;
    const double way = rules->rate_limit > 0.0 ? way_between(rules, &before, wanted, &turn) : 0.0;
    if (way != 0.0) {
        const double needed = way / rules->rate_limit;
        const double turning = fmin(needed, duration);
        plant_attitude end = *wanted;
        if (!(needed <= duration)) {
            end = part_of_the_way(rules, &turn, rules->rate_limit * turning, &before, wanted);
        }
        inside = hold(rules, sail, beta, &end, turn.rate * rules->rate_limit, turning, flown);
        left -= turning;
    }
    else {
        sail->attitude = *wanted;
    }
    const double turned = fabs(plant_step_between(rules, &before, &sail->attitude));
    sail->attitude_slew += isfinite(turned) ? turned : 0.0;
    return inside && (left <= 0.0 || hold(rules, sail, beta, &sail->attitude, 0.0, left, flown));
}
