/*
 * A sail that is a point mass, in the Sun's gravity and light alone: what the examples steer, in place of yours.
 * It is the sail that the flight file was made for, force and all, by the constants of sailnet_guidance.h.
 */
#ifndef POINT_MASS_H
#define POINT_MASS_H

#include "sailnet_guidance.h"

#include <math.h>

typedef struct {
    double r, u, v; /* [AU], [AU/TU] */
} point_mass;

/* How fast r, u and v change, at a cone angle [rad]. */
static inline point_mass point_mass_rates(point_mass at, double cone_angle)
{
    const double cosine = cos(cone_angle), sine = sin(cone_angle), gravity = 1.0 / (at.r * at.r);
    const double light = (double)SAILNET_BETA * gravity;
    const double along_normal = light * cosine * ((double)SAILNET_FORCE_SQUARE * cosine + (double)SAILNET_FORCE_LINEAR);
    const double along_surface = light * (double)SAILNET_FORCE_ACROSS * cosine * sine;
    const point_mass rates = {at.u,
                              at.v * at.v / at.r - gravity + along_normal * cosine + along_surface * sine,
                              -at.u * at.v / at.r + along_normal * sine - along_surface * cosine};
    return rates;
}

static inline point_mass point_mass_moved(point_mass from, point_mass rates, double time)
{
    const point_mass to = {from.r + time * rates.r, from.u + time * rates.u, from.v + time * rates.v};
    return to;
}

/* Where it is after a time [TU] at one cone angle: Runge and Kutta's method, a step for each guidance period. */
static inline point_mass point_mass_after(point_mass at, double cone_angle, double time)
{
    const point_mass k1 = point_mass_rates(at, cone_angle);
    const point_mass k2 = point_mass_rates(point_mass_moved(at, k1, 0.5 * time), cone_angle);
    const point_mass k3 = point_mass_rates(point_mass_moved(at, k2, 0.5 * time), cone_angle);
    const point_mass k4 = point_mass_rates(point_mass_moved(at, k3, time), cone_angle);
    at = point_mass_moved(at, k1, time / 6.0);
    at = point_mass_moved(at, k2, time / 3.0);
    at = point_mass_moved(at, k3, time / 3.0);
    return point_mass_moved(at, k4, time / 6.0);
}

#endif
