/* Where a sail points, and how it turns: normals and great circles. */
#include <math.h>

#include "sailnet_plant.h"

#define PI 3.14159265358979323846
#define RIGHT_ANGLE 1.57079632679489661923

/* Opposite normals, or equal ones, leave this of a common perpendicular to rounding. */
#define LEAST_SINE 1e-12

static void cross(const double a[3], const double b[3], double product[3])
{
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double length(const double a[3])
{
    return sqrt(dot(a, a));
}

static void normalise(double a[3])
{
    const double size = length(a);
    for (int i = 0; i < 3; i++) {
        a[i] /= size;
    }
}

void plant_normal_of(const plant_attitude *attitude, double normal[3])
{
    const double across = sin(attitude->cone_angle);
    normal[0] = cos(attitude->cone_angle);
    normal[1] = across * cos(attitude->clock_angle);
    normal[2] = across * sin(attitude->clock_angle);
}

double plant_angle_between(const plant_attitude *one, const plant_attitude *other)
{
    double a[3];
    double b[3];
    double perpendicular[3];
    plant_normal_of(one, a);
    plant_normal_of(other, b);
    cross(a, b, perpendicular);
    return atan2(length(perpendicular), dot(a, b));
}

static int is_number(const plant_attitude *attitude)
{
    return isfinite(attitude->cone_angle) && isfinite(attitude->clock_angle);
}

void plant_keep(const plant_attitude *attitude, plant_turn *turn)
{
    const int known = is_number(attitude);
    const plant_turn kept = {
        .first = {1.0, 0.0, 0.0},
        .second = {0.0, known ? cos(attitude->clock_angle) : 1.0, known ? sin(attitude->clock_angle) : 0.0},
        .angle = known ? attitude->cone_angle : RIGHT_ANGLE,
    };
    *turn = kept;
}

/* The perpendicular to the plane of a turn, of length 1. */
static void axis_between(const double from[3], const double to[3], double axis[3])
{
    static const double radial[3] = {1.0, 0.0, 0.0};
    static const double transverse[3] = {0.0, 1.0, 0.0};
    cross(from, to, axis);
    if (length(axis) < LEAST_SINE && dot(from, to) < 0.0) {
        cross(from, radial, axis);
        if (length(axis) < LEAST_SINE) {
            cross(from, transverse, axis);
        }
    }
    normalise(axis);
    /* That of a short turn is known no better than its direction; but the normal is to be on the circle. */
    const double off = dot(axis, from);
    for (int i = 0; i < 3; i++) {
        axis[i] -= off * from[i];
    }
    normalise(axis);
}

double plant_turn_between(const plant_attitude *from, const plant_attitude *to, plant_turn *turn)
{
    double start[3];
    double end[3];
    double axis[3];
    const double angle = plant_angle_between(from, to);
    if (!is_number(from) || !is_number(to) || !(angle > 0.0)) {
        plant_keep(to, turn);
        return 0.0;
    }
    plant_normal_of(from, start);
    plant_normal_of(to, end);
    axis_between(start, end, axis);
    const double tilt = hypot(axis[1], axis[2]);
    if (tilt < LEAST_SINE) { /* no point of the circle is nearer to the radial direction than another */
        for (int i = 0; i < 3; i++) {
            turn->first[i] = start[i];
        }
        cross(axis, start, turn->second);
    }
    else {
        const plant_turn found = {
            .first = {tilt, -axis[0] * axis[1] / tilt, -axis[0] * axis[2] / tilt},
            .second = {0.0, axis[2] / tilt, -axis[1] / tilt},
        };
        *turn = found;
    }
    turn->angle = atan2(dot(start, turn->second), dot(start, turn->first));
    if (turn->angle > RIGHT_ANGLE) { /* from the dark: so that a turn of pi ends below 3/2 pi, where it is dark too */
        turn->angle -= 2.0 * PI;
    }
    turn->rate = 1.0;
    return angle;
}

plant_attitude plant_attitude_at(const plant_turn *turn, double angle)
{
    double normal[3];
    for (int i = 0; i < 3; i++) {
        normal[i] = cos(angle) * turn->first[i] + sin(angle) * turn->second[i];
    }
    /* A negative zero would turn the clock angle by pi. */
    const plant_attitude found = {
        .cone_angle = atan2(hypot(normal[1], normal[2]), normal[0]),
        .clock_angle = atan2(normal[2] + 0.0, normal[1] + 0.0),
    };
    return found;
}

double plant_widest_between(const plant_turn *turn, double angle)
{
    const double end = turn->angle + angle;
    const int passes = (turn->angle < -PI && end > -PI) || end > PI;
    return passes ? acos(-turn->first[0]) : 0.0;
}
