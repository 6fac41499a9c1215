import { createLog, discoverMaster, readTokenFile } from '@ubii/client-program';
import type { Log } from '@ubii/client-program';
import { readVersion, runProgram, shutDownOnRequest } from '@ubii/program';
import { checkCredentials, readAuthority, readCredentials } from './credentials.ts';
import { BRIDGE_PROGRAM, parseTarget } from './options.ts';
import type { Config } from './options.ts';
import { startBridge } from './start-bridge.ts';
import type { RunningBridge } from './start-bridge.ts';

/** The process exits after this time, even if closing has not finished. */
const SHUTDOWN_DEADLINE_MS = 1_900;

await runProgram(BRIDGE_PROGRAM, ({ words, values }) => run(words, values), {
  version: readVersion(import.meta.url),
});

async function run(words: readonly string[], options: Config): Promise<void> {
  const log = createLog(options.logLevel, (line) => process.stderr.write(`${line}\n`));
  const target = parseTarget(words, options.protocol);
  const credentials = readCredentials(options.credentialsFile, process.env);
  checkCredentials(target.protocol, credentials);
  const ca = readAuthority(options.ca);
  const join = options.tokenFile === undefined ? options.join : readTokenFile(options.tokenFile);
  const found = options.discover ? { master: await discoverMaster(log) } : {};
  const config = { ...options, join, ...found };
  const running = startBridge({ config, target, credentials, ca, log });
  shutDownOnSignal(() => running.close(), log);
  if (config.printEndpoints === 'json') printWhenConnected(running, config.master);
}

function printWhenConnected({ client }: RunningBridge, master: string): void {
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
