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

/** Everything is closed by then, or the process ends without it. */
const SHUTDOWN_DEADLINE_MS = 1_900;
/** Ctrl-C reaches the node from the terminal and from the start script: the second is no impatience. */
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
  const wished = readConfig(args, process.env, process.cwd());
  if (wished.version) {
    process.stdout.write(`${readVersion()}\n`);
    return;
  }
  const log = createLog(wished.logLevel, (line) => process.stderr.write(`${line}\n`));
  const join = wished.tokenFile === undefined ? wished.join : readTokenFile(wished.tokenFile);
  const found = wished.discover ? { master: await discover(log) } : {};
  const config = { ...wished, join, ...found };
  const { sandboxes, libraries } = openSandboxes(config.allowFetch, config.memory || undefined);
  const running = await startNode({ config, sandboxes, libraries, log });
  endInGoodOrder(async () => {
    await running.close();
    await sandboxes.close();
  }, log);
  if (config.printEndpoints === 'json') printWhenConnected(running, config.master);
}

/** Nothing has to be ended in good order yet; else as in `endInGoodOrder`. */
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

function endInGoodOrder(close: () => Promise<void>, log: Log): void {
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
        log('error', `Closing failed: ${String(error)}`);
        process.exit(1);
      },
    );
  };
  process.on('SIGINT', () => end(0));
  process.on('SIGTERM', () => end(0));
  process.on('SIGHUP', () => end(0));
  // A program that started the node with a channel to it does not leave it behind.
  process.on('disconnect', () => end(0));
  process.channel?.unref();
  // A fault of this program must not take the modules of others with it.
  process.on('unhandledRejection', (error) => log('error', `Unhandled: ${describe(error)}`));
  process.on('uncaughtException', (error) => {
    log('error', `Uncaught: ${describe(error)}`);
    end(1);
  });
  // A closed pipe (`npm run node | head`) is no reason to end.
  for (const stream of [process.stdout, process.stderr]) stream.on('error', () => {});
}

function readVersion(): string {
  const file = new URL('../package.json', import.meta.url);
  return (JSON.parse(readFileSync(file, 'utf8')) as { version: string }).version;
}

function describe(error: unknown): string {
  return error instanceof Error ? (error.stack ?? error.message) : String(error);
}
