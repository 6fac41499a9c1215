import {
  createLog,
  discoverMaster,
  printWhenConnected,
  readTokenFile,
  shutDownOnSignal,
} from '@ubii/client-program';
import type { Log } from '@ubii/client-program';
import { readVersion, runProgram } from '@ubii/program';
import { NODE_PROGRAM } from './options.ts';
import type { Config } from './options.ts';
import { openSandboxes } from './sandboxes.ts';
import { startNode } from './start-node.ts';

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
  if (config.printEndpoints === 'json') printWhenConnected(running.client, config.master);
}

/** Discovers the master. When the parent process ends, exits without a shutdown. */
async function discover(log: Log): Promise<string> {
  const end = (): never => process.exit(0);
  process.on('disconnect', end);
  const url = await discoverMaster(log);
  process.off('disconnect', end);
  return url;
}
