/* How long a sail stays on its side at most [TU]: after a miss, where a mission waits for that, it may be longer than else. */
#ifndef LONGEST_WAIT_H
#define LONGEST_WAIT_H

#ifdef SAILNET_LONGEST_WAIT
#define LONGEST_WAIT SAILNET_LONGEST_WAIT
#else
#define LONGEST_WAIT SAILNET_LARGEST_WAIT
#endif

#endif
