import { spawn } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';

import { freePort, MasterProcess, startNats } from '@ubii/harness';

const PROGRAM = '/usr/sbin/haproxy';
const START_MS = 5_000;

/** A proxy that passes connections on as they are. */
interface Proxy {
  readonly pid: number;
  /** `ws://127.0.0.1:<port>`. */
  readonly origin: string;
  stop(): Promise<void>;
}

/** True when haproxy (Debian package) is there. */
export const HAS_HAPROXY = existsSync(PROGRAM);

/** Starts haproxy before one port of this machine, with one thread and without looking into connections. */
export async function startHaproxy(targetPort: number): Promise<Proxy> {
  const folder = await mkdtemp(join(tmpdir(), 'ubii-haproxy-'));
  const port = await freePort();
  const file = join(folder, 'haproxy.cfg');
  await writeFile(
    file,
    `global
  nbthread 1
  maxconn 4000
defaults
  mode tcp
  timeout connect 5s
  timeout client 1h
  timeout server 1h
listen ubii
  bind 127.0.0.1:${port}
  server master 127.0.0.1:${targetPort}
`,
  );
  const child = spawn(PROGRAM, ['-db', '-f', file], { stdio: 'ignore' });
  const killWithUs = (): void => void child.kill('SIGKILL');
  process.once('exit', killWithUs);
  const stop = async (): Promise<void> => {
    process.off('exit', killWithUs);
    child.kill('SIGKILL');
    await rm(folder, { recursive: true, force: true });
  };
  const endMs = performance.now() + START_MS;
  while (!(await isOpen(port))) {
    if (performance.now() > endMs || child.exitCode !== null) {
      await stop();
      throw new Error('haproxy did not start.');
    }
    await sleep(20);
  }
  return { pid: child.pid!, origin: `ws://127.0.0.1:${port}`, stop };
}

function isOpen(port: number): Promise<boolean> {
  return new Promise((resolve) => {
    const socket = connect(port, '127.0.0.1');
    const end = (found: boolean): void => {
      socket.destroy();
      resolve(found);
    };
    socket.once('connect', () => end(true)).once('error', () => end(false));
  });
}

/** Masters that work as one, or one that is alone, with what connects them. */
export interface MasterSet {
  readonly masters: readonly MasterProcess[];
  /** Processes that are there for the masters: NATS, a proxy. */
  readonly helpers: readonly number[];
  stop(): Promise<void>;
}

export interface MasterSetStart {
  /** Main file of the masters. */
  readonly program: string;
  readonly profileDir: string | undefined;
}

/** One master that is in no cluster. */
export async function startOneMaster(start: MasterSetStart): Promise<MasterSet> {
  const master = await MasterProcess.start(start);
  return { masters: [master], helpers: [], stop: () => master.dispose() };
}

/**
 * Masters of one cluster, with a NATS server of their own.
 *
 * @throws Error that says how to get NATS when it is missing
 */
export async function startMasterCluster(start: MasterSetStart, count: number): Promise<MasterSet> {
  const nats = await startNats({ jetstream: true });
  const masters: MasterProcess[] = [];
  const stop = async (): Promise<void> => {
    await Promise.all(masters.map((master) => master.dispose()));
    await nats.stop();
  };
  try {
    // One after the other: the first one creates the stores.
    while (masters.length < count) {
      masters.push(await MasterProcess.start({ ...start, flags: ['--cluster', nats.url] }));
    }
    return { masters, helpers: [nats.pid!], stop };
  } catch (error) {
    await stop();
    throw error;
  }
}
