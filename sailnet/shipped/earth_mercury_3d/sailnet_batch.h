/* Many sails at once, for simulation on a host. Not part of the flight file. */
#ifndef SAILNET_BATCH_H
#define SAILNET_BATCH_H

#include <stdint.h>

#include "sailnet_guidance.h"

/* Symbols end in the precision, as those of the guidance do. */
#ifdef SAILNET_FLOAT64
#define sailnet_guidance_batch sailnet_guidance_batch_f64
#define sailnet_propose_plan_batch sailnet_propose_plan_batch_f64
#define sailnet_known_plan_rows sailnet_known_plan_rows_f64
#define sailnet_start_batch sailnet_start_batch_f64
#define sailnet_steer_batch sailnet_steer_batch_f64
#define sailnet_api_version sailnet_api_version_f64
#define sailnet_memory_size sailnet_memory_size_f64
#define sailnet_beta_min sailnet_beta_min_f64
#define sailnet_beta_max sailnet_beta_max_f64
#define sailnet_sail sailnet_sail_f64
#define sailnet_mission_digest sailnet_mission_digest_f64
#define sailnet_networks_digest sailnet_networks_digest_f64
#else
#define sailnet_guidance_batch sailnet_guidance_batch_f32
#define sailnet_propose_plan_batch sailnet_propose_plan_batch_f32
#define sailnet_known_plan_rows sailnet_known_plan_rows_f32
#define sailnet_start_batch sailnet_start_batch_f32
#define sailnet_steer_batch sailnet_steer_batch_f32
#define sailnet_api_version sailnet_api_version_f32
#define sailnet_memory_size sailnet_memory_size_f32
#define sailnet_beta_min sailnet_beta_min_f32
#define sailnet_beta_max sailnet_beta_max_f32
#define sailnet_sail sailnet_sail_f32
#define sailnet_mission_digest sailnet_mission_digest_f32
#define sailnet_networks_digest sailnet_networks_digest_f32
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Command `count` states: `states` holds r, latitude, u, v, w of one sail after the other, `betas` one number a sail;
 * `cone_angles` and `clock_angles` [rad], `times_of_flight` [TU], `lambda_vs`, `lambda_ws` and `statuses`
 * (sailnet_status) get one entry a sail.
 */
void sailnet_guidance_batch(uint64_t count, const sailnet_real *states, const sailnet_real *betas,
                            sailnet_real *cone_angles, sailnet_real *clock_angles, sailnet_real *times_of_flight,
                            sailnet_real *lambda_vs, sailnet_real *lambda_ws, int32_t *statuses);

/* Plans of the networks for `count` states, and whether there are any: see sailnet_propose_plan. */
void sailnet_propose_plan_batch(uint64_t count, const sailnet_real *states, const sailnet_real *betas,
                                sailnet_arrival *arrivals, int32_t *statuses);

/* How many known plans there are. Unless it is null, `rows` gets of each the state, beta, the direction and the time to go. */
uint64_t sailnet_known_plan_rows(double *rows);

/* Start `count` memories. */
void sailnet_start_batch(uint64_t count, sailnet_memory *memories);

/*
 * Steer `count` sails, of which entry i uses memories[sails[i]] and gets commands[i] and statuses[i]. No attitudes are
 * taken yet: whatever `attitudes` is has no effect.
 */
void sailnet_steer_batch(uint64_t count, sailnet_memory *memories, const uint64_t *sails,
                         const sailnet_real *states, const sailnet_real *attitudes, sailnet_real period,
                         sailnet_command *commands, int32_t *statuses);

/* What a caller that loads this as a shared library has to check before it flies, or has to know. */
uint32_t sailnet_api_version(void);
uint32_t sailnet_memory_size(void);
double sailnet_beta_min(void);
double sailnet_beta_max(void);
const char *sailnet_sail(void);
const char *sailnet_mission_digest(void);
const char *sailnet_networks_digest(void);

#ifdef __cplusplus
}
#endif

#endif
