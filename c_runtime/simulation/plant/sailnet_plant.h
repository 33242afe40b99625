/*
 * The plant: solar sails in closed loop with their guidance, for simulation on a host. Not flight software.
 *
 * Eq. (1) in three dimensions, the disturbances and the rules of flight; the guidance comes in as a function.
 * The plane is the same with latitude, northward speed and clock angle 0, and a cone angle with a sign. Nothing is
 * allocated and nothing static is written: the caller owns all memory, and calls may run side by side.
 * Units: AU, TU (the Sun's gravitational parameter is 1), rad.
 */
#ifndef SAILNET_PLANT_H
#define SAILNET_PLANT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Raised whenever a function of this header changes, or what a member of a structure means. */
#define PLANT_API_VERSION 7

/*
 * A structure is a list of its members, MEMBER(type, name, extent). From the same lines come the structure in C
 * and, by plant_describe, the names, types, offsets and sizes that a caller in another language builds its own
 * from: nobody has to type them again. An enumeration is a list of VALUE(name, number) likewise.
 */
#define PLANT_MEMBER(type, name, extent) type name extent;
#define PLANT_VALUE(name, number) PLANT_##name = (number),

/* Spherical, about the axis of the target orbit. */
#define PLANT_STATE(MEMBER)                                                                               \
    MEMBER(double, r, )        /* distance from the Sun [AU] */                                           \
    MEMBER(double, theta, )    /* longitude [rad] */                                                      \
    MEMBER(double, latitude, ) /* to the north of the target orbit's plane [rad] */                       \
    MEMBER(double, u, )        /* radial speed [AU/TU] */                                                 \
    MEMBER(double, v, )        /* transverse speed [AU/TU] */                                             \
    MEMBER(double, w, )        /* northward speed [AU/TU] */                                              \
    MEMBER(double, dose, )  /* of sunlight that fell on the sail: integral of cos(angle) / r^2 [TU/AU^2] */

typedef struct {
    PLANT_STATE(PLANT_MEMBER)
} plant_state;

/*
 * A flat sail. Its force, in the direction of its normal and across, in units of beta / r^2, is
 *
 *     normal_square cos^2 + normal_linear cos   along the normal   (cos, sin),
 *     tangential cos sin                        along the tangent  (sin, -cos),
 *
 * where cos and sin are of the cone angle, the first component is the radial one and the second that in the
 * direction across the Sun line in which the normal is tilted. Ideal: 1, 0, 0.
 */
#define PLANT_OPTICS(MEMBER)           \
    MEMBER(double, normal_square, )    \
    MEMBER(double, normal_linear, )    \
    MEMBER(double, tangential, )

typedef struct {
    PLANT_OPTICS(PLANT_MEMBER)
} plant_optics;

/*
 * Where a sail points: its normal is (cos cone, sin cone cos clock, sin cone sin clock), radial, transverse and
 * northward. In the plane the clock angle is 0. What is no number is edge-on.
 */
#define PLANT_ATTITUDE(MEMBER)      \
    MEMBER(double, cone_angle, )    \
    MEMBER(double, clock_angle, )

typedef struct {
    PLANT_ATTITUDE(PLANT_MEMBER)
} plant_attitude;

/*
 * A steady turn along a great circle: the normal is cos(angle) first + sin(angle) second. `first` is that point of the
 * circle which is nearest to the radial direction, and `second` at right angles to both: light falls on the sail while
 * the angle is within +-pi/2. In the plane they are radial and transverse, and the angle is the signed cone angle.
 */
#define PLANT_TURN(MEMBER)                                      \
    MEMBER(double, first, [3])  /* radial, transverse, north */ \
    MEMBER(double, second, [3]) /* likewise */                  \
    MEMBER(double, angle, )     /* at the start [rad] */        \
    MEMBER(double, rate, )      /* [rad/TU] */

typedef struct {
    PLANT_TURN(PLANT_MEMBER)
} plant_turn;

/* Of a state, as navigation shows it in space: r, latitude, u, v, w. */
#define PLANT_COMPONENTS 5

