"""The flight file on the processors it is for, in emulation: golden vectors, sizes, instruction counts."""
