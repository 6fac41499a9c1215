const SIGNALS = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

/** Says why this process ends, whatever ends it but SIGKILL. `done()` says that the run came to its end. */
export function sayWhyItEnds(): { done(): void } {
  let isDone = false;
  for (const signal of SIGNALS) {
    process.once(signal, () => {
      console.error(`The run ends before its time: ${signal}.`);
      isDone = true;
      process.exit(1);
    });
  }
  // Who leads is gone, as by kill -9.
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
