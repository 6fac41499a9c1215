import { spawn, type ChildProcess } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { decode, encode, type Init, type ServiceReply, type ServiceRequest } from '@ubii/proto';

import { hasFlag } from './built-master.ts';
import { describeEnd } from './describe-end.ts';
import { readProcess, type ProcessFigures } from './process-figures.ts';

/** A start on a busy machine takes seconds; past this the master hangs. */
const START_TIMEOUT_MS = 60_000;
const STOP_TIMEOUT_MS = 10_000;
const CALL_TIMEOUT_MS = 20_000;
const MAX_KEPT_LINES = 20_000;

/** The line of `--print-endpoints json`. */
export interface MasterEndpoints {
  readonly url: string;
  readonly servicesJson: string;
  readonly servicesBinary: string;
  readonly topicDataWs: string;
  readonly adminToken?: string;
  readonly adminCode?: string;
  readonly joinToken?: string;
  readonly joinCode?: string;
}

export interface MasterStart {
  /** Main file of a built master. */
  readonly program: string;
  /** Default: a new folder, which `dispose()` removes. */
  readonly dataDir?: string;
  /** Default: loopback only, any free port. */
  readonly network?: readonly string[];
  readonly flags?: readonly string[];
  /** For Node itself, such as `--inspect=127.0.0.1:0`. */
  readonly nodeFlags?: readonly string[];
  /** Words of the command that the master is started by, such as `ip netns exec x`. */
  readonly within?: readonly string[];
  /** Soft limit of open descriptors. */
  readonly maxDescriptors?: number;
  /**
   * Role of local callers without a token, if the build distinguishes: admins, or the master's default without a flag.
   * Default: admins
   */
  readonly loopback?: 'admins' | 'unsaid';
}

/** The master did not start: it ended with this code, and said this. */
export class StartRefused extends Error {
  readonly exitCode: number | null;
  readonly output: string;

  constructor(exitCode: number | null, output: string) {
    super(`The master ended with ${exitCode} while it started.\n${output}`);
    this.exitCode = exitCode;
    this.output = output;
  }
}

/** A built master as a process of its own, with everything it logged. */
export class MasterProcess {
  /** Main file that runs. */
  readonly program: string;
  readonly endpoints: MasterEndpoints;
  readonly dataDir: string;
  readonly #child: ChildProcess;
  readonly #lines: string[];
  readonly #ownsDataDir: boolean;
  readonly #ended: Promise<void>;

  private constructor(
    program: string,
    child: ChildProcess,
    endpoints: MasterEndpoints,
    dataDir: string,
    ownsDataDir: boolean,
    lines: string[],
  ) {
    this.program = program;
    this.#child = child;
    this.endpoints = endpoints;
    this.dataDir = dataDir;
    this.#ownsDataDir = ownsDataDir;
    this.#lines = lines;
    this.#ended = whenEnded(child);
  }

  /** @throws StartRefused when the master ends instead */
  static async start(start: MasterStart): Promise<MasterProcess> {
    const { program, network = ['--host', '127.0.0.1'], flags = [], nodeFlags = [] } = start;
    const dataDir = start.dataDir ?? mkdtempSync(join(tmpdir(), 'ubii-robustness-'));
    const isTrusted = start.loopback !== 'unsaid' && hasFlag(program, '--trust-loopback');
    const trust = isTrusted ? ['--trust-loopback'] : [];
    const port = flags.includes('--port') ? [] : ['--port', '0'];
    const command = [
      ...(start.within ?? []),
      ...(start.maxDescriptors === undefined
        ? []
        : ['bash', '-c', `ulimit -n ${start.maxDescriptors}; exec "$@"`, 'limited']),
      ...[process.execPath, ...nodeFlags, program, ...network, ...port, ...trust],
      ...['--legacy-ports', 'off', '--mdns', 'off', '--data-dir', dataDir],
      ...['--print-endpoints', 'json', '--log-format', 'json', ...flags],
    ];
    const child = spawn(command[0]!, command.slice(1), {
      stdio: ['ignore', 'pipe', 'pipe'],
      env: withoutSettings(process.env),
    });
    const killWithUs = (): void => void child.kill('SIGKILL');
    process.once('exit', killWithUs);
    child.once('exit', () => process.off('exit', killWithUs));
    const lines: string[] = [];
    const read = (line: string): void => {
      if (lines.length < MAX_KEPT_LINES) lines.push(line);
    };
    createInterface({ input: child.stderr! }).on('line', read);
    const endpoints = await new Promise<MasterEndpoints>((resolve, reject) => {
      const timer = setTimeout(() => {
        child.kill('SIGKILL');
        reject(new Error(`The master did not start within ${START_TIMEOUT_MS} ms.`));
      }, START_TIMEOUT_MS);
      createInterface({ input: child.stdout! }).on('line', (line) => {
        if (!line.startsWith('{')) return;
        clearTimeout(timer);
        resolve(JSON.parse(line) as MasterEndpoints);
      });
      child.once('close', (code) => {
        clearTimeout(timer);
        reject(new StartRefused(code, lines.join('\n')));
      });
    });
    return new MasterProcess(
      program,
      child,
      endpoints,
      dataDir,
      start.dataDir === undefined,
      lines,
    );
  }

