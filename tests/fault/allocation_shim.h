/* The calls of a program that is linked with the shim. */
#ifndef PCVT_TESTS_FAULT_ALLOCATION_SHIM_H
#define PCVT_TESTS_FAULT_ALLOCATION_SHIM_H

/* Lets the allocation of this number fail, counted from now on; 0: none. `for_ever`: and every
 * later one. */
void fault_arm(long allocation, int for_ever);

/* Returns the number of allocations since fault_arm(). */
long fault_allocations(void);

/* Returns the number of blocks that are allocated and not freed. */
long fault_live_blocks(void);

#endif
