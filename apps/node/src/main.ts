import { createLog, discoverMaster, readTokenFile } from '@ubii/client-program';
import type { Log } from '@ubii/client-program';
import { readVersion, runProgram, shutDownOnRequest } from '@ubii/program';
import { NODE_PROGRAM } from './options.ts';
import type { Config } from './options.ts';
import { openSandboxes } from './sandboxes.ts';
import { startNode } from './start-node.ts';
import type { RunningNode } from './start-node.ts';

/** The process exits after this time, even if closing has not finished. */
const SHUTDOWN_DEADLINE_MS = 1_900;

await runProgram(NODE_PROGRAM, ({ values }) => run(values), {
  version: readVersion(import.meta.url),
});

async function run(options: Config): Promise<void> {
  const log = createLog(options.logLevel, (line) => process.stderr.write(`${line}\n`));
  const join = options.tokenFile === undefined ? options.join : readTokenFile(options.tokenFile);
  const found = options.discover ? { master: await discover(log) } : {};
  const config = { ...options, join, ...found };
  const { sandboxes, libraries } = openSandboxes(config.allowFetch, config.memory || undefined);
  const running = await startNode({ config, sandboxes, libraries, log });
  shutDownOnSignal(async () => {
    await running.close();
    await sandboxes.close();
  }, log);
  if (config.printEndpoints === 'json') printWhenConnected(running, config.master);
}

/** Discovers the master. When the parent process ends, exits without a shutdown. */
async function discover(log: Log): Promise<string> {
  const end = (): never => process.exit(0);
  process.on('disconnect', end);
  const url = await discoverMaster(log);
  process.off('disconnect', end);
  return url;
}

function printWhenConnected({ client }: RunningNode, master: string): void {
  const stop = client.onState((state) => {
    if (state.status !== 'connected') return;
    stop();
    const { name } = client;
    process.stdout.write(
      `${JSON.stringify({ id: state.clientId, name, master, pid: process.pid })}\n`,
    );
  });
}

function shutDownOnSignal(close: () => Promise<void>, log: Log): void {
  const end = shutDownOnRequest({
    close,
    deadlineMs: SHUTDOWN_DEADLINE_MS,
    onError: (error) => log('error', `Shutdown failed: ${String(error)}`),
  });
  // An error of this program must not stop the modules that it runs.
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
