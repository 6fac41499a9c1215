const SIGNALS = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

/** Prints why this process ends before its run is done, unless SIGKILL ends it. Call `done()` at the end of the run. */
export function reportEarlyEnd(): { done(): void } {
  let isDone = false;
  for (const signal of SIGNALS) {
    process.once(signal, () => {
      console.error(`The run ends before its time: ${signal}.`);
      isDone = true;
      process.exit(1);
    });
  }
  // The controlling program has ended, as by kill -9.
  process.once('disconnect', () => {
    console.error('The run ends before its time: the program that started it is gone.');
    isDone = true;
    process.exit(1);
  });
  process.once('exit', (code) => {
    if (isDone) return;
    console.error(
      `The run ended before its time, with ${code}: it failed, or nothing was left to wait for.`,
    );
    if (code === 0) process.exitCode = 1;
  });
  return { done: () => (isDone = true) };
}
