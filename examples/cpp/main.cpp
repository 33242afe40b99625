// Earth's orbit to Mars's, and half-way a second computer takes over from a saved state.
#include "guidance.hpp"

#include "../point_mass.h"

#include <cstdio>

int main()
{
    sailnet::Guidance guidance(SAILNET_REAL(0.005)), stand_by = guidance;
    point_mass sail{1.05, 0.15, 1.03};
    double elapsed = 0.0;
    for (int period = 0;; ++period) {
        if (period == 600) {
            guidance = stand_by; // saved after the last period: the flight goes on as if nothing had been
        }
        const sailnet_state state{static_cast<sailnet_real>(sail.r), static_cast<sailnet_real>(sail.u),
                                  static_cast<sailnet_real>(sail.v)};
        const sailnet::Command command = guidance.steer(state);
        stand_by = guidance;
        sail = point_mass_after(sail, command.told.cone_angle, command.told.hold);
        elapsed += command.told.hold;
        if (command.arrived()) {
            break;
        }
    }
    std::printf("arrived after %.4f TU: r %.6f AU, u %+.6f, v %.6f AU/TU\n", elapsed, sail.r, sail.u, sail.v);
    return 0;
}
