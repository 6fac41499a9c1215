import type { QuickJSContext, QuickJSHandle, QuickJSRuntime } from 'quickjs-emscripten-core';
import { callbackSource } from '../../definition/callback-source.ts';
import type { ModulePhase } from '../../ports/module-fault.ts';
import { MAX_LIBRARY_CALLS } from '../../sandbox-limits.ts';
import type {
  EngineHooks,
  EngineInstance,
  EngineRequest,
  MaybePromise,
  RawResult,
} from '../engine.ts';
import { CONSOLE_LEVELS, SILENT_CONSOLE_METHODS } from '../format-log.ts';
import type { MemoryAccount } from '../memory-account.ts';
import { describeThrown, EngineBrokenError, ModuleError, moduleFault } from '../module-error.ts';
import type { InputValues } from '../module-records.ts';
import { AWAIT_ADVICE } from '../value-words.ts';
import type { EngineCopy } from './load-quickjs.ts';
import { loopPosition } from './loop-position.ts';
import { outOfMemory } from './out-of-memory.ts';
import { parseJson } from './parse-json.ts';
import { positionOf } from './position-of.ts';
import { prelude, type PreludeApi } from './prelude.ts';
import { readResult, readThrown, type CallResult, type ThrownText } from './read-result.ts';
import { TimeBudget } from './time-budget.ts';
import { writeJson } from './write-json.ts';

type Phase = Exclude<ModulePhase, ''>;

/** Functions that differ between the platforms. */
export interface QuickJsOptions {
  /** Of the engine, bytes; the stack of the thread must bear it several times over. */
  readonly stackBytes: number;
  nowMs(): number;
  /** See TimeBudget; left out where it is not known. */
  cpuMs?(): number;
}

const PHASES: readonly Phase[] = ['onCreated', 'onProcessing', 'onHalted', 'onDestroyed'];
const PRELUDE_SOURCE = `(${callbackSource(prelude, 'prelude')})`;
/** For reading the source, however little a call may take: the first run of the engine is slow. */
const MIN_LOAD_MS = 400;
/** For telling what was thrown, which may be an object of the module's. */
const REPORT_MS = 50;
/** Jobs between two looks at the clock: chains of promises do not come by the interrupt handler. */
const JOBS_AT_ONCE = 100;
const UNKNOWN: ThrownText = { name: '', message: 'a value that cannot be shown', stack: '' };
const OUT_OF_MEMORY: ThrownText = { name: 'InternalError', message: 'out of memory', stack: '' };
const NO_OUTPUTS: RawResult = { outputs: [], problem: undefined };

/** One module in a runtime of its own. */
export class QuickJsInstance implements EngineInstance {
  readonly #request: EngineRequest;
  readonly #hooks: EngineHooks;
  readonly #copy: EngineCopy;
  readonly #memory: MemoryAccount | undefined;
  readonly #runtime: QuickJSRuntime;
  readonly #context: QuickJSContext;
  readonly #budget: TimeBudget;
  readonly #api = new Map<keyof PreludeApi, QuickJSHandle>();
  #phase: Phase = 'onCreated';
  #hostCalls = 0;
  #isFree = false;
  /** Waits for the result of the call under way. */
  #waiting: { resolve(result: CallResult): void; reject(thrown: unknown): void } | undefined;

  constructor(
    copy: EngineCopy,
    request: EngineRequest,
    hooks: EngineHooks,
    options: QuickJsOptions,
    memory: MemoryAccount | undefined,
  ) {
    this.#memory = memory;
    this.#request = request;
    this.#hooks = hooks;
    this.#budget = new TimeBudget(() => options.nowMs(), options.cpuMs);
    this.#copy = copy;
    this.#runtime = copy.quickJs.newRuntime();
    this.#runtime.setMemoryLimit(request.limits.memoryBytes);
    this.#runtime.setMaxStackSize(options.stackBytes);
    this.#runtime.setInterruptHandler(() => this.#budget.look());
    this.#context = this.#runtime.newContext();
    this.#load();
  }

