"""Bad days of the machine, from outside: kills, two writers at once, lost clusters, disks that fill."""
