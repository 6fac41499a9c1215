import { readFileSync } from 'node:fs';
import { discoverMaster } from './discover-master.ts';
import { formatHelp } from './format-help.ts';
import { createLog } from './log.ts';
import type { Log } from './log.ts';
import { ConfigError, readConfig } from './read-config.ts';
import { openSandboxes } from './sandboxes.ts';
import { startNode } from './start-node.ts';
import type { RunningNode } from './start-node.ts';
import { readTokenFile } from './token-file.ts';

/** The process exits after this time, even if closing has not finished. */
const SHUTDOWN_DEADLINE_MS = 1_900;
/** Ignore the duplicate Ctrl-C that npm sends. */
const SAME_SIGNAL_MS = 500;

try {
  await run(process.argv.slice(2));
} catch (error) {
  if (!(error instanceof ConfigError)) throw error;
  process.stderr.write(`${error.message}\n`);
  process.exit(1);
}

async function run(args: readonly string[]): Promise<void> {
  if (args.includes('--help')) {
    process.stdout.write(formatHelp());
    return;
  }
  const options = readConfig(args, process.env, process.cwd());
  if (options.version) {
    process.stdout.write(`${readVersion()}\n`);
    return;
  }
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
  let endingSince: number | undefined;
  const end = (exitCode: number): void => {
    if (endingSince !== undefined) {
      if (performance.now() - endingSince > SAME_SIGNAL_MS) process.exit(1);
      return;
    }
    endingSince = performance.now();
    setTimeout(() => process.exit(exitCode), SHUTDOWN_DEADLINE_MS).unref();
    close().then(
      () => process.exit(exitCode),
      (error: unknown) => {
        log('error', `Shutdown failed: ${String(error)}`);
        process.exit(1);
      },
    );
  };
  process.on('SIGINT', () => end(0));
  process.on('SIGTERM', () => end(0));
  process.on('SIGHUP', () => end(0));
  // The parent process has ended.
  process.on('disconnect', () => end(0));
  process.channel?.unref();
  // An error of this program must not stop the modules that it runs.
  process.on('unhandledRejection', (error) =>
    log('error', `Unhandled rejection: ${describe(error)}`),
  );
  process.on('uncaughtException', (error) => {
    log('error', `Uncaught exception: ${describe(error)}`);
    end(1);
  });
  // Continue when a pipe is closed (`npm run node | head`).
  for (const stream of [process.stdout, process.stderr]) stream.on('error', () => {});
}

function readVersion(): string {
  const file = new URL('../package.json', import.meta.url);
  return (JSON.parse(readFileSync(file, 'utf8')) as { version: string }).version;
}

function describe(error: unknown): string {
  return error instanceof Error ? (error.stack ?? error.message) : String(error);
}
