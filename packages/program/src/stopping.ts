/** Ignore the duplicate Ctrl-C that npm sends. */
const SAME_SIGNAL_MS = 500;

/** Shutdown of a program. */
export interface Shutdown {
  close(): Promise<void>;
  /** The process exits after this time, even if closing has not finished. */
  readonly deadlineMs: number;
  /** Called when closing fails; the process exits with code 1 then. */
  onError(error: unknown): void;
}

/**
 * Calls the listener when the program is asked to stop: SIGINT, SIGTERM, SIGHUP, or the end of a parent process that
 * has a channel to it. The listener is called for each of them.
 */
export function onStopRequest(listener: () => void): void {
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP'] as const) process.on(signal, listener);
  process.on('disconnect', listener);
  process.channel?.unref();
}

/**
 * Closes a program and exits with code 0 when it is asked to stop. A second request exits at once.
 *
 * @returns closes and exits with another code
 */
export function shutDownOnRequest({
  close,
  deadlineMs,
  onError,
}: Shutdown): (exitCode: number) => void {
  let endingSinceMs: number | undefined;
  const end = (exitCode: number): void => {
    if (endingSinceMs !== undefined) {
      if (performance.now() - endingSinceMs > SAME_SIGNAL_MS) process.exit(1);
      return;
    }
    endingSinceMs = performance.now();
    setTimeout(() => process.exit(exitCode), deadlineMs).unref();
    close().then(
      () => process.exit(exitCode),
      (error: unknown) => {
        onError(error);
        process.exit(1);
      },
    );
  };
  onStopRequest(() => end(0));
  // Continue when a pipe is closed (`npm start | head`).
  for (const stream of [process.stdout, process.stderr]) stream.on('error', () => {});
  return end;
}

/** Whether a process runs, of any user. */
export function isProcessRunning(pid: number): boolean {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return (error as NodeJS.ErrnoException).code === 'EPERM';
  }
}
