/* The size of the memory, for callers that cannot read the header. */
#include "sailnet_guidance.h"

uint32_t sailnet_memory_bytes(void);

uint32_t sailnet_memory_bytes(void)
{
    return sizeof(sailnet_memory);
}
