import type { UbiiClient } from '@ubii/client-web/node';
import { shutDownOnRequest } from '@ubii/program';
import type { Log } from './log.ts';

/** The process exits after this time, even if closing has not finished. */
const SHUTDOWN_DEADLINE_MS = 1_900;

/** When the client is connected for the first time, writes the line of `--print-endpoints json` to standard output. */
export function printWhenConnected(client: UbiiClient, master: string): void {
  const stop = client.onState((state) => {
    if (state.status !== 'connected') return;
    stop();
    const { name } = client;
    process.stdout.write(
      `${JSON.stringify({ id: state.clientId, name, master, pid: process.pid })}\n`,
    );
  });
}

/**
 * Closes the program on a signal, and exits after an uncaught exception. Logs unhandled rejections and goes on: they
 * must not stop modules or mappings that run.
 */
export function shutDownOnSignal(close: () => Promise<void>, log: Log): void {
  const end = shutDownOnRequest({
    close,
    deadlineMs: SHUTDOWN_DEADLINE_MS,
    onError: (error) => log('error', `Shutdown failed: ${String(error)}`),
  });
  process.on('unhandledRejection', (error) =>
    log('error', `Unhandled rejection: ${describe(error)}`),
  );
  process.on('uncaughtException', (error) => {
    log('error', `Uncaught exception: ${describe(error)}`);
    end(1);
  });
}

function describe(error: unknown): string {
  return error instanceof Error ? (error.stack ?? error.message) : String(error);
}