/* What is the same for all flights. A disturbance is off at 0; sailnet/disturbances.py says what each is. */
#define PLANT_RULES(MEMBER)                                                                        \
    MEMBER(double, period, )         /* guidance period [TU] */                                    \
    MEMBER(double, longest, )        /* no flight goes on for longer [TU] */                       \
    MEMBER(double, least_radius, )   /* a sail nearer to the Sun is lost [AU] */                   \
    MEMBER(double, largest_radius, ) /* and one farther away [AU] */                               \
    MEMBER(double, tolerance, )      /* of one integration step, relative to 1 + |state| */        \
    MEMBER(uint32_t, components, )   /* that the steering is shown: 3, r, u, v; 5, in space */     \
    MEMBER(double, target, [PLANT_COMPONENTS]) /* [AU, rad, AU/TU]; in the plane 0 for the others */  \
    MEMBER(double, bound, )          /* on the size of the cone angle [rad] */                     \
    MEMBER(double, reversal, )       /* a larger step of the command reverses the sail [rad] */    \
    MEMBER(double, beta_range, [2])  /* that the guidance's estimate of beta never leaves */       \
    MEMBER(double, beta, )           /* the mission's normalised characteristic acceleration */    \
    MEMBER(plant_optics, optics, )   /* of a sail whose optics_error is 0 */                       \
    MEMBER(double, beta_bias, )                                                                    \
    MEMBER(double, beta_spread, )                                                                  \
    MEMBER(double, beta_drift, )                                                                   \
    MEMBER(double, beta_noise, )                                                                   \
    MEMBER(double, beta_wander, )                                                                  \
    MEMBER(double, beta_wander_time, )                                                             \
    MEMBER(double, degradation_loss, )                                                             \
    MEMBER(double, degradation_dose, )                                                             \
    MEMBER(double, navigation_bias, [PLANT_COMPONENTS]) /* as the target, and the next two */      \
    MEMBER(double, navigation_noise, [PLANT_COMPONENTS])                                           \
    MEMBER(double, navigation_wander, [PLANT_COMPONENTS])                                          \
    MEMBER(double, navigation_wander_time, )                                                       \
    MEMBER(double, rate_limit, )                                                                   \
    MEMBER(double, delay, )                                                                        \
    MEMBER(double, resolution, )                                                                   \
    MEMBER(double, misalignment, )                                                                 \
    MEMBER(double, misalignment_spread, )                                                          \
    MEMBER(double, outage_probability, )                                                           \
    MEMBER(double, outage_duration, )                                                              \
    MEMBER(double, attitude_measured, ) /* in the plane */                                                      \
    MEMBER(double, attitude_noise, )                                                               \
    MEMBER(uint64_t, seed, )

typedef struct {
    PLANT_RULES(PLANT_MEMBER)
} plant_rules;

#define PLANT_ENDING(VALUE)                                        \
    VALUE(FLYING, 0)                                               \
    VALUE(STOPPED, 1)  /* the guidance ended the flight */         \
    VALUE(LOST, 2)     /* out of the allowed distances */          \
    VALUE(TOO_LONG, 3) /* at rules.longest */

typedef enum { PLANT_ENDING(PLANT_VALUE) } plant_ending;

/* Of how many sizes the steps of a command are told apart; plant_step_edge has their bounds. */
#define PLANT_STEP_SIZES 256

