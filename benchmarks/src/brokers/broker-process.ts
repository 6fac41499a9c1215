import { spawn, type ChildProcess } from 'node:child_process';
import { createInterface } from 'node:readline';
import type { Readable } from 'node:stream';

/** Time limit for a broker to report its address. */
const START_TIMEOUT_MS = 20_000;
/** Time limit for an orderly stop, before the broker is killed. */
const STOP_TIMEOUT_MS = 5_000;

const MAX_LOG_CHARACTERS = 2_000;

export interface BrokerProcess {
  readonly pid: number;
  /** The JSON object of the first line it printed. */
  readonly endpoints: Record<string, unknown>;
  stop(): Promise<void>;
}

export interface BrokerCommand {
  readonly name: string;
  /** Script and its arguments, run by the same Node as this one. */
  readonly args: readonly string[];
  /** Directory for a CPU profile of the whole run, written when the broker stops. */
  readonly profileDir: string | undefined;
}

/** Starts a broker and waits for the line of JSON that says where it listens. */
export async function startBrokerProcess(command: BrokerCommand): Promise<BrokerProcess> {
  const { name, args, profileDir } = command;
  const profiling =
    profileDir === undefined
      ? []
      : ['--cpu-prof', `--cpu-prof-dir=${profileDir}`, `--cpu-prof-name=${name}.cpuprofile`];
  const child = spawn(process.execPath, [...profiling, ...args], {
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  const log = lastLines(child.stderr);
  const killWithUs = (): void => void child.kill('SIGKILL');
  process.once('exit', killWithUs);
  const endpoints = await firstLine(child, name, log);
  return {
    pid: child.pid!,
    endpoints,
    stop: async () => {
      process.off('exit', killWithUs);
      await end(child);
    },
  };
}

function firstLine(
  child: ChildProcess,
  name: string,
  log: () => string,
): Promise<Record<string, unknown>> {
  return new Promise((resolve, reject) => {
    const fail = (reason: string): void => {
      child.kill('SIGKILL');
      reject(new Error(`The broker ${name} ${reason}.\n${log()}`.trimEnd()));
    };
    const timer = setTimeout(
      () => fail(`did not report its address within ${START_TIMEOUT_MS / 1000} s`),
      START_TIMEOUT_MS,
    );
    child.once('error', (error) => fail(`could not be started: ${error.message}`));
    child.once('exit', (code, signal) => fail(`ended at its start (${signal ?? `code ${code}`})`));
    createInterface({ input: child.stdout! }).on('line', (line) => {
      if (!line.startsWith('{')) return;
      clearTimeout(timer);
      child.removeAllListeners('exit');
      resolve(JSON.parse(line) as Record<string, unknown>);
    });
  });
}

/** Keeps the end of what a broker logs, to show it when the broker does not start. */
function lastLines(stream: Readable): () => string {
  let text = '';
  stream.setEncoding('utf8').on('data', (chunk: string) => {
    text = (text + chunk).slice(-MAX_LOG_CHARACTERS);
  });
  return () => text;
}

function end(child: ChildProcess): Promise<void> {
  return new Promise((resolve) => {
    if (child.exitCode !== null || child.signalCode !== null) return resolve();
    const timer = setTimeout(() => child.kill('SIGKILL'), STOP_TIMEOUT_MS);
    child.once('exit', () => {
      clearTimeout(timer);
      resolve();
    });
    child.kill('SIGTERM');
  });
}
