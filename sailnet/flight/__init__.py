"""The closed loop: guidance and plant, one command a guidance period."""