/* One flight. The caller sets the state's components, the number and the error of the optics; the rest starts as 0. */
#define PLANT_SAIL(MEMBER)                                                                                \
    MEMBER(plant_state, state, )                                                                          \
    MEMBER(double, time, )           /* flown so far [TU] */                                              \
    MEMBER(plant_attitude, attitude, ) /* where the actuator has turned the sail, no misalignment */      \
    MEMBER(double, misalignment, )   /* of this sail [rad] */                                             \
    MEMBER(double, mean_attitude, )  /* of the angle flown, over the last period, in the plane [rad] */   \
    MEMBER(double, beta_error, )     /* constant relative error of this sail's beta */                    \
    MEMBER(plant_optics, optics_error, ) /* by how much its optics differ from the rules'; the caller's */  \
    MEMBER(double, beta_wander, )    /* the Gauss-Markov errors now, in units of their sigma */           \
    MEMBER(double, navigation_wander, [PLANT_COMPONENTS])                                                 \
    MEMBER(double, step, )           /* what the integrator tries next [TU] */                            \
    MEMBER(double, beta_estimate, )  /* the guidance's last */                                            \
    MEMBER(double, max_cone_angle, ) /* largest size of a command's [rad] */                              \
    MEMBER(double, max_attitude, )   /* largest size of the cone angle flown [rad] */                     \
    MEMBER(double, command_slew, )   /* sum of the sizes of all steps of the command [rad] */             \
    MEMBER(double, attitude_slew, )  /* by how much the actuator has turned the sail in all [rad] */      \
    MEMBER(double, nearest_error, )  /* smallest largest component of the deviation from the target, the */ \
    MEMBER(double, nearest_time, )   /* latitude's times its r, at the end of a period, and when [TU] */  \
    MEMBER(uint64_t, number, )       /* of the flight, for the random numbers */                          \
    MEMBER(uint32_t, periods, )                                                                           \
    MEMBER(uint32_t, outside, )      /* periods in which the guidance reported a state it does not know */\
    MEMBER(uint32_t, outages, )      /* periods without navigation */                                     \
    MEMBER(uint32_t, reckoned, )     /* periods in which the guidance went by where the sail must be */       \
    MEMBER(uint32_t, beyond_bound, ) /* periods in which the angle flown was beyond the bound */          \
    MEMBER(uint32_t, beta_at_limit, ) /* periods with the estimate of beta at an end of its range */      \
    MEMBER(uint32_t, reversals, )    /* of the command, from one period to the next */                    \
    MEMBER(uint32_t, steps, [PLANT_STEP_SIZES]) /* of the command, likewise, by size */                   \
    MEMBER(int32_t, out, )           /* there is no navigation now */                                     \
    MEMBER(int32_t, ending, )        /* plant_ending */

typedef struct {
    PLANT_SAIL(PLANT_MEMBER)
} plant_sail;

/* One period of one flight. */
#define PLANT_RECORD(MEMBER)                                                                  \
    MEMBER(double, time, )           /* at its start [TU] */                                  \
    MEMBER(double, r, )              /* then, as the next five [AU, rad, AU/TU] */            \
    MEMBER(double, theta, )                                                                   \
    MEMBER(double, latitude, )                                                                \
    MEMBER(double, u, )                                                                       \
    MEMBER(double, v, )                                                                       \
    MEMBER(double, w, )                                                                       \
    MEMBER(double, seen, [PLANT_COMPONENTS]) /* as navigation had them; NaN in an outage */   \
    MEMBER(double, cone_angle, )     /* commanded, as the next [rad] */                       \
    MEMBER(double, clock_angle, )                                                             \
    MEMBER(double, attitude, )       /* the cone angle flown at its end [rad] */              \
    MEMBER(double, attitude_clock, ) /* and the clock angle [rad] */                          \
    MEMBER(double, beta, )           /* real */                                               \
    MEMBER(double, beta_estimate, )                                                           \
    MEMBER(double, time_of_flight, ) /* predicted [TU] */                                     \
    MEMBER(int32_t, status, )        /* plant_status */

typedef struct {
    PLANT_RECORD(PLANT_MEMBER)
} plant_record;

/*
 * What a guidance gives: sailnet_command and sailnet_status of an exported sailnet_guidance.h, in either
 * precision, in the plane or in space. guidance/same_interface.c, compiled with every exported guidance, holds them to that.
 */
#define PLANT_COMMAND(MEMBER, real)                                     \
    MEMBER(real, cone_angle, )     /* [rad] */                          \
    MEMBER(real, time_of_flight, ) /* predicted [TU] */                 \
    MEMBER(real, beta, )           /* the estimate */                   \
    MEMBER(real, hold, )           /* for how long to hold it [TU] */     \
    MEMBER(real, lambda_v, )       /* as in sailnet_guidance.h */