  call(phase: Exclude<Phase, 'onProcessing'>): MaybePromise<void> {
    if (!this.#request.source[phase]?.trim()) return;
    const result = this.#invoke(phase, 'call', [this.#context.newString(phase)]);
    if (result instanceof Promise) return result.then(() => undefined);
  }

  process(
    deltaTimeMs: number,
    inputs: InputValues,
    triggers: readonly string[] | undefined,
    masterTimeMs: number | undefined,
  ): MaybePromise<RawResult> {
    const context = this.#context;
    const { json, blobs, hasMarks } = writeJson(inputs);
    this.#phase = 'onProcessing';
    const args = this.#safely(() => [
      context.newNumber(deltaTimeMs),
      masterTimeMs === undefined ? context.undefined : context.newNumber(masterTimeMs),
      context.newString(json),
      triggers === undefined ? context.undefined : context.newString(JSON.stringify(triggers)),
      hasMarks ? context.true : context.false,
      ...blobs.map((blob) => context.newArrayBuffer(blob)),
    ]);
    return this.#invoke('onProcessing', 'process', args);
  }

  /** The engine is this instance's alone: letting go of it frees all that is in it. */
  free(): void {
    this.#isFree = true;
    this.#waiting = undefined;
    this.#runtime.removeInterruptHandler();
    this.#copy.release();
  }

  memoryBytes(): number {
    return this.#copy.memoryBytes();
  }

  get #wasRefusedMemory(): boolean {
    return this.#copy.refusedMemory() !== undefined;
  }

  #load(): void {
    const { outputNames, hostLibraries, source, limits } = this.#request;
    const context = this.#context;
    this.#budget.begin(Math.max(limits.callTimeoutMs, MIN_LOAD_MS));
    const texts = [outputNames, hostLibraries, CONSOLE_LEVELS, SILENT_CONSOLE_METHODS];
    const literals = texts.map((value) => this.#evaluate(`(${JSON.stringify(value)})`, 'prelude'));
    const functions = [this.#logFunction(), this.#hostFunction()];
    const advice = context.newString(AWAIT_ADVICE);
    const make = this.#evaluate(PRELUDE_SOURCE, 'prelude');
    const api = this.#enter(() =>
      context.callFunction(make, context.undefined, ...literals, ...functions, advice),
    );
    for (const handle of [make, ...literals, ...functions, advice]) handle.dispose();
    for (const name of ['load', 'call', 'process', 'poll', 'settle', 'blob', 'describe'] as const) {
      this.#api.set(name, context.getProp(api, name));
    }
    api.dispose();
    for (const phase of PHASES) {
      const text = source[phase];
      if (text?.trim()) this.#loadCallback(phase, text);
    }
  }

  #loadCallback(phase: Phase, text: string): void {
    this.#phase = phase;
    const context = this.#context;
    const callback = this.#evaluate(`(${text}\n)`, phase);
    const type = context.typeof(callback);
    if (type !== 'function') {
      callback.dispose();
      const message = `The source of ${phase} must be a function, not ${type}.`;
      throw new ModuleError(moduleFault('missing', phase, message));
    }
    const name = context.newString(phase);
    this.#enter(() =>
      context.callFunction(this.#api.get('load')!, context.undefined, name, callback),
    ).dispose();
    name.dispose();
    callback.dispose();
  }

  #evaluate(text: string, fileName: string): QuickJSHandle {
    return this.#enter(() => this.#context.evalCode(text, fileName), 'syntax');
  }

  #logFunction(): QuickJSHandle {
    return this.#context.newFunction('log', (level, text) => {
      this.#hooks.onLog(this.#context.getString(level), this.#context.getString(text));
    });
  }

  #hostFunction(): QuickJSHandle {
    const context = this.#context;
    return context.newFunction('callHost', (id, library, method, args) => {
      const callId = context.getNumber(id);
      const parsed = parseJson(context.getString(args), () => undefined);
      this.#callHost(
        callId,
        context.getString(library),
        context.getString(method),
        Array.isArray(parsed) ? parsed : [],
      );
    });
  }

  #callHost(id: number, library: string, method: string, args: readonly unknown[]): void {
    const answer =
      this.#hostCalls >= MAX_LIBRARY_CALLS
        ? Promise.reject(
            new Error(`A module can have at most ${MAX_LIBRARY_CALLS} library calls at once.`),
          )
        : this.#hooks.callHost(library, method, args);
    this.#hostCalls++;
    const settle = (isFulfilled: boolean, value: unknown): void => {
      this.#hostCalls--;
      if (!this.#isFree) this.#settle(id, isFulfilled, value);
    };
    answer.then(
      (value) => settle(true, value),
      (thrown: unknown) => settle(false, describeThrown(thrown)),
    );
  }

  /** An answer arrives: what waits for it goes on. */
  #settle(id: number, isFulfilled: boolean, value: unknown): void {
    const context = this.#context;
    const waiting = this.#waiting;
    // Work that no call waits for has the time budget of one call.
    if (waiting === undefined) this.#budget.begin(this.#request.limits.callTimeoutMs);
    try {
      this.#hooks.onResume();
      this.#callApi('settle', [
        context.newNumber(id),
        isFulfilled ? context.true : context.false,
        context.newString(JSON.stringify(value ?? null)),
      ]).dispose();
      this.#runJobs();
      if (waiting === undefined) return;
      const result = this.#poll();
      if (result === undefined) return;
      this.#waiting = undefined;
      waiting.resolve(result);
    } catch (thrown) {
      this.#waiting = undefined;
      if (waiting !== undefined) waiting.reject(thrown);
      else this.#hooks.onFailure(thrown);
    }
  }

  /** Calls a callback and goes on until its result is there or only answers of the host can bring it. */
  #invoke(
    phase: Phase,
    name: 'call' | 'process',
    args: readonly QuickJSHandle[],
  ): MaybePromise<RawResult> {
    this.#phase = phase;
    this.#budget.begin(this.#request.limits.callTimeoutMs);
    const returned = this.#take(this.#callApi(name, args));
    this.#runJobs();
    const result = returned ?? this.#poll();
    if (result !== undefined) return this.#resultOf(result);
    return new Promise<CallResult>((resolve, reject) => {
      this.#waiting = { resolve, reject };
    }).then((later) => this.#resultOf(later));
  }

  /** The result of the call under way, if it is there by now. */
  #poll(): CallResult | undefined {
    const result = this.#take(this.#callApi('poll', []));
    if (result !== undefined || this.#hostCalls > 0) return result;
    // Without memory, what would settle it cannot be made.
    if (this.#wasRefusedMemory) throw this.#outOfMemory();
    const message = `The promise that ${this.#phase} returned never settles: nothing is left that could resolve it.`;
    throw this.#tookTooLong(message);
  }

  #runJobs(): void {
    while (this.#runtime.hasPendingJob()) {
      this.#budget.enter();
      const ran = this.#safely(() => this.#runtime.executePendingJobs(JOBS_AT_ONCE));
      this.#budget.leave();
      if (ran.error !== undefined) {
        const thrown = this.#describe(ran.error);
        ran.error.dispose();
        this.#endIfSpent(thrown);
      } else ran.dispose();
      this.#endIfSpent();
    }
  }

  #take(handle: QuickJSHandle): CallResult | undefined {
    const context = this.#context;
    const text = context.typeof(handle) === 'string' ? context.getString(handle) : undefined;
    handle.dispose();
    if (text === undefined) return undefined;
    return readResult(text, this.#request.outputNames, (index) => this.#blob(index));
  }

  #blob(index: number): Uint8Array | undefined {
    if (index === -1) return new Uint8Array(0);
    const handle = this.#callApi('blob', [this.#context.newNumber(index)]);
    if (this.#context.typeof(handle) !== 'object') {
      handle.dispose();
      return undefined;
    }
    const copied = this.#safely(() =>
      this.#context.getArrayBuffer(handle).consume((view) => view.value.slice()),
    );
    handle.dispose();
    return copied;
  }

  #resultOf(result: CallResult): RawResult {
    if (result.kind === 'done') return isEmpty(result) ? NO_OUTPUTS : result;
    throw this.#errorOf(result.thrown, 'threw');
  }

  #callApi(name: keyof PreludeApi, args: readonly QuickJSHandle[]): QuickJSHandle {
    try {
      return this.#enter(() =>
        this.#context.callFunction(this.#api.get(name)!, this.#context.undefined, ...args),
      );
    } finally {
      for (const handle of args) handle.dispose();
    }
  }

  /** Lets the engine compute; what goes wrong in it becomes a `ModuleError`. */
  #enter(
    compute: () => ReturnType<QuickJSContext['callFunction']>,
    kind: 'syntax' | 'threw' = 'threw',
  ): QuickJSHandle {
    this.#budget.enter();
    const result = this.#safely(compute);
    this.#budget.leave();
    if (result.error === undefined) {
      if (this.#budget.isSpent) result.value.dispose();
      this.#endIfSpent();
      return result.value;
    }
    const thrown = this.#describe(result.error);
    result.error.dispose();
    this.#endIfSpent(thrown);
    throw this.#errorOf(thrown, thrown.name === 'SyntaxError' ? kind : 'threw');
  }

  /** After an exception of the engine itself, its state cannot be trusted. */
  #safely<T>(compute: () => T): T {
    try {
      return compute();
    } catch (cause) {
      throw this.#wasRefusedMemory
        ? this.#outOfMemory()
        : new EngineBrokenError(this.#phase, cause);
    }
  }

  #describe(thrown: QuickJSHandle): ThrownText {
    const context = this.#context;
    const wasSpent = this.#budget.isSpent;
    this.#budget.begin(REPORT_MS);
    this.#budget.enter();
    try {
      return this.#safely(() => {
        const describe = this.#api.get('describe');
        if (describe === undefined) return { name: '', message: 'The prelude failed.', stack: '' };
        const described = context.callFunction(describe, context.undefined, thrown);
        if (described.error !== undefined) {
          described.error.dispose();
          return this.#wasRefusedMemory ? OUT_OF_MEMORY : UNKNOWN;
        }
        const text = context.getString(described.value);
        described.value.dispose();
        return readThrown(parseJson(text, () => undefined));
      });
    } finally {
      this.#budget.leave();
      this.#budget.isSpent = wasSpent;
    }
  }

  #errorOf(thrown: ThrownText, kind: 'syntax' | 'threw'): ModuleError {
    if (thrown.name === OUT_OF_MEMORY.name && thrown.message === OUT_OF_MEMORY.message) {
      return this.#outOfMemory(thrown);
    }
    const { name, message } = thrown;
    const text = name === '' || name === 'Error' ? message : `${name}: ${message}`;
    return new ModuleError(moduleFault(kind, this.#phase, text, positionOf(thrown.stack)));
  }

  #outOfMemory(thrown?: ThrownText): ModuleError {
    const shortage = this.#copy.refusedMemory() ?? 'own';
    const fault = outOfMemory(this.#phase, shortage, this.#request.limits, this.#memory);
    return new ModuleError({ ...fault, ...(thrown && positionOf(thrown.stack)) });
  }

  #endIfSpent(thrown?: ThrownText): void {
    if (!this.#budget.isSpent) return;
    const message = `${this.#phase} took longer than ${this.#request.limits.callTimeoutMs} ms, the limit of one call.`;
    throw this.#tookTooLong(message, thrown);
  }

  #tookTooLong(message: string, thrown?: ThrownText): ModuleError {
    const at = thrown && positionOf(thrown.stack);
    const source = this.#request.source[this.#phase];
    const position = at && source ? loopPosition(source, at) : at;
    return new ModuleError(moduleFault('timeout', this.#phase, message, position));
  }
}

function isEmpty({ outputs, problem, undeclared }: RawResult): boolean {
  return outputs.length === 0 && problem === undefined && undeclared === undefined;
}
