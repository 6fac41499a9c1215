import { AssetError } from '../assets/asset-error.ts';
import type { LoadedAssets } from '../assets/asset-store.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxResult } from '../ports/sandbox.ts';
import { BytePacker } from './byte-packer.ts';
import { checkSource } from './check-source.ts';
import type { Engine, MaybePromise } from './engine.ts';
import { Instance, type GivenParts, type InstanceHost } from './instance.ts';
import { cutText, describeThrown, isFatal, ModuleError, moduleFault } from './module-error.ts';
import type {
  HostBatch,
  HostLibraryNames,
  HostMessage,
  WorkerBatch,
  WorkerMessage,
} from './protocol.ts';
import { readRun, wireResult } from './run-wire.ts';
import { WorkerAssets } from './worker-assets.ts';

/** Environment of a worker. */
export interface WorkerPlatform {
  readonly engine: Engine;
  readonly hostLibraries: HostLibraryNames;
  post(batch: WorkerBatch, transfer: readonly ArrayBuffer[]): void;
  /** Loads a library for trusted code; rejects or gives undefined when there is none of that name. */
  importLibrary(name: string): Promise<unknown>;
  /** The value of a script; absent where text never becomes code of the worker. */
  evaluateLibrary?(script: string, sourceUrl: string): unknown;
  /** A batch was begun. */
  noteReceived(): void;
  /** The code of an instance is about to run; 0: none. */
  noteRunning(instance: number): void;
  /** Calls `fn` once all that is ready to run has run. */
  later(fn: () => void): void;
  nowMs(): number;
  /** Bytes that instances have together, where they share their memory. */
  sharedBytes?(): number;
}

/** Interval of reading shared memory, milliseconds. */
const SHARED_MEMORY_MS = 1_000;
/** Answers wait for the end of the batch, but no longer than this, milliseconds. */
const MAX_HELD_MS = 2;

type NamedMessage = Extract<HostMessage, { kind: string }>;
type MessageOf<K extends NamedMessage['kind']> = Extract<NamedMessage, { kind: K }>;

/** The program of a worker: takes batches of messages, runs instances, answers in batches. */
export class WorkerLoop {
  readonly #platform: WorkerPlatform;
  readonly #instances = new Map<number, Instance>();
  readonly #answers = new Map<number, (answer: MessageOf<'libraryAnswer'>) => void>();
  readonly #assetAnswers = new Map<number, (answer: MessageOf<'assetsAnswer'>) => void>();
  readonly #packer = new BytePacker();
  readonly #queue: HostMessage[] = [];
  /** By key. */
  readonly #assets = new Map<string, WorkerAssets>();
  #outgoing: WorkerMessage[] = [];
  #heldSinceMs = 0;
  #isBusy = false;
  #lastRequest = 0;
  /** Last reported memory of each instance. */
  readonly #toldBytes = new Map<number, number>();
  /** Instances whose code ran since that report. */
  readonly #touched = new Set<number>();
  #lookedMs = -Infinity;

  constructor(platform: WorkerPlatform) {
    this.#platform = platform;
    this.#send({ kind: 'ready' });
    this.#flush();
  }