#define PLANT_COMMAND_IN_SPACE(MEMBER, real)                                    \
    MEMBER(real, cone_angle, )     /* [rad] */                                  \
    MEMBER(real, clock_angle, )    /* from the transverse direction to the north [rad] */ \
    MEMBER(real, time_of_flight, ) /* predicted [TU] */                         \
    MEMBER(real, beta, )           /* the estimate */                           \
    MEMBER(real, hold, )           /* for how long to hold it [TU] */           \
    MEMBER(real, lambda_v, )       /* as in sailnet_guidance.h */               \
    MEMBER(real, lambda_w, )       /* likewise */
#define PLANT_COMMAND_F32(MEMBER) PLANT_COMMAND(MEMBER, float)
#define PLANT_COMMAND_F64(MEMBER) PLANT_COMMAND(MEMBER, double)
#define PLANT_COMMAND_IN_SPACE_F32(MEMBER) PLANT_COMMAND_IN_SPACE(MEMBER, float)
#define PLANT_COMMAND_IN_SPACE_F64(MEMBER) PLANT_COMMAND_IN_SPACE(MEMBER, double)

typedef struct {
    PLANT_COMMAND_F32(PLANT_MEMBER)
} plant_command_f32;

typedef struct {
    PLANT_COMMAND_F64(PLANT_MEMBER)
} plant_command_f64;

typedef struct {
    PLANT_COMMAND_IN_SPACE_F32(PLANT_MEMBER)
} plant_command_in_space_f32;

typedef struct {
    PLANT_COMMAND_IN_SPACE_F64(PLANT_MEMBER)
} plant_command_in_space_f64;

#define PLANT_STATUS(VALUE)   \
    VALUE(OK, 0)              \
    VALUE(ARRIVED, 1)         \
    VALUE(OUTSIDE_DOMAIN, 2)  \
    VALUE(INVALID_INPUT, 3)   \
    VALUE(RECKONED, 4)        \
    VALUE(AT_LIMIT, 5)

typedef enum { PLANT_STATUS(PLANT_VALUE) } plant_status;

/* What a guidance is shown, one number after the other: its sailnet_state. */
#define PLANT_SHOWN(MEMBER, real) \
    MEMBER(real, r, )             \
    MEMBER(real, u, )             \
    MEMBER(real, v, )
#define PLANT_SHOWN_IN_SPACE(MEMBER, real) \
    MEMBER(real, r, )                      \
    MEMBER(real, latitude, )               \
    MEMBER(real, u, )                      \
    MEMBER(real, v, )                      \
    MEMBER(real, w, )

/*
 * sailnet_steer_batch of a flight library: entry i is of the sail numbered sails[i], whose memory it uses;
 * `states` holds r, u, v of one sail after the other, in space r, latitude, u, v, w, and `commands` has room for a
 * command of that kind and this precision each; `attitudes` is null, or has a mean cone angle [rad] each, or NaN.
 */
typedef void plant_steer_f32(uint64_t count, void *memories, const uint64_t *sails, const float *states,
                             const float *attitudes, float period, void *commands, int32_t *statuses);
typedef void plant_steer_f64(uint64_t count, void *memories, const uint64_t *sails, const double *states,
                             const double *attitudes, double period, void *commands, int32_t *statuses);

/* Exactly one of the two functions is set. */
#define PLANT_STEERING(MEMBER)        \
    MEMBER(plant_steer_f32 *, f32, )  \
    MEMBER(plant_steer_f64 *, f64, )  \
    MEMBER(void *, memories, )

typedef struct {
    PLANT_STEERING(PLANT_MEMBER)
} plant_steering;

