import { discoverMaster, JOINING_OPTIONS, readTokenFile } from '@ubii/client-program';
import type { Log } from '@ubii/client-program';
import { connectOnce, createClient, type UbiiClient } from '@ubii/client-web/node';
import { ConfigError } from '@ubii/program';
import { OPTIONS, type Config } from '../options.ts';

/** Options of programs that join a master for one task. */
export const CONNECTION_OPTIONS = { ...JOINING_OPTIONS, logLevel: OPTIONS.logLevel } as const;

type ConnectionOptions = Pick<Config, 'master' | 'discover' | 'join' | 'tokenFile'>;

/**
 * Connects to the master that the options name.
 *
 * @throws ConfigError when the master cannot be reached or refuses the client
 */
export async function connect(
  options: ConnectionOptions,
  name: string,
  log: Log,
): Promise<UbiiClient> {
  const url = options.discover ? await discoverMaster(log) : options.master;
  const joinToken =
    options.tokenFile === undefined ? options.join : readTokenFile(options.tokenFile);
  const client = createClient({
    url,
    name,
    publishIntervalMs: 0,
    ...(joinToken === undefined ? {} : { joinToken }),
    onError: (error, source) => log('error', `Error in ${source}: ${String(error)}`),
  });
  client.onError(({ message }) => log('warn', message));
  try {
    await connectOnce(client);
  } catch (error) {
    throw new ConfigError(
      `No connection to the master ${url}: ${(error as Error).message}. Choose a running master with --master, and a token with --join if it asks for one.`,
    );
  }
  return client;
}
