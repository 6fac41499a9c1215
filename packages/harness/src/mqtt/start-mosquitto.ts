import { spawn, type ChildProcess } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { freePort } from '../network/ports.ts';
import { endProgram, findProgram } from '../process/server-process.ts';

const MISSING = `This needs the broker Mosquitto (command \`mosquitto\`), and it was not found. Install it:
  Debian, Ubuntu   apt-get install mosquitto   (as root, \`npm test\` installs it)
  macOS            brew install mosquitto`;

function findMosquitto(): string {
  const found = findProgram('mosquitto');
  if (found === undefined) throw new Error(MISSING);
  return found;
}

/** A broker of its own on a free port of the loopback. */
export interface Mosquitto {
  readonly url: string;
  readonly port: number;
  readonly folder: string;
  /** Undefined while it does not run. */
  readonly pid: number | undefined;
  stop(): Promise<void>;
  start(): Promise<void>;
  /** Stops it, and removes its files. */
  close(): Promise<void>;
}

/** @param lines of its configuration besides */
export async function startMosquitto(
  lines: (folder: string) => readonly string[] = () => ['allow_anonymous true'],
): Promise<Mosquitto> {
  const program = findMosquitto();
  const folder = mkdtempSync(join(tmpdir(), 'ubii-mosquitto-'));
  const port = await freePort();
  const config = join(folder, 'mosquitto.conf');
  let child: ChildProcess | undefined;
  const text = [
    `listener ${port} 127.0.0.1`,
    'persistence false',
    'log_dest stderr',
    // As root it would become the user mosquitto, who may not read the folder.
    ...(process.getuid?.() === 0 ? ['user root'] : []),
    ...lines(folder),
  ];
  writeFileSync(config, text.join('\n'));
  const broker: Mosquitto = {
    url: `mqtt://127.0.0.1:${port}`,
    port,
    folder,
    get pid() {
      return child?.pid;
    },
    async start() {
      child = spawn(program, ['-c', config], { stdio: ['ignore', 'ignore', 'pipe'] });
      await untilRunning(child);
    },
    async stop() {
      const ending = child;
      child = undefined;
      if (ending !== undefined) await endProgram(ending, 'SIGTERM');
    },
    async close() {
      await broker.stop();
      rmSync(folder, { recursive: true, force: true });
    },
  };
  await broker.start();
  return broker;
}

/** Mosquitto says so when it listens. */
function untilRunning(child: ChildProcess): Promise<void> {
  return new Promise((resolve, reject) => {
    let said = '';
    const fail = (): void => reject(new Error(`Mosquitto ended: ${said}`));
    child.once('exit', fail);
    child.stderr?.on('data', (more) => {
      said += more;
      if (!/^.*mosquitto version .* running$/m.test(said)) return;
      child.off('exit', fail);
      resolve();
    });
  });
}
