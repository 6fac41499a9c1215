import { spawn, type ChildProcess } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { isDeepStrictEqual } from 'node:util';
import { inject } from 'vitest';
import type { ClientKind } from './client-kind.ts';
import { EventLog } from './event-log.ts';

const CLIENTS = join(import.meta.dirname, '../clients');

/** Interval at which a value is published again that the Python node may have missed, milliseconds. */
const PUBLISH_AGAIN_MS = 1_000;

/** A record as the client's callback got it. The web node gives no format. */
export interface RecordEvent {
  readonly event: 'record';
  readonly subscription: string;
  readonly topic: string;
  readonly format?: string;
  readonly value: unknown;
}

/** A frame as it came over the client's socket. */
export interface FrameEvent {
  readonly event: 'frame';
  readonly kind: 'ping' | 'text' | 'record' | 'list' | 'error' | 'empty';
  readonly topic?: string;
  readonly text?: string;
}

/** Something the client wrote as a warning or an error. */
export interface ComplaintEvent {
  readonly event: 'complaint';
  readonly text: string;
}

/** Event reported by a driver. */
export type ClientEvent =
  | RecordEvent
  | FrameEvent
  | ComplaintEvent
  | { readonly event: 'ready' | 'open' }
  | { readonly event: 'close'; readonly code: number; readonly reason: string };

/** Data of a connected client. */
export interface Connected {
  readonly clientId: string;
  /** The client as the master's registration reply gave it. */
  readonly client: Record<string, unknown>;
  readonly server: Record<string, unknown>;
  /** Python: a topic out of the constants it parsed. */
  readonly subscriptionTopic?: string;
  /** Python: where it calls services once it knows the master's ports. */
  readonly servicesUrl?: string;
}

/** Addresses for a legacy client. */
export interface LegacyAddresses {
  readonly services: string;
  readonly topicData: string;
}

/** A record in the JSON form all three clients take. */
export type RecordInit = { readonly topic: string } & Readonly<Record<string, unknown>>;

interface Reply {
  readonly id: number;
  readonly result?: unknown;
  readonly error?: string;
}

/** A published client in a process of its own, commanded by the test. */
export class LegacyClient {
  readonly kind: ClientKind;
  readonly events = new EventLog<ClientEvent>();
  readonly #process: ChildProcess;
  readonly #folder: string;
  readonly #replies = new EventLog<Reply>();
  readonly #stderr: string[] = [];
  readonly #ended: Promise<void>;
  #commands = 0;

  private constructor(kind: ClientKind, process: ChildProcess, folder: string) {
    this.kind = kind;
    this.#process = process;
    this.#folder = folder;
    createInterface({ input: process.stderr! }).on('line', (line) => this.#stderr.push(line));
    createInterface({ input: process.stdout! }).on('line', (line) => this.#handleLine(line));
    this.#ended = new Promise((resolve) => {
      process.once('close', (code) => {
        const why = new Error(`The ${kind} client ended with ${code}.\n${this.#stderr.join('\n')}`);
        this.events.end(why);
        this.#replies.end(why);
        resolve();
      });
    });
  }

  /** Starts the driver; the client connects only when it is told to. */
  static async start(kind: ClientKind, prepare?: (folder: string) => Promise<void>) {
    const installation = inject('installations')[kind];
    if ('missing' in installation) throw new Error(installation.missing);
    // The nodejs node looks for modules and a configuration where it was started.
    const folder = await mkdtemp(join(tmpdir(), `ubii-interop-${kind}-`));
    await prepare?.(folder);
    const [command, driver] =
      kind === 'python'
        ? [join(installation.folder, 'bin/python'), 'python/driver.py']
        : [process.execPath, `${kind}/driver.mjs`];
    const running = spawn(command, [join(CLIENTS, driver)], {
      cwd: folder,
      env: { ...process.env, UBII_INTEROP_PACKAGES: installation.folder },
      stdio: ['pipe', 'pipe', 'pipe'],
    });
    const client = new LegacyClient(kind, running, folder);
    await client.events.waitFor('the driver being ready', (event) => event.event === 'ready');
    return client;
  }