/* Flights side by side, and room for what is passed around. */
#define PLANT_FLIGHTS(MEMBER)                                                                           \
    MEMBER(uint64_t, count, )                                                                           \
    MEMBER(uint64_t, flying, )     /* how many still fly */                                             \
    MEMBER(plant_sail *, sails, )  /* count */                                                          \
    MEMBER(uint64_t *, rows, )     /* count; the first `flying` are the rows of those that fly */       \
    MEMBER(plant_attitude *, queue, ) /* count * plant_queue_slots(): commands that may still take effect */\
    MEMBER(void *, states, )       /* components * count numbers of the steering's precision */         \
    MEMBER(void *, attitudes, )    /* count of the same */                                              \
    MEMBER(void *, commands, )     /* count commands of its precision, of the plane or in space */      \
    MEMBER(int32_t *, statuses, )  /* count */                                                          \
    MEMBER(int32_t, interrupted, ) /* the steering may set it: the flights stop where they are */

typedef struct {
    PLANT_FLIGHTS(PLANT_MEMBER)
} plant_flights;

/* Attitudes per sail in plant_flights.queue. */
uint64_t plant_queue_slots(const plant_rules *rules);

/*
 * Fly on for at most `periods` guidance periods; returns how many still fly. Unless `records` is null it
 * has room for periods * count; row `sail` of period p of this call is records[p * count + sail].
 */
uint64_t plant_fly(const plant_rules *rules, const plant_steering *steering, plant_flights *flights,
                   uint64_t periods, plant_record *records);

/* What optical coefficient number `which` of a flight's sail is drawn by: uniform within (-1, 1). */
double plant_coefficient_draw(uint64_t seed, uint64_t flight, uint32_t which);

/* Give a sail that has not flown yet its constant errors: beta_error and misalignment. The first period does so. */
void plant_depart(const plant_rules *rules, plant_sail *sail);

/*
 * Steps of a command are counted by size: `size` 0 is everything below the first edge, and from there on each
 * octave has 16 sizes of equal width. An edge is the upper one [rad]; what lies beyond the last counts there.
 */
double plant_step_edge(uint32_t size);

/* Count what the command is changed by [rad] from one period to the next; a NaN or an infinity is no step. */
void plant_count_step(const plant_rules *rules, double step, plant_sail *sail);

/*
 * Fly one sail of these optics for `duration` while it turns; no light falls on it where the angle of the turn is beyond
 * +-pi/2, where a flat sail is edge-on. *step is the integrator's first trial, 0 for all at once, and on
 * return what it would try next. Returns 0, with the state where it got to, if the sail left the allowed distances.
 */
int plant_hold(const plant_rules *rules, const plant_optics *optics, double beta, const plant_turn *turn,
               double duration, plant_state *state, double *step);

/* The unit normal of a sail. */
void plant_normal_of(const plant_attitude *attitude, double normal[3]);

/* Between the normals of two attitudes [rad]; NaN if one is no number. */
double plant_angle_between(const plant_attitude *one, const plant_attitude *other);

/* No turn: the rate is 0, and the angle the cone angle. */
void plant_keep(const plant_attitude *attitude, plant_turn *turn);

/*
 * The turn from one attitude to another along the shorter great circle, at 1 rad/TU; returns the angle that it takes
 * [rad]. Between opposite normals it passes the radial direction, and between the two radial ones the transverse. None,
 * of angle 0, leads from or to what is no number.
 */
double plant_turn_between(const plant_attitude *from, const plant_attitude *to, plant_turn *turn);

/* Where a turn is at an angle. */
plant_attitude plant_attitude_at(const plant_turn *turn, double angle);

/* The largest cone angle on the way of a turn of positive rate by this angle, but for its ends; 0 if there. */
double plant_widest_between(const plant_turn *turn, double angle);

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
const char *plant_sources_digest(void);

/*
 * Calls `visit` once for each structure above, with its size and no name, and then for each of its members,
 * with the type as it is written in C; an enumeration likewise, its values' numbers as offsets, sizes 0.
 */
typedef void plant_visit(const char *owner, const char *name, const char *type, uint64_t offset, uint64_t size);
void plant_describe(plant_visit *visit);

#ifdef __cplusplus
}
#endif

#endif
