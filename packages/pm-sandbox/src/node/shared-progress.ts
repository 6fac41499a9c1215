import type { Progress } from '../worker/protocol.ts';

const RECEIVED = 0;
const RUNNING = 1;
const SEQUENCE = 2;
const FIELDS = 3;

/** Memory in which a worker says how far it is; the host sees it also while the worker is busy. */
export function createProgressMemory(): SharedArrayBuffer {
  return new SharedArrayBuffer(FIELDS * Int32Array.BYTES_PER_ELEMENT);
}

/** Reads what the worker wrote last; survives its end. */
export function readProgress(memory: SharedArrayBuffer): Progress {
  const fields = new Int32Array(memory);
  return {
    received: Atomics.load(fields, RECEIVED),
    running: Atomics.load(fields, RUNNING),
    sequence: Atomics.load(fields, SEQUENCE),
  };
}

/** Writes it, in the worker. */
export function createProgressWriter(memory: SharedArrayBuffer): {
  noteReceived(): void;
  noteRunning(instance: number): void;
} {
  const fields = new Int32Array(memory);
  return {
    noteReceived: () => void Atomics.add(fields, RECEIVED, 1),
    noteRunning(instance) {
      Atomics.store(fields, RUNNING, instance);
      Atomics.add(fields, SEQUENCE, 1);
    },
  };
}