  /** Takes what the host sent. */
  handleBatch(batch: HostBatch): void {
    this.#platform.noteReceived();
    this.#queue.push(...batch.messages);
    if (!this.#isBusy) this.#work();
  }

  /** Something failed that belongs to no call: timers of trusted code do. */
  handleStray(thrown: unknown): void {
    const text = cutText(`Outside of a callback: ${describeThrown(thrown)}`);
    for (const instance of this.#instances.keys()) {
      this.#send({ kind: 'log', instance, level: 'error', text });
    }
    this.#flush();
  }

  /** One message after the other. What one left to be run at once is run before the next. */
  #work(): void {
    this.#isBusy = true;
    for (let message = this.#queue.shift(); message !== undefined; message = this.#queue.shift()) {
      if (!this.#dispatch(message)) continue;
      this.#platform.later(() => {
        this.#platform.noteRunning(0);
        this.#work();
      });
      return;
    }
    this.#isBusy = false;
    this.#platform.noteRunning(0);
    this.#flush();
  }

  /** @returns whether something is left under way */
  #dispatch(message: HostMessage): boolean {
    if (!('kind' in message)) {
      const [instance, call] = message;
      return this.#call({ instance, call }, (called) => called.run(readRun(message)));
    }
    switch (message.kind) {
      case 'create':
        return this.#create(message);
      case 'assets':
        this.#assets.set(
          message.assets.key,
          new WorkerAssets(message.assets, this.#platform.evaluateLibrary?.bind(this.#platform)),
        );
        return false;
      case 'dropAssets':
        this.#assets.delete(message.key);
        return false;
      case 'assetsAnswer':
        this.#assetAnswers.get(message.request)?.(message);
        this.#assetAnswers.delete(message.request);
        return true;
      case 'halt':
        return this.#call(message, (instance) => instance.halt());
      case 'destroy':
        return this.#call(message, (instance) => {
          this.#instances.delete(message.instance);
          this.#toldBytes.delete(message.instance);
          return instance.destroy();
        });
      case 'free':
        this.#free(message.instance);
        return false;
      case 'check':
        this.#note(message.instance);
        return this.#answer(message, checkSource(this.#platform.engine, message.source));
      case 'libraryAnswer':
        this.#answers.get(message.request)?.(message);
        this.#answers.delete(message.request);
        // Waiting calls continue in a moment.
        return true;
    }
  }

  #create(message: MessageOf<'create'>): boolean {
    const { instance: number, request, owner, assets } = message;
    const instance = new Instance(request, this.#hostOf(owner, assets), {
      onLog: (level, text) => this.#send({ kind: 'log', instance: number, level, text }),
      callHost: (library, method, args) => this.#callHost(number, library, method, args),
      loadAssets: (name) => this.#loadAssets(number, name),
      onResume: () => this.#note(number),
      onFailed: (fault) => this.#end(number, fault),
    });
    this.#instances.set(number, instance);
    return this.#call(message, () => instance.create());
  }

  #call(
    message: { readonly instance: number; readonly call: number },
    call: (instance: Instance) => MaybePromise<SandboxResult | void>,
  ): boolean {
    const instance = this.#instances.get(message.instance);
    if (instance === undefined) {
      const fault = moduleFault('crashed', '', 'The instance has ended.');
      this.#send({ kind: 'failed', call: message.call, fault });
      return false;
    }
    this.#note(message.instance);
    try {
      return this.#answer(message, call(instance));
    } catch (fault) {
      this.#fail(message, fault as ModuleFault);
      return false;
    }
  }

  #answer(
    message: { readonly instance: number; readonly call: number },
    answer: MaybePromise<SandboxResult | ModuleFault | void>,
  ): boolean {
    const { call } = message;
    if (!(answer instanceof Promise)) {
      this.#done(call, answer ?? undefined);
      return false;
    }
    answer
      .then(
        (result) => this.#done(call, result ?? undefined),
        (fault: ModuleFault) => this.#fail(message, fault),
      )
      .finally(() => {
        this.#touched.add(message.instance);
        if (!this.#isBusy) this.#flush();
      });
    return true;
  }

  #done(call: number, result: SandboxResult | ModuleFault | undefined): void {
    if (result !== undefined && 'outputs' in result) {
      this.#send(wireResult(call, result, this.#packer));
    } else this.#send({ kind: 'done', call, fault: result });
  }

  #fail(message: { readonly instance: number; readonly call: number }, fault: ModuleFault): void {
    this.#send({ kind: 'failed', call: message.call, fault });
    if (isFatal(fault)) this.#end(message.instance, fault);
  }

  #end(instance: number, fault: ModuleFault): void {
    if (!this.#instances.has(instance)) return;
    this.#free(instance);
    this.#send({ kind: 'killed', instance, fault });
    if (!this.#isBusy) this.#flush();
  }

  #free(instance: number): void {
    this.#instances.get(instance)?.free();
    this.#instances.delete(instance);
    this.#toldBytes.delete(instance);
  }

  #callHost(
    instance: number,
    library: string,
    method: string,
    args: readonly unknown[],
  ): Promise<unknown> {
    const request = ++this.#lastRequest;
    return new Promise((resolve, reject) => {
      // Only data travels; throws for cycles.
      const data = JSON.parse(JSON.stringify(args)) as unknown[];
      this.#answers.set(request, ({ isFulfilled, value }) => {
        if (isFulfilled) resolve(value);
        else reject(new Error(String(value)));
      });
      this.#send({ kind: 'libraryCall', instance, request, library, method, args: data });
      if (!this.#isBusy) this.#flush();
    });
  }

  #loadAssets(instance: number, name: string): Promise<LoadedAssets['files']> {
    const request = ++this.#lastRequest;
    return new Promise((resolve, reject) => {
      this.#assetAnswers.set(request, ({ result }) => {
        if ('code' in result) return reject(new AssetError(result.code, result.message));
        resolve(this.#assets.get(result.key)!.files);
      });
      this.#send({ kind: 'loadAssets', instance, request, name });
      if (!this.#isBusy) this.#flush();
    });
  }

  #hostOf(owner: number, assets: readonly string[]): InstanceHost {
    return {
      engine: this.#platform.engine,
      owner,
      nowMs: () => this.#platform.nowMs(),
      loadLibraries: (names) =>
        names.length + assets.length === 0 ? NO_LIBRARIES : this.#loadLibraries(names, assets),
    };
  }

  async #loadLibraries(
    names: readonly string[],
    assetKeys: readonly string[],
  ): Promise<GivenParts> {
    const modules: Record<string, unknown> = {};
    const hostLibraries: Record<string, readonly string[]> = {};
    for (const name of names) {
      if (Object.hasOwn(this.#platform.hostLibraries, name)) {
        hostLibraries[name] = this.#platform.hostLibraries[name]!;
      } else modules[name] = await this.#importLibrary(name);
    }
    const sets = assetKeys.flatMap((key) => this.#assets.get(key) ?? []);
    for (const set of sets) if (set.isLibrary) modules[set.name] = set.library();
    const assets = Object.fromEntries(sets.map(({ name, files }) => [name, files]));
    return { modules, hostLibraries, assets };
  }

  async #importLibrary(name: string): Promise<unknown> {
    let why = 'the node does not offer this library';
    try {
      const library = await this.#platform.importLibrary(name);
      if (library !== undefined) return library;
    } catch (thrown) {
      why = `${describeThrown(thrown)}`;
    }
    const message = `The node cannot load the library ${name}: ${why}.`;
    throw new ModuleError(moduleFault('library', 'onCreated', message));
  }

  #note(instance: number): void {
    if (this.#outgoing.length > 0 && this.#platform.nowMs() - this.#heldSinceMs > MAX_HELD_MS) {
      this.#flush();
    }
    this.#touched.add(instance);
    this.#platform.noteRunning(instance);
  }

  #send(message: WorkerMessage): void {
    if (this.#outgoing.length === 0) this.#heldSinceMs = this.#platform.nowMs();
    this.#outgoing.push(message);
  }

  #sendMemory(): void {
    const sharedBytes = this.#platform.sharedBytes;
    const nowMs = this.#platform.nowMs();
    const isDue = sharedBytes !== undefined && nowMs - this.#lookedMs >= SHARED_MEMORY_MS;
    if (isDue && this.#instances.size > 0) {
      this.#lookedMs = nowMs;
      const share = Math.round(sharedBytes() / this.#instances.size);
      for (const number of this.#instances.keys()) this.#sendBytes(number, share);
    }
    for (const number of this.#touched) {
      this.#sendBytes(number, this.#instances.get(number)?.memoryBytes());
    }
    this.#touched.clear();
  }

  #sendBytes(number: number, bytes: number | undefined): void {
    if (bytes === undefined || bytes === this.#toldBytes.get(number)) return;
    this.#toldBytes.set(number, bytes);
    this.#send({ kind: 'memory', instance: number, bytes });
  }

  #flush(): void {
    this.#sendMemory();
    const messages = this.#outgoing;
    this.#outgoing = [];
    this.#platform.post({ messages }, this.#packer.pack());
  }
}

const NO_LIBRARIES = { modules: {}, hostLibraries: {}, assets: {} };
