SAILNET_INLINE sailnet_real sailnet_exp2(sailnet_real octaves)
{
    const sailnet_lanes nothing = {R(0.0)};
    const sailnet_lanes powers = sailnet_lanes_exp2(octaves + nothing);
    return powers[0];
}