  /** @param options Python: `modules` makes it a processing node with the modules of `modules.py` */
  async connect(
    addresses: LegacyAddresses,
    name: string,
    options: { readonly modules?: boolean } = {},
  ): Promise<Connected> {
    return (await this.#command('connect', { ...addresses, name, ...options })) as Connected;
  }

  /** Registers a device and gives it as the master replied, keys in camelCase. */
  async registerDevice(device: object): Promise<Record<string, unknown>> {
    return (await this.#command('registerDevice', { device })) as Record<string, unknown>;
  }

  /** nodejs and web only: any request as JSON. */
  async callService(request: object): Promise<Record<string, unknown>> {
    return (await this.#command('callService', { request })) as Record<string, unknown>;
  }

  async subscribeTopic(topic: string): Promise<void> {
    await this.#command('subscribeTopic', { topic });
  }

  async subscribeRegex(regex: string): Promise<void> {
    await this.#command('subscribeRegex', { regex });
  }

  /** nodejs only: ends a subscription by the topic or pattern of its start. */
  async unsubscribe(pattern: string): Promise<void> {
    await this.#command('unsubscribe', { pattern });
  }

  /** Publishes as one record each (`immediately`), or as the client bundles them: a list. */
  async publish(records: readonly RecordInit[], options?: { immediately: boolean }): Promise<void> {
    await this.#command('publish', { records, immediately: options?.immediately ?? false });
  }

  /** Web node only: opens a new socket under the same id. */
  async reconnect(): Promise<void> {
    await this.#command('reconnect', {});
  }

  /** Leaves as the client leaves by itself. */
  async disconnect(): Promise<void> {
    await this.#command('disconnect', {});
  }

  /** The next record of `topic` the client's callback got with the wanted value. */
  async receives(topic: string, value: unknown): Promise<RecordEvent> {
    return this.events.waitFor(
      `${JSON.stringify(value)} on ${topic} at the ${this.kind} client`,
      (event): event is RecordEvent =>
        event.event === 'record' && event.topic === topic && isDeepStrictEqual(event.value, value),
    );
  }

  /**
   * Publishes a value for this client and waits until its callback got it. The Python node loses what
   * comes while its callback runs; for it alone, the value is published again.
   */
  async isGiven(topic: string, value: unknown, publish: () => void | Promise<void>): Promise<void> {
    await publish();
    const received = this.receives(topic, value);
    if (this.kind !== 'python') return void (await received);
    const again = setInterval(() => void publish(), PUBLISH_AGAIN_MS);
    await received.finally(() => clearInterval(again));
  }

  /** Waits until the master has sent `count` pings in all. */
  async isPinged(count: number): Promise<void> {
    await this.events.waitFor(
      `ping ${count} at the ${this.kind} client`,
      (event) => event.event === 'frame' && event.kind === 'ping',
      count,
    );
  }

  /** Frames of topic data that came so far, by kind. */
  frames(kind: FrameEvent['kind']): number {
    return this.events.all.filter((event) => event.event === 'frame' && event.kind === kind).length;
  }

  /** Warnings and errors of the client so far. */
  get complaints(): readonly string[] {
    return this.events.all.flatMap((event) => (event.event === 'complaint' ? [event.text] : []));
  }

  /** Ends the process, whatever the client does about it. */
  async stop(): Promise<void> {
    this.#process.stdin?.end();
    const timer = setTimeout(() => this.#process.kill('SIGKILL'), 5_000);
    await this.#ended;
    clearTimeout(timer);
    await rm(this.#folder, { recursive: true, force: true });
  }

  async #command(command: string, params: object): Promise<unknown> {
    const id = ++this.#commands;
    this.#process.stdin!.write(`${JSON.stringify({ id, command, params })}\n`);
    const reply = await this.#replies.waitFor(
      `the ${this.kind} client's answer to ${command}`,
      (candidate) => candidate.id === id,
    );
    if (reply.error !== undefined) throw new Error(`${this.kind} ${command}: ${reply.error}`);
    return reply.result;
  }

  #handleLine(line: string): void {
    const message = JSON.parse(line) as ClientEvent | Reply;
    if ('id' in message) this.#replies.add(message);
    else this.events.add(message);
  }
}
