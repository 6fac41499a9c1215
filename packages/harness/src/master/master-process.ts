import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';

import { readProcess, type ProcessFigures } from '../process/process-figures.ts';
import { ServerProcess } from '../process/server-process.ts';
import { BUILT_MASTER, expectBuilt, hasFlag, isOwnBuild } from './built-programs.ts';
import { masterCommand, type MasterStart, type ResolvedStart } from './command-line.ts';
import { askService, expectReply, readMetrics } from './service-call.ts';

/**
 * Returns whether a log line reports a defect: a JSON line of level `error`, or an error or warning that Node itself
 * printed.
 */
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

/** The line of `--print-endpoints json`. */
export interface MasterEndpoints {
  readonly url: string;
  readonly servicesJson: string;
  readonly servicesBinary: string;
  readonly topicDataWs: string;
  readonly pid: number;
  /** Token for joining; undefined for a master on loopback only. */
  readonly joinToken?: string;
  readonly joinCode?: string;
  /** Token for becoming admin on the master's computer. */
  readonly adminToken: string;
  readonly adminCode: string;
}

/**
 * A built master as a process of its own, with everything it logged. Restarted, it keeps port and data folder, as after a
 * crash or an update.
 */
export class MasterProcess {
  readonly #start: ResolvedStart;
  readonly #ownsDataDir: boolean;
  readonly #log: string[];
  #server: ServerProcess;

  private constructor(
    start: ResolvedStart,
    ownsDataDir: boolean,
    log: string[],
    server: ServerProcess,
  ) {
    this.#start = start;
    this.#ownsDataDir = ownsDataDir;
    this.#log = log;
    this.#server = server;
  }

  /** @throws StartRefused when the master ends instead */
  static async start(start: MasterStart = {}): Promise<MasterProcess> {
    const { program = BUILT_MASTER } = start;
    expectBuilt(program);
    const dataDir = start.dataDir ?? mkdtempSync(join(tmpdir(), 'ubii-master-'));
    const ownsDataDir = start.dataDir === undefined;
    const log: string[] = [];
    const resolved = { ...start, program, dataDir };
    try {
      return new MasterProcess(resolved, ownsDataDir, log, await launch(resolved, log));
    } catch (error) {
      if (ownsDataDir) removeFolder(dataDir);
      throw error;
    }
  }

  /** Main file that runs. */
  get program(): string {
    return this.#start.program;
  }

  get dataDir(): string {
    return this.#start.dataDir;
  }

  get endpoints(): MasterEndpoints {
    return this.#server.ready as unknown as MasterEndpoints;
  }

  /** Origin of pages and services, without a slash at the end. */
  get url(): string {
    return this.endpoints.url.replace(/\/$/, '');
  }

  get port(): number {
    return Number(new URL(this.endpoints.url).port);
  }

  get pid(): number {
    return this.#server.pid;
  }

  get isRunning(): boolean {
    return this.#server.isRunning;
  }

  /** How it ended, in words; undefined while it runs. */
  get ending(): string | undefined {
    return this.#server.ending;
  }

  /** Lines of standard error of all runs so far. */
  get log(): readonly string[] {
    return this.#log;
  }

  /** Size of the log, bytes. */
  get logBytes(): number {
    return this.#log.reduce((sum, line) => sum + Buffer.byteLength(line) + 1, 0);
  }

  /** Log lines that no input may cause: errors, and what Node itself printed. */
  get failures(): readonly string[] {
    return this.#log.filter(isFailure);
  }

  figures(): ProcessFigures {
    return readProcess(this.pid);
  }

  /** Calls a service. @throws Error with the master's sentence when the reply is an error */
  async call(request: Init<ServiceRequest>, bearer?: string): Promise<ServiceReply> {
    return expectReply(request, await this.ask(request, bearer));
  }

  /** Calls a service; an error is a reply as well. */
  ask(request: Init<ServiceRequest>, bearer?: string): Promise<ServiceReply> {
    return askService(this.endpoints.servicesBinary, request, bearer);
  }

  /** Reads `/metrics`: names with labels, as Prometheus writes them, and their values. */
  metrics(): Promise<ReadonlyMap<string, number>> {
    return readMetrics(this.endpoints.url);
  }

  /** Ends it without a warning, as a power cut does, and waits until it is gone. */
  kill(): Promise<void> {
    return this.#server.kill();
  }

  /**
   * Ends it in good order; the data folder stays.
   *
   * @throws Error when it does not stop within 20 s and is killed
   */
  stop(): Promise<void> {
    return this.#server.stop();
  }

  /** Starts it again on the same port and data folder, after it was stopped or killed. */
  async restart(): Promise<void> {
    const { flags = [] } = this.#start;
    const port = ['--port', String(this.port)];
    await this.stop();
    this.#server = await launch({ ...this.#start, flags: [...flags, ...port] }, this.#log);
  }

  /** Ends it in any case, and removes the data folder unless it was given. */
  async dispose(): Promise<void> {
    await this.#server.end();
    if (this.#ownsDataDir) removeFolder(this.dataDir);
  }
}

function launch(start: ResolvedStart, log: string[]): Promise<ServerProcess> {
  const { program, trustsLoopback = true } = start;
  const isTrusted = trustsLoopback && (isOwnBuild(program) || hasFlag(program, '--trust-loopback'));
  return ServerProcess.start({
    name: 'The master',
    command: masterCommand(start, isTrusted),
    log,
  });
}

function removeFolder(path: string): void {
  rmSync(path, { recursive: true, force: true, maxRetries: 5 });
}
