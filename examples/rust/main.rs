//! Guidance from Rust: the flight file in double, and around it a safe interface.

use std::mem::size_of;

#[repr(C)]
#[derive(Clone, Copy)]
struct State {
    r: f64, // [AU]
    u: f64, // [AU/TU]
    v: f64,
}

#[repr(C)]
#[derive(Clone, Copy, Default)]
struct Command {
    cone_angle: f64,     // [rad]
    time_of_flight: f64, // [TU]
    beta: f64,
    hold: f64, // [TU]
    lambda_v: f64,
}

/// Opaque, and larger than `sailnet_memory`: `Guidance::new` makes sure.
#[repr(C)]
#[derive(Clone, Copy)]
struct Memory([u64; 128]);

const ARRIVED: i32 = 1;

extern "C" {
    fn sailnet_memory_bytes() -> u32;
    fn sailnet_start_f64(memory: *mut Memory);
    fn sailnet_steer_f64(memory: *mut Memory, state: *const State, period: f64, command: *mut Command) -> i32;
}

/// A copy of it is a saved state.
#[derive(Clone, Copy)]
struct Guidance {
    memory: Memory,
    period: f64, // [TU]
}

impl Guidance {
    fn new(period: f64) -> Self {
        let mut memory = Memory([0; 128]);
        // SAFETY: the C writes sailnet_memory_bytes() bytes, of an alignment that u64 has.
        unsafe {
            assert!(sailnet_memory_bytes() as usize <= size_of::<Memory>());
            sailnet_start_f64(&mut memory);
        }
        Guidance { memory, period }
    }

    /// Once a period; without a state the sail is steered by where it must be.
    fn steer(&mut self, state: Option<State>) -> (i32, Command) {
        let mut command = Command::default();
        let at = state.as_ref().map_or(std::ptr::null(), |state| state as *const State);
        // SAFETY: all three outlive the call; a null state is allowed.
        let status = unsafe { sailnet_steer_f64(&mut self.memory, at, self.period, &mut command) };
        (status, command)
    }
}

fn main() {
    let mut guidance = Guidance::new(0.005);
    let state = State { r: 1.05, u: 0.15, v: 1.03 };
    let (status, command) = guidance.steer(Some(state));
    println!(
        "status {status}: hold {:+.6} rad for {:.4} TU; {:.4} TU to go",
        command.cone_angle, command.hold, command.time_of_flight
    );
    let (status, command) = guidance.steer(None);
    println!("status {status}, without a state: hold {:+.6} rad", command.cone_angle);
    assert_ne!(status, ARRIVED);
}
