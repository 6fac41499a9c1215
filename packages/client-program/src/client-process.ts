import type { UbiiClient } from '@ubii/client-web/node';
import { shutDownOnRequest, ConfigError } from '@ubii/program';
import { findMasters, ownAddresses, type FindOptions, type FoundMaster } from '@ubii/discovery';

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

/** Time for further masters to answer after the first one, milliseconds. */
const OTHERS_MS = 1_500;
/** Time without an answer after which a message is logged, milliseconds. */
const NOTICE_DELAY_MS = 3_000;

/**
 * Searches the local network for a master until one answers. [DI-5]
 * @returns the address of the master
 * @throws ConfigError with a list of the masters when several answer
 */
export async function discoverMaster(
  log: Log,
  where: Pick<FindOptions, 'addresses' | 'port'> = { addresses: ownAddresses },
): Promise<string> {
  let found: readonly FoundMaster[] = [];
  const timers: NodeJS.Timeout[] = [];
  let end: () => Promise<void> = async () => undefined;
  await new Promise<void>((resolve) => {
    const notice = setTimeout(() => {
      log('info', 'No master found in the local network yet. Searching');
    }, NOTICE_DELAY_MS);
    timers.push(notice);
    end = findMasters({
      ...where,
      onProblem: (reason) => log('warn', `Search for a master: ${reason}`),
      onFound: (masters) => {
        found = masters;
        if (masters.length > 1) return;
        clearTimeout(notice);
        timers.push(setTimeout(resolve, OTHERS_MS));
      },
    });
  });
  for (const timer of timers) clearTimeout(timer);
  await end();
  const [only] = found;
  if (only !== undefined && found.length === 1) {
    log('info', `Found ${describeMaster(only)}`);
    return only.url;
  }
  throw new ConfigError(
    [
      `Found ${found.length} masters in the local network. Choose one with --master:`,
      ...found.map((master) => `  --master ${master.url}   ${describeMaster(master)}`),
    ].join('\n'),
  );
}

function describeMaster({ name, version, url }: FoundMaster): string {
  return `"${name}" (${version}) at ${url}`;
}
