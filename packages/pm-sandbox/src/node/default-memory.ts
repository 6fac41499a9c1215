import { totalmem } from 'node:os';

const MIB = 1024 * 1024;
const GIB = 1024 * MIB;
const SHARE = 1 / 4;
/** Some hundred modules that keep little. */
const MIN_BYTES = 256 * MIB;
/** Upper bound that the workers' counters can represent, and more than modules are known to need. */
const MAX_BYTES = 64 * GIB;

/** Memory that sandboxed modules of a program may have: a quarter of the machine's, or of its container's. [PM-58] */
export function defaultModuleMemory(): number {
  const constrained = process.constrainedMemory?.() ?? 0;
  const total = constrained > 0 ? Math.min(constrained, totalmem()) : totalmem();
  return Math.min(MAX_BYTES, Math.max(MIN_BYTES, Math.floor((total * SHARE) / MIB) * MIB));
}

/** The same of one session: half of it, and 1 GiB at most, so that others have room. */
export function defaultSessionMemory(memoryBytes: number): number {
  return Math.min(GIB, Math.floor(memoryBytes / 2));
}
