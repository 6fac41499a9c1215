import {
  createLog,
  discoverMaster,
  printWhenConnected,
  readTokenFile,
  shutDownOnSignal,
} from '@ubii/client-program';
import { readVersion, runProgram } from '@ubii/program';
import { checkCredentials, readAuthority, readCredentials } from './credentials.ts';
import { BRIDGE_PROGRAM, parseTarget } from './options.ts';
import type { Config } from './options.ts';
import { startBridge } from './start-bridge.ts';

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
  if (config.printEndpoints === 'json') printWhenConnected(running.client, config.master);
}