  get pid(): number {
    return this.#child.pid!;
  }

  get port(): number {
    return Number(new URL(this.endpoints.url).port);
  }

  get isRunning(): boolean {
    return this.#child.exitCode === null && this.#child.signalCode === null;
  }

  /** How it ended, in words; undefined while it runs. */
  get ending(): string | undefined {
    return this.isRunning ? undefined : describeEnd(this.#child.exitCode, this.#child.signalCode);
  }

  /** Everything on standard error so far. */
  get log(): readonly string[] {
    return this.#lines;
  }

  /** Bytes of the log. */
  get logBytes(): number {
    return this.#lines.reduce((sum, line) => sum + Buffer.byteLength(line) + 1, 0);
  }

  /** Lines that no input may cause: errors, and what Node itself wrote. */
  get failures(): readonly string[] {
    return this.#lines.filter(isFailure);
  }

  figures(): ProcessFigures {
    return readProcess(this.pid);
  }

  /** @throws Error with the master's sentence when the reply is an error */
  async call(request: Init<ServiceRequest>, bearer?: string): Promise<ServiceReply> {
    const reply = await this.ask(request, bearer);
    if (reply.error !== undefined) {
      throw new Error(`${request.topic} was answered with: ${reply.error.message}`);
    }
    return reply;
  }

  /** Calls a service; an error is a reply as well. */
  async ask(request: Init<ServiceRequest>, bearer?: string): Promise<ServiceReply> {
    const response = await fetch(this.endpoints.servicesBinary, {
      method: 'POST',
      headers: {
        'content-type': 'application/octet-stream',
        ...(bearer === undefined ? {} : { authorization: `Bearer ${bearer}` }),
      },
      body: Buffer.from(encode('ubii.services.ServiceRequest', request)),
      signal: AbortSignal.timeout(CALL_TIMEOUT_MS),
    });
    return decode('ubii.services.ServiceReply', new Uint8Array(await response.arrayBuffer()));
  }

  /** Reads `/metrics`: names with labels, as Prometheus writes them, and their values. */
  async metrics(): Promise<ReadonlyMap<string, number>> {
    const response = await fetch(new URL('/metrics', this.endpoints.url), {
      signal: AbortSignal.timeout(CALL_TIMEOUT_MS),
    });
    const text = await response.text();
    if (!response.ok) throw new Error(`/metrics was answered with ${response.status}: ${text}`);
    return new Map(
      text
        .split('\n')
        .filter((line) => line !== '' && !line.startsWith('#'))
        .map((line) => {
          const at = line.lastIndexOf(' ');
          return [line.slice(0, at), Number(line.slice(at + 1))];
        }),
    );
  }

  /** Ends it without a warning, as a power cut would, and waits until it is gone. */
  async kill(): Promise<void> {
    this.#child.kill('SIGKILL');
    await this.#ended;
  }

  /** Ends it in good order; the data directory stays. */
  async stop(): Promise<void> {
    this.#child.kill('SIGTERM');
    const timer = setTimeout(() => this.#child.kill('SIGKILL'), STOP_TIMEOUT_MS);
    await this.#ended;
    clearTimeout(timer);
  }

  /** Ends it and removes the data directory, when it is this process's own. */
  async dispose(): Promise<void> {
    await this.stop();
    if (this.#ownsDataDir && existsSync(this.dataDir)) {
      rmSync(this.dataDir, { recursive: true, force: true });
    }
  }
}

function whenEnded(child: ChildProcess): Promise<void> {
  if (child.exitCode !== null || child.signalCode !== null) return Promise.resolve();
  return new Promise((resolve) => child.once('exit', () => resolve()));
}

/** The log is JSON lines; what else looks like these was written by Node itself. */
export function isFailure(line: string): boolean {
  if (line.startsWith('{')) {
    try {
      return (JSON.parse(line) as { level?: string }).level === 'error';
    } catch {
      return true;
    }
  }
  return /^\s+at .+:\d+:\d+\)?$|^\w*Error\b|^\(node:\d+\)/.test(line);
}

/** Settings of the person who runs this are not the master's. */
function withoutSettings(env: NodeJS.ProcessEnv): NodeJS.ProcessEnv {
  return Object.fromEntries(Object.entries(env).filter(([name]) => !name.startsWith('UBII_')));
}
