import { spawn, type ChildProcess } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { findProgram, endProgram } from '../process/server-process.ts';
import { freePort } from '../network/ports.ts';

const MISSING = `nats-server was not found on the PATH. It is needed by tests of several masters:
  Debian, Ubuntu   apt-get install nats-server
  elsewhere        https://github.com/nats-io/nats-server/releases`;

/** A NATS server to be started. */
export interface NatsOptions {
  /** With the key-value stores, in a folder of its own that is removed at the end. Default: false */
  readonly jetstream?: boolean;
  /** Address to listen on. Default: 127.0.0.1 */
  readonly host?: string;
  /** Where it makes the folder that it stores in. Default: that of temporary files */
  readonly parentFolder?: string;
  /** Further arguments of the program, such as `--user`. */
  readonly args?: readonly string[];
  /** Folder in which it runs. Default: the current one */
  readonly cwd?: string;
}

/** A NATS server of a test, on a free port. */
export interface NatsServer {
  /** Such as `nats://127.0.0.1:4222`. */
  readonly url: string;
  readonly port: number;
  /** Of the process that runs now; undefined while none does. */
  readonly pid: number | undefined;
  /** Kills it, as `kill -9` does. */
  kill(): Promise<void>;
  /** Starts it again, on the same port and with what was stored. */
  restart(): Promise<void>;
  /** Removes what it stored, while it does not run. */
  empty(): Promise<void>;
  /** Ends it, and removes what it stored. */
  stop(): Promise<void>;
}

/**
 * Starts a NATS server and resolves when it listens.
 *
 * @throws Error that says how to get the program when it is missing
 */
export async function startNats({
  jetstream = false,
  host = '127.0.0.1',
  parentFolder = tmpdir(),
  args = [],
  cwd,
}: NatsOptions = {}): Promise<NatsServer> {
  const program = findNats();
  const port = await freePort();
  const folder = mkdtempSync(join(parentFolder, 'ubii-nats-'));
  const allArgs = ['-a', host, '-p', String(port), ...args];
  if (jetstream) allArgs.push('-js', '-sd', folder);
  const start = (): Promise<ChildProcess> => startProgram(program, allArgs, cwd);
  let running: ChildProcess | undefined = await start();
  const end = async (signal: NodeJS.Signals): Promise<void> => {
    const ended = running;
    running = undefined;
    if (ended !== undefined) await endProgram(ended, signal);
  };
  return {
    url: `nats://${host}:${port}`,
    port,
    get pid() {
      return running?.pid;
    },
    kill: () => end('SIGKILL'),
    async restart() {
      await end('SIGTERM');
      running = await start();
    },
    async empty() {
      await rm(folder, { recursive: true, force: true, maxRetries: 5 });
    },
    async stop() {
      await end('SIGKILL');
      await rm(folder, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

/** Why no NATS server can be started here, with how to get one; undefined: one can. */
export function reasonAgainstNats(): string | undefined {
  try {
    findNats();
    return undefined;
  } catch (error) {
    return (error as Error).message;
  }
}

function findNats(): string {
  const found = findProgram('nats-server');
  if (found === undefined) throw new Error(MISSING);
  return found;
}

async function startProgram(
  program: string,
  args: readonly string[],
  cwd: string | undefined,
): Promise<ChildProcess> {
  const child = spawn(program, args, { stdio: ['ignore', 'ignore', 'pipe'], cwd });
  const killWithUs = (): void => void child.kill('SIGKILL');
  process.once('exit', killWithUs);
  child.once('exit', () => process.off('exit', killWithUs));
  await new Promise<void>((resolve, reject) => {
    let output = '';
    child.stderr.on('data', (chunk: Buffer) => {
      output += chunk.toString();
      if (output.includes('Server is ready')) resolve();
    });
    child.once('error', reject);
    child.once('exit', () => reject(new Error(`nats-server ended at its start:\n${output}`)));
  });
  child.stderr.removeAllListeners('data').resume();
  return child;
}
