import { setFlagsFromString } from 'node:v8';

/** How far the heap may grow beyond what is in use before V8 marks all of it, percent of what is in use. */
const HEAP_GROWTH_PERCENT = 200;

/**
 * Lets the heap grow to three times what is in use before a full garbage collection. V8 itself chooses 1.1 to 4 times.
 *
 * V8 counts the memory of buffers as growth of the heap. After some seconds without load it allows a master so little growth that the
 * buffers of a few hundred pictures of 100 kB exceed it, although they are garbage a moment later and frequent small
 * collections free them. It then did one full collection after the other: more than half of the CPU, and records came
 * 50 to 90 ms late.
 */
export function allowHeapGrowth(): void {
  setFlagsFromString(`--heap-growing-percent=${HEAP_GROWTH_PERCENT}`);
}
