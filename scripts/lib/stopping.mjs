import { constants } from 'node:os';

/** Interval at which a script checks whether npm, which started it, still runs. */
const PARENT_CHECK_MS = 250;

/** @type {Set<(signal: NodeJS.Signals) => void>} */
const listeners = new Set();
let watching = false;

/**
 * Calls `listener` when this script is asked to end: SIGINT, SIGTERM, SIGHUP, or the death of npm.
 * npm does not pass SIGTERM on: it ends the shell between itself and the script and leaves the script
 * alone, so the script watches for a change of its parent.
 *
 * @param {(signal: NodeJS.Signals) => void} listener
 * @returns {() => void} stops listening
 */
export function onStop(listener) {
  listeners.add(listener);
  watch();
  return () => listeners.delete(listener);
}

function watch() {
  if (watching) return;
  watching = true;
  const stop = (/** @type {NodeJS.Signals} */ signal) => {
    if (listeners.size === 0) process.exit(exitCodeOf(signal));
    for (const listener of [...listeners]) listener(signal);
  };
  for (const signal of /** @type {const} */ (['SIGINT', 'SIGTERM', 'SIGHUP'])) {
    process.on(signal, () => stop(signal));
  }
  if (process.env.npm_lifecycle_event === undefined) return;
  const parent = process.ppid;
  const timer = setInterval(() => {
    if (process.ppid === parent) return;
    clearInterval(timer);
    stop('SIGTERM');
  }, PARENT_CHECK_MS);
  timer.unref();
}

/** The exit code shells give to a process that a signal ended. */
export function exitCodeOf(/** @type {NodeJS.Signals} */ signal) {
  return 128 + (constants.signals[signal] ?? 0);
}
