/*
 * Neural optimal guidance of a solar sail: from the sail's state to its cone angle.
 *
 * Exported by sailnet 0.1.0 for mission earth_mars: do not edit.
 * mission   8e635bded4d06c12013caf69c2d0728590d8bf221654a69d7bc1d143630b995c
 * networks  ea9fc0b64e36ac834d83abd156f998b3aa8d75c2c22b6411240d0cadb51fabda
 * data set  7acd82303abce87c3b36b61aace71e4f77c6bf6e870c8d0c394c820c64139091 (tau)
 * data set  7acd82303abce87c3b36b61aace71e4f77c6bf6e870c8d0c394c820c64139091 (alpha_pre)
 * data set  7acd82303abce87c3b36b61aace71e4f77c6bf6e870c8d0c394c820c64139091 (lambda_v)
 *
 * C99 (also C++11), freestanding: nothing is allocated, nothing static is written, no libm.
 * One compilation is one precision: float, or double with -DSAILNET_FLOAT64; the same flag must
 * be given wherever this header is included.
 */
#ifndef SAILNET_GUIDANCE_H
#define SAILNET_GUIDANCE_H

#ifdef __cplusplus
extern "C" {
#endif

#define SAILNET_API_VERSION 1
#define SAILNET_VERSION "0.1.0"
#define SAILNET_MISSION "earth_mars"
#define SAILNET_MISSION_DIGEST "8e635bded4d06c12013caf69c2d0728590d8bf221654a69d7bc1d143630b995c"
#define SAILNET_NETWORKS_DIGEST "ea9fc0b64e36ac834d83abd156f998b3aa8d75c2c22b6411240d0cadb51fabda"

#ifdef SAILNET_FLOAT64
typedef double sailnet_real;
#define SAILNET_REAL(literal) literal
/* Bound on the cone angle [rad], Eq. (3). */
#define SAILNET_PHI_MAX 1.0471975511965976
#else
typedef float sailnet_real;
#define SAILNET_REAL(literal) literal##f
/* Bound on the cone angle [rad], Eq. (3); rounded down, so that no command exceeds the real bound. */
#define SAILNET_PHI_MAX 1.0471974611282349f
#endif

/* A shorter predicted time of flight [TU] is an arrival. */
#define SAILNET_ARRIVAL_THRESHOLD SAILNET_REAL(0.005)
/* The longest time of flight [TU] the networks were trained on. */
#define SAILNET_LARGEST_TIME_OF_FLIGHT SAILNET_REAL(10.0)

/* Polar state in the orbital plane. One TU is the time in which a circular orbit at 1 AU turns by 1 rad. */
typedef struct {
    sailnet_real r; /* distance from the Sun [AU] */
    sailnet_real u; /* radial speed [AU/TU] */
    sailnet_real v; /* transverse speed [AU/TU] */
} sailnet_state;

typedef struct {
    sailnet_real cone_angle;     /* [rad], always within -SAILNET_PHI_MAX .. SAILNET_PHI_MAX */
    sailnet_real time_of_flight; /* predicted, to the target orbit [TU] */
} sailnet_command;

typedef enum {
    SAILNET_OK = 0,
    /* The predicted time of flight is below SAILNET_ARRIVAL_THRESHOLD. */
    SAILNET_ARRIVED = 1,
    /* The state is not in the box the networks were trained on: the command is that of the nearest
       state of the box. Never reported as an arrival, whatever the predicted time of flight. */
    SAILNET_OUTSIDE_DOMAIN = 2,
    /* NaN, infinity or a null pointer: cone angle 0, time of flight SAILNET_LARGEST_TIME_OF_FLIGHT. */
    SAILNET_INVALID_INPUT = 3
} sailnet_status;

/* The guidance law: fills *command (unless it is null) whatever the bits of *state are. */
sailnet_status sailnet_guidance(const sailnet_state *state, sailnet_command *command);

#ifdef __cplusplus
}
#endif

#endif
