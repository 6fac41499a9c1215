import type { ChildProcess } from 'node:child_process';

/** Returns whether the process has ended. */
export function hasEnded(child: ChildProcess): boolean {
  return child.exitCode !== null || child.signalCode !== null;
}

/** Resolves when the process has ended. */
export function whenEnded(child: ChildProcess): Promise<void> {
  if (hasEnded(child)) return Promise.resolve();
  return new Promise((resolve) => child.once('exit', () => resolve()));
}

/** Ends a process with a signal, and resolves when it has ended. */
export async function endProgram(child: ChildProcess, signal: NodeJS.Signals): Promise<void> {
  if (hasEnded(child)) return;
  const ended = whenEnded(child);
  child.kill(signal);
  await ended;
}

/**
 * Ends a process with SIGTERM, or with SIGKILL when it is still running after the time limit.
 *
 * @returns whether it ended within the time limit
 */
export async function endWithin(child: ChildProcess, timeoutMs: number): Promise<boolean> {
  let isLate = false;
  const timer = setTimeout(() => {
    isLate = true;
    child.kill('SIGKILL');
  }, timeoutMs);
  await endProgram(child, 'SIGTERM');
  clearTimeout(timer);
  return !isLate;
}
