/*
 * What is timed: one command, from numbers to numbers. Each candidate is compiled with timing.c into a
 * library of its own, with -DCANDIDATE_INPUTS, _OUTPUTS and _CHAINED, and -DCANDIDATE_FLOAT64 for double.
 */
#ifndef CANDIDATE_H
#define CANDIDATE_H

#ifdef CANDIDATE_FLOAT64
typedef double candidate_real;
#else
typedef float candidate_real;
#endif

/* Reads CANDIDATE_INPUTS numbers and writes CANDIDATE_OUTPUTS. */
void candidate(const candidate_real *input, candidate_real *output);

#endif
