/* The guidance that is tested, in the translation unit of its test, which so reaches all of its parts. */
#ifdef TESTED_HOST
#include "sailnet_guidance_host.c"
#else
#include "sailnet_guidance.c"
#endif
