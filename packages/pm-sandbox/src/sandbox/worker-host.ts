import { AssetError } from '../assets/asset-error.ts';
import type { LoadedAssets } from '../assets/asset-store.ts';
import type { ModuleFault, ModulePhase } from '../ports/module-fault.ts';
import type { ModuleSource, SandboxCall, SandboxRequest, SandboxResult } from '../ports/sandbox.ts';
import { AWAIT_TIMEOUT_MS, TRUSTED_CREATE_TIMEOUT_MS } from '../sandbox-limits.ts';
import { BytePacker } from '../worker/byte-packer.ts';
import { describeThrown, moduleFault } from '../worker/module-error.ts';
import type { HostMessage, WorkerBatch, WorkerKind, WorkerMessage } from '../worker/protocol.ts';
import { readResult, wireRun } from '../worker/run-wire.ts';
import type { MemoryUse, PoolMemory } from './pool-memory.ts';
import { Watchdog, type Verdict, type WatchedCall } from './watchdog.ts';
import type { PoolOptions, PoolPlatform, WorkerLink } from './worker-link.ts';

/** One instance as its worker's host knows it. */
export interface HostedInstance {
  readonly request: SandboxRequest;
  onLog(line: { readonly level: string; readonly text: string }): void;
  onMemory(bytes: number): void;
  /** Loads an optional asset set of the instance. */
  loadAssets(name: string): Promise<LoadedAssets>;
  /** It is gone, and its calls have rejected. */
  onKilled(fault: ModuleFault): void;
  /** The host ends its worker. */
  onClosed(fault: ModuleFault): void;
}

/** A call under way. */
interface PendingCall extends WatchedCall {
  readonly instance: number;
  readonly phase: ModulePhase;
  resolve(result: unknown): void;
  reject(fault: ModuleFault): void;
}

/** Time limit of a check, after which its worker is ended; the check has its own limits inside. */
const CHECK_TIMEOUT_MS = 500;
const DEAF = 'The worker does not answer: a timer or another background job of a module blocks it.';

/** One worker: sends calls in batches, takes answers, and watches that they come. */
export class WorkerHost {
  readonly #kind: WorkerKind;
  /** Instance it was made for alone. */
  readonly isSolo: boolean;
  readonly #platform: PoolPlatform;
  readonly #options: PoolOptions;
  readonly #memory: PoolMemory;
  readonly #onEnd: (culprit: SandboxRequest | undefined) => void;
  readonly #link: WorkerLink;
  readonly #instances = new Map<number, HostedInstance>();
  readonly #calls = new Map<number, PendingCall>();
  readonly #packer = new BytePacker();
  readonly #watchdog: Watchdog<PendingCall>;
  #outgoing: HostMessage[] = [];
  /** Buffers of asset sets that go with it. */
  #transfers: ArrayBuffer[] = [];
  /** Asset sets of each instance, by their keys. */
  readonly #assetsOf = new Map<number, Map<string, LoadedAssets>>();
  /** Memory by owner. */
  readonly #owners = new Map<number, MemoryUse>();
  #lastInstance = 0;
  #lastCall = 0;
  #sentBatches = 0;
  #isReady = false;
  #isEnded = false;

