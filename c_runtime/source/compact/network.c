/*
 * One of the networks. Weights are read from the first to the last: of each layer the last block of neurons comes
 * first, its biases and then its weights, input by input. *weights is left at the next network's.
 */
SAILNET_INLINE sailnet_real sailnet_network(const sailnet_real input[SAILNET_INPUTS], int32_t depth,
                                            const sailnet_real **weights)
{
    /*
     * A layer's inputs come first. Its sums are in registers until the inputs of a block are all read; they end
     * where the buffer does, so that only those of the block that is computed last take the place of inputs.
     */
    sailnet_real a[2 * SAILNET_WIDTH - SAILNET_BLOCK];
    const sailnet_real *w = *weights;
    const sailnet_real *from = input;
    int32_t inputs = SAILNET_INPUTS;
    int32_t layer = 0;
    do {
        const sailnet_real *const end = &from[inputs];
        for (int32_t first = SAILNET_WIDTH - SAILNET_BLOCK; first >= 0; first -= SAILNET_BLOCK) {
            sailnet_real s0 = w[0];
            sailnet_real s1 = w[1];
            sailnet_real s2 = w[2];
            sailnet_real s3 = w[3];
            sailnet_real s4 = w[4];
            sailnet_real s5 = w[5];
            sailnet_real s6 = w[6];
            sailnet_real s7 = w[7];
            sailnet_real s8 = w[8];
            sailnet_real s9 = w[9];
            const sailnet_real *in = from;
            do {
                const sailnet_real x = *in;
                in = &in[1];
                w = &w[SAILNET_BLOCK];
                s0 += x * w[0];
                s1 += x * w[1];
                s2 += x * w[2];
                s3 += x * w[3];
                s4 += x * w[4];
                s5 += x * w[5];
                s6 += x * w[6];
                s7 += x * w[7];
                s8 += x * w[8];
                s9 += x * w[9];
            } while (in != end);
            w = &w[SAILNET_BLOCK];
            sailnet_real *const sums = &a[SAILNET_WIDTH - SAILNET_BLOCK + first];
            sums[0] = s0;
            sums[1] = s1;
            sums[2] = s2;
            sums[3] = s3;
            sums[4] = s4;
            sums[5] = s5;
            sums[6] = s6;
            sums[7] = s7;
            sums[8] = s8;
            sums[9] = s9;
        }
        for (int32_t j = 0; j < SAILNET_WIDTH; j++) {
            a[j] = sailnet_sigmoid(a[j + SAILNET_WIDTH - SAILNET_BLOCK]);
        }
        from = a;
        inputs = SAILNET_NEURONS;
        layer++;
    } while (layer < depth);
    sailnet_real sum = *w;
    for (int32_t j = 0; j < SAILNET_NEURONS; j++) {
        w = &w[1];
        sum += a[j] * *w;
    }
    *weights = &w[1];
    return sum;
}
