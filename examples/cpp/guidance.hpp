// Guidance as an object: its memory inside, the state in, the command out.
#pragma once

#include "sailnet_guidance.h"

#include <optional>

namespace sailnet {

struct Command {
    sailnet_command told;
    sailnet_status status;

    bool arrived() const { return status == SAILNET_ARRIVED; }
};

// A copy of it is a saved state.
class Guidance {
public:
    explicit Guidance(sailnet_real period) : period_(period) { sailnet_start(&memory_); }

    // Once a period; without a state the sail is steered by where it must be.
    Command steer(const std::optional<sailnet_state> &state) {
        Command command{};
        command.status = sailnet_steer(&memory_, state ? &*state : nullptr, period_, &command.told);
        return command;
    }

    // Just before steer, where the attitude is measured: the mean cone angle since the last call [rad].
    void measured(sailnet_real cone_angle) { sailnet_measured(&memory_, cone_angle); }

    sailnet_real beta() const { return memory_.estimate.beta; }

private:
    sailnet_memory memory_;
    sailnet_real period_;
};

} // namespace sailnet