  constructor(
    kind: WorkerKind,
    isSolo: boolean,
    platform: PoolPlatform,
    options: PoolOptions,
    memory: PoolMemory,
    /** The worker is over; `culprit` is who it was ended for. */
    onEnd: (culprit: SandboxRequest | undefined) => void,
  ) {
    this.#kind = kind;
    this.isSolo = isSolo;
    this.#platform = platform;
    this.#options = options;
    this.#memory = memory;
    this.#onEnd = onEnd;
    this.#watchdog = new Watchdog(
      {
        isReady: () => this.#isReady,
        progress: () => this.#link.progress(),
        sentBatches: () => this.#sentBatches,
        calls: () => [...this.#calls.values()],
        limitMs: (instance) => this.#limitMs(instance),
        onVerdict: (verdict) => this.#handleVerdict(verdict),
        onRest: () => this.#link.setActive(false),
      },
      (intervalMs, fn) => platform.every(intervalMs, fn),
      platform.cpuMs,
    );
    const hostLibraries = Object.fromEntries(
      Object.entries(options.hostLibraries).map(([name, library]) => [name, Object.keys(library)]),
    );
    const libraries = kind === 'trusted' ? options.libraries : {};
    const cells = memory.addWorker();
    this.#link = platform.startWorker(
      { kind, hostLibraries, libraries, memory: cells },
      {
        onBatch: (batch) => this.#handleBatch(batch),
        onGone: () => memory.removeWorker(cells),
        onExit: ({ kind: reason, message }) => this.#handleExit(reason, message),
      },
    );
  }

  /** Instances that live in it. */
  get load(): number {
    return this.#instances.size;
  }

  get isIdle(): boolean {
    return this.#instances.size === 0 && this.#calls.size === 0;
  }

  /** Takes in an instance. @returns its number here */
  add(instance: HostedInstance): number {
    this.#instances.set(++this.#lastInstance, instance);
    this.#owners.set(this.#lastInstance, this.#memory.enter(instance.request.owner));
    this.#assetsOf.set(this.#lastInstance, new Map());
    for (const assets of instance.request.assets) this.#giveAssets(this.#lastInstance, assets);
    return this.#lastInstance;
  }

  create(instance: number): Promise<void> {
    const { assets, ...request } = this.#instances.get(instance)!.request;
    return this.#call(instance, 'onCreated', (call) => ({
      kind: 'create',
      instance,
      call,
      request,
      assets: assets.map(({ key }) => key),
      owner: this.#owners.get(instance)?.number ?? 0,
    }));
  }

  run(instance: number, run: SandboxCall): Promise<SandboxResult> {
    return this.#call(instance, 'onProcessing', (call) =>
      wireRun(instance, call, run, this.#packer),
    );
  }

  halt(instance: number): Promise<void> {
    return this.#call(instance, 'onHalted', (call) => ({ kind: 'halt', instance, call }));
  }

  destroy(instance: number): Promise<void> {
    return this.#call(instance, 'onDestroyed', (call) => ({ kind: 'destroy', instance, call }));
  }

  /** Lets go of an instance; what is pending of it rejects. */
  free(instance: number, fault: ModuleFault): void {
    if (!this.#forget(instance)) return;
    this.#send({ kind: 'free', instance });
    this.#rejectCalls(
      (call) => call.instance === instance,
      () => fault,
    );
  }

  check(source: ModuleSource): Promise<ModuleFault | undefined> {
    const instance = ++this.#lastInstance;
    return this.#call(instance, '', (call) => ({ kind: 'check', instance, call, source }));
  }

  /** Ends the worker on request: pending calls reject, and no instance is reported as killed. */
  end(fault: ModuleFault): void {
    for (const instance of this.#instances.values()) instance.onClosed(fault);
    this.#forgetAll();
    this.#endAll(undefined, () => fault);
  }

  #call<T>(
    instance: number,
    phase: ModulePhase,
    message: (call: number) => HostMessage,
  ): Promise<T> {
    const call = ++this.#lastCall;
    return new Promise<T>((resolve, reject) => {
      if (this.#isEnded) {
        reject(moduleFault('crashed', phase, 'The worker has ended.'));
        return;
      }
      const isLongCreate = phase === 'onCreated' && this.#kind === 'trusted';
      const pending: PendingCall = {
        instance,
        phase,
        resolve: resolve as (result: unknown) => void,
        reject,
        waitLimitMs: isLongCreate ? TRUSTED_CREATE_TIMEOUT_MS : AWAIT_TIMEOUT_MS,
        looks: 0,
      };
      this.#calls.set(call, pending);
      this.#send(message(call));
      if (this.#watchdog.start()) this.#link.setActive(true);
    });
  }

  /** One copy for all instances of the worker. [PM-91] */
  #giveAssets(instance: number, assets: LoadedAssets): void {
    const hasAlready = this.#hasAssets(assets.key);
    this.#assetsOf.get(instance)!.set(assets.key, assets);
    if (hasAlready) return;
    const files = Object.fromEntries(
      Object.entries(assets.files).map(([path, bytes]) => [path, bytes.slice()]),
    );
    this.#transfers.push(...Object.values(files).map(({ buffer }) => buffer));
    this.#send({ kind: 'assets', assets: { ...assets, files } });
  }

  #hasAssets(key: string): boolean {
    return [...this.#assetsOf.values()].some((assets) => assets.has(key));
  }

  #takeAssets(instance: number): void {
    const had = this.#assetsOf.get(instance);
    this.#assetsOf.delete(instance);
    for (const key of had?.keys() ?? []) {
      if (!this.#hasAssets(key)) this.#send({ kind: 'dropAssets', key });
    }
  }

  /** [PM-96] */
  #loadAssets({ instance, request, name }: Extract<WorkerMessage, { kind: 'loadAssets' }>): void {
    const answer = (result: Extract<HostMessage, { kind: 'assetsAnswer' }>['result']): void => {
      // Of an instance that has ended meanwhile nothing waits.
      if (this.#instances.has(instance)) this.#send({ kind: 'assetsAnswer', request, result });
    };
    this.#instances
      .get(instance)
      ?.loadAssets(name)
      .then(
        (assets) => {
          if (this.#instances.has(instance)) this.#giveAssets(instance, assets);
          answer({ key: assets.key });
        },
        (thrown: unknown) =>
          answer({
            code: thrown instanceof AssetError ? thrown.code : 'unreachable',
            message: thrown instanceof Error ? thrown.message : String(thrown),
          }),
      );
  }

  #send(message: HostMessage): void {
    if (this.#isEnded) return;
    this.#outgoing.push(message);
    if (this.#outgoing.length === 1) this.#platform.atEndOfTurn(() => this.#flush());
  }

  #flush(): void {
    if (this.#isEnded || this.#outgoing.length === 0) return;
    const messages = this.#outgoing;
    this.#outgoing = [];
    this.#sentBatches++;
    const assets = this.#transfers;
    this.#transfers = [];
    this.#link.post({ messages }, [...this.#packer.pack(), ...assets]);
  }

  #handleBatch(batch: WorkerBatch): void {
    for (const message of batch.messages) {
      if (this.#isEnded) return;
      this.#handleMessage(message);
    }
  }

  #handleMessage(message: WorkerMessage): void {
    if (!('kind' in message)) {
      this.#takeCall(message[0])?.resolve(readResult(message));
      return;
    }
    switch (message.kind) {
      case 'ready':
        this.#isReady = true;
        return;
      case 'done': {
        const call = this.#takeCall(message.call);
        call?.resolve(message.fault);
        if (call?.phase === 'onDestroyed') this.#forget(call.instance);
        return;
      }
      case 'failed': {
        const call = this.#takeCall(message.call);
        call?.reject(message.fault);
        if (call?.phase === 'onDestroyed') this.#forget(call.instance);
        return;
      }
      case 'killed':
        return this.#kill(message.instance, message.fault);
      case 'log':
        return this.#instances.get(message.instance)?.onLog(message);
      case 'memory':
        this.#owners.get(message.instance)?.note(message.bytes);
        return this.#instances.get(message.instance)?.onMemory(message.bytes);
      case 'loadAssets':
        return this.#loadAssets(message);
      case 'libraryCall':
        return this.#callLibrary(message);
    }
  }

  #forget(instance: number): boolean {
    this.#owners.get(instance)?.leave();
    this.#owners.delete(instance);
    this.#takeAssets(instance);
    return this.#instances.delete(instance);
  }

  #forgetAll(): void {
    for (const number of [...this.#instances.keys()]) this.#forget(number);
  }

  #takeCall(number: number): PendingCall | undefined {
    const call = this.#calls.get(number);
    this.#calls.delete(number);
    return call;
  }

  #callLibrary(message: Extract<WorkerMessage, { kind: 'libraryCall' }>): void {
    const { request, library, method, args } = message;
    const answer = (isFulfilled: boolean, value: unknown): void =>
      this.#send({ kind: 'libraryAnswer', request, isFulfilled, value });
    // The names come from the worker: only what was offered is called.
    const { hostLibraries } = this.#options;
    const isOffered =
      Object.hasOwn(hostLibraries, library) && Object.hasOwn(hostLibraries[library]!, method);
    if (!isOffered) {
      answer(false, `There is no ${library}.${method}.`);
      return;
    }
    hostLibraries[library]![method]!(...args).then(
      (value) => answer(true, value),
      (thrown: unknown) => answer(false, describeThrown(thrown)),
    );
  }

  /** One instance is gone, the worker goes on. */
  #kill(number: number, fault: ModuleFault): void {
    const instance = this.#instances.get(number);
    if (instance === undefined) return;
    this.#forget(number);
    this.#rejectCalls(
      (call) => call.instance === number,
      () => fault,
    );
    instance.onKilled(fault);
  }

  #rejectCalls(
    isMeant: (call: PendingCall) => boolean,
    faultOf: (call: PendingCall) => ModuleFault,
  ): void {
    for (const [number, call] of this.#calls) {
      if (!isMeant(call)) continue;
      this.#calls.delete(number);
      call.reject(faultOf(call));
    }
  }

  #handleExit(reason: 'memory' | 'exit', message: string): void {
    const { running } = this.#link.progress();
    const phase = this.#phaseOf(running);
    this.#endAll(running, () => {
      if (reason === 'exit') return moduleFault('crashed', phase, message);
      return moduleFault(
        'memory',
        phase,
        `${phase || 'The module'} used up the memory of its worker.`,
      );
    });
  }

  /** Ends the worker. The culprit gets the fault; the others lose their state without fault of theirs. */
  #endAll(culprit: number | undefined, faultOf: () => ModuleFault): void {
    if (this.#isEnded) return;
    this.#isEnded = true;
    this.#watchdog.stop();
    this.#link.terminate();
    const fault = faultOf();
    const name = culprit === undefined ? undefined : this.#instances.get(culprit)?.request;
    const because =
      name === undefined
        ? fault.message
        : `The worker that it shares with "${name.moduleName}" was ended because of that module.`;
    const text = `${because} The module lost its state.`;
    const crashed = { ...moduleFault('crashed', '', text), isOfOther: true };
    const instances = [...this.#instances];
    this.#forgetAll();
    this.#onEnd(name);
    const isHit = (number: number): boolean =>
      name === undefined ? culprit === undefined : number === culprit;
    for (const [number, call] of this.#calls) {
      this.#calls.delete(number);
      call.reject(isHit(call.instance) || call.instance === culprit ? fault : crashed);
    }
    for (const [number, instance] of instances) instance.onKilled(isHit(number) ? fault : crashed);
  }

  #phaseOf(instance: number): ModulePhase {
    for (const call of this.#calls.values()) if (call.instance === instance) return call.phase;
    return '';
  }

  #handleVerdict(verdict: Verdict<PendingCall>): void {
    switch (verdict.kind) {
      case 'start':
        return this.#endAll(undefined, () =>
          moduleFault('crashed', '', 'The worker did not start.'),
        );
      case 'deaf':
        return this.#endAll(undefined, () => moduleFault('crashed', '', DEAF));
      case 'loop': {
        const { instance } = verdict;
        const phase = this.#phaseOf(instance);
        const text = `${phase || 'The source'} took longer than ${this.#limitMs(instance)} ms, the limit of one call.`;
        return this.#endAll(instance, () => moduleFault('timeout', phase, text));
      }
      case 'wait': {
        const { instance, phase, waitLimitMs } = verdict.call;
        if (!this.#instances.has(instance)) return;
        const text = `${phase} waited longer than ${waitLimitMs} ms for a promise, the limit of one call.`;
        this.#send({ kind: 'free', instance });
        return this.#kill(instance, moduleFault('timeout', phase, text));
      }
    }
  }

  #limitMs(number: number): number {
    const request = this.#instances.get(number)?.request;
    if (request === undefined) return CHECK_TIMEOUT_MS;
    return request.isTrusted && this.#phaseOf(number) === 'onCreated'
      ? TRUSTED_CREATE_TIMEOUT_MS
      : request.limits.callTimeoutMs;
  }
}
