/*
 * The plant: solar sails in closed loop with their guidance, for simulation on a host. Not flight software.
 *
 * Eq. (1), the disturbances and the rules of flight; the guidance comes in as a function. Nothing is
 * allocated and nothing static is written: the caller owns all memory, and calls may run side by side.
 * Units: AU, TU (the Sun's gravitational parameter is 1), rad.
 */
#ifndef SAILNET_PLANT_H
#define SAILNET_PLANT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever a structure or a function of this header changes. */
#define PLANT_API_VERSION 1

typedef struct {
    double r;     /* distance from the Sun [AU] */
    double theta; /* polar angle [rad] */
    double u;     /* radial speed [AU/TU] */
    double v;     /* transverse speed [AU/TU] */
    double dose;  /* of sunlight that fell on the sail: integral of cos(angle) / r^2 [TU / AU^2] */
} plant_state;

/*
 * A flat sail. Its force, in the direction of its normal and across, in units of beta / r^2, is
 *
 *     normal_square cos^2 + normal_linear cos   along the normal   (cos, sin),
 *     tangential cos sin                        along the tangent  (sin, -cos),
 *
 * where cos and sin are of the cone angle and the first component is the radial one. Ideal: 1, 0, 0.
 */
typedef struct {
    double normal_square;
    double normal_linear;
    double tangential;
} plant_optics;

/* What is the same for all flights. A disturbance is off at 0. */
typedef struct {
    double period;        /* guidance period [TU] */
    double longest;       /* no flight goes on for longer [TU] */
    double least_radius;  /* a sail nearer to the Sun is lost [AU] */
    double largest_radius;
    double tolerance;     /* of one integration step, relative to 1 + |state| */
    double target[3];     /* r, u, v */
    double beta;          /* the mission's normalised characteristic acceleration */
    plant_optics optics;

    double beta_bias;
    double beta_spread;
    double beta_drift;
    double beta_noise;
    double beta_wander;
    double beta_wander_time;
    double degradation_loss;
    double degradation_dose;
    double navigation_bias[3];
    double navigation_noise[3];
    double navigation_wander[3];
    double navigation_wander_time;
    double rate_limit;
    double delay;
    double resolution;
    double misalignment;
    double misalignment_spread;
    double outage_probability;
    double outage_duration;
    uint64_t seed;
} plant_rules;

typedef enum {
    PLANT_FLYING = 0,
    PLANT_STOPPED = 1, /* the guidance ended the flight */
    PLANT_LOST = 2,    /* out of the allowed distances from the Sun */
    PLANT_TOO_LONG = 3
} plant_ending;

/* One flight. The caller sets the state's r, u, v and the number; the rest starts as 0. */
typedef struct {
    plant_state state;
    double time;                 /* flown so far [TU] */
    double attitude;             /* where the actuator has turned the sail, without misalignment [rad] */
    double misalignment;         /* of this sail [rad] */
    double beta_error;           /* constant relative error of this sail's beta */
    double beta_wander;          /* the Gauss-Markov errors now, in units of their sigma */
    double navigation_wander[3];
    double step;                 /* what the integrator tries next [TU] */
    double beta_estimate;        /* the guidance's last */
    double max_cone_angle;       /* largest size of a command [rad] */
    double max_attitude;         /* largest size of the angle flown [rad] */
    double nearest_error;        /* smallest largest component of the deviation from the target, ... */
    double nearest_time;         /* ... at the end of a period, and when [TU] */
    uint64_t number;             /* of the flight, for the random numbers */
    uint32_t periods;
    uint32_t outside;            /* periods in which the guidance reported a state outside its domain */
    uint32_t outages;            /* periods without guidance */
    int32_t out;                 /* there is no guidance now */
    int32_t ending;              /* plant_ending */
    int32_t unused;
} plant_sail;

/* One period of one flight. */
typedef struct {
    double time;           /* at its start [TU] */
    double r, theta, u, v; /* then */
    double seen[3];        /* r, u, v as navigation had them; NaN in an outage */
    double cone_angle;     /* commanded [rad] */
    double attitude;       /* the angle flown at its end [rad] */
    double beta;           /* real */
    double beta_estimate;
    double time_of_flight; /* predicted [TU]; NaN in an outage */
    double status;         /* sailnet_status */
} plant_record;

/* sailnet_steer_batch of a flight library, in its precision; memories, states and commands are its own. */
typedef void (*plant_steer_f32)(uint64_t count, void *memories, const uint64_t *sails, const float *states,
                                float period, float *commands, int32_t *statuses);
typedef void (*plant_steer_f64)(uint64_t count, void *memories, const uint64_t *sails, const double *states,
                                double period, double *commands, int32_t *statuses);

/* Exactly one of the two functions is set. */
typedef struct {
    plant_steer_f32 f32;
    plant_steer_f64 f64;
    void *memories;
} plant_steering;

/* Flights side by side, and room for what is passed around. */
typedef struct {
    uint64_t count;
    uint64_t flying;        /* how many still fly */
    plant_sail *sails;      /* count */
    uint64_t *rows;         /* count; the first `flying` are the rows of those that fly */
    double *queue;          /* count * plant_queue_slots(): commands that may still take effect */
    void *states;           /* 3 * count numbers of the steering's precision */
    void *commands;         /* 4 * count of them */
    int32_t *statuses;      /* count */
    int32_t interrupted;    /* the steering may set it: the flights stop where they are */
    int32_t unused;
} plant_flights;

/* Numbers per sail in plant_flights.queue. */
uint64_t plant_queue_slots(const plant_rules *rules);

/*
 * Fly on for at most `periods` guidance periods; returns how many still fly. Unless `records` is null it
 * has room for periods * count; row `sail` of period p of this call is records[p * count + sail].
 */
uint64_t plant_fly(const plant_rules *rules, const plant_steering *steering, plant_flights *flights,
                   uint64_t periods, plant_record *records);

/*
 * Fly one sail for `duration` while its angle turns from `angle` at `rate`; the angle that counts is cut to
 * +-pi/2, where a flat sail is edge-on. *step is the integrator's first trial, 0 for all at once, and on
 * return what it would try next. Returns 0, with the state where it got to, if the sail left the allowed distances.
 */
int plant_hold(const plant_rules *rules, double beta, double angle, double rate, double duration,
               plant_state *state, double *step);

/*
 * The random numbers are a function of the seed, the flight, what they are for and the period, so that no
 * flight and no disturbance depends on another. Philox4x32-10: J. K. Salmon et al., "Parallel random
 * numbers: as easy as 1, 2, 3", SC 2011.
 */
void plant_philox(const uint32_t counter[4], const uint32_t key[2], uint32_t output[4]);

/* Uniform within (0, 1), and standard normal. */
double plant_uniform(uint64_t seed, uint64_t flight, uint32_t stream, uint32_t period);
double plant_normal(uint64_t seed, uint64_t flight, uint32_t stream, uint32_t period);

/* What a caller that loads this as a shared library has to check. */
uint32_t plant_api_version(void);
uint32_t plant_size_of_rules(void);
uint32_t plant_size_of_sail(void);
uint32_t plant_size_of_record(void);
uint32_t plant_size_of_flights(void);
const char *plant_sources_digest(void);

#ifdef __cplusplus
}
#endif

#endif
