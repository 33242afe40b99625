/*
 * The paper's form, Fig. 6: tau from (r, u, v), then alpha_pre and lambda_v from (r, u, v, tau).
 * These networks do not read beta.
 */
SAILNET_INLINE void sailnet_networks(const sailnet_real state[3], sailnet_real beta, sailnet_real output[3])
{
    sailnet_real input[4] = {state[0], state[1], state[2], R(0.0)};
    (void)beta;
    sailnet_tau_networks(input, &output[0]);
    input[3] = output[0];
    sailnet_command_networks(input, &output[1]);
}
