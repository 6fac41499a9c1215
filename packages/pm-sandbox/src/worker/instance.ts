import type { ModuleFault, ModulePhase } from '../ports/module-fault.ts';
import type { SandboxCall, SandboxRequest, SandboxResult } from '../ports/sandbox.ts';
import { MAX_LOG_LINES_PER_CALL } from '../sandbox-limits.ts';
import { encodeOutputs } from './encode-outputs.ts';
import type { Engine, EngineHooks, EngineInstance, EngineRequest, MaybePromise } from './engine.ts';
import { explainThrow } from './explain-throw.ts';
import { cutText, faultOf, ModuleError, moduleFault } from './module-error.ts';
import { decodeInputs } from './module-records.ts';
import { undeclaredName } from './nearest-name.ts';

/** Message of QuickJS for destructuring undefined or null, which does not name the value. */
const NO_OBJECT = /^TypeError: cannot convert to object$/;
/** `const { x, y } = inputs.point.vector3` */
const DESTRUCTURING = /\b(?:const|let|var)\s+(\{[^{}=]*\})\s*=\s*([^;\n]+)/g;

/**
 * Names the value that members were taken from, and its line: QuickJS gives the place of what ran before.
 *
 * @param source of the callback
 */
function explainDestructuring(fault: ModuleFault, source: string): ModuleFault {
  const { kind, line = 1, message } = fault;
  if (kind !== 'threw' || !NO_OBJECT.test(message)) return fault;
  for (const { index, 1: pattern = '', 2: from = '' } of source.matchAll(DESTRUCTURING)) {
    const lines = source.slice(0, index).split('\n');
    if (lines.length < line) continue;
    const place = { line: lines.length, column: (lines.at(-1)?.length ?? 0) + 1 };
    const taken = pattern.replace(/\s+/g, ' ');
    return {
      ...fault,
      ...place,
      message: `${from.trim()} has no value, so ${taken} cannot be taken from it. (${message})`,
    };
  }
  return fault;
}

/** Members that the node adds to the state of an instance. */
export type GivenParts = Pick<EngineRequest, 'modules' | 'hostLibraries' | 'assets'>;

/** Environment of an instance: its worker, or the thread of a test. */
export interface InstanceHost {
  readonly engine: Engine;
  /** Owner that is charged for the memory of this instance. */
  readonly owner?: number | undefined;
  /** The libraries and the asset sets it asked for. Rejects with a `ModuleError` of kind `library`. */
  loadLibraries(names: readonly string[]): MaybePromise<GivenParts>;
  nowMs(): number;
}

/** Events from an instance to its environment. */
interface InstanceHooks extends Omit<EngineHooks, 'onFailure'> {
  /** Its code failed permanently outside of a call. */
  onFailed(fault: ModuleFault): void;
}

/**
 * One module in its engine: turns records into inputs, calls the callbacks, turns what they put out
 * into records. Every engine and every kind of worker goes through here. All it throws and rejects
 * with are `ModuleFault`s.
 */
export class Instance {
  readonly #request: Omit<SandboxRequest, 'assets'>;
  readonly #host: InstanceHost;
  readonly #hooks: InstanceHooks;
  #code: EngineInstance | undefined;
  #isFree = false;
  #logLines = 0;

  constructor(request: Omit<SandboxRequest, 'assets'>, host: InstanceHost, hooks: InstanceHooks) {
    this.#request = request;
    this.#host = host;
    this.#hooks = hooks;
  }

  /** Loads the code and calls onCreated. [PM-10] */
  create(): MaybePromise<void> {
    return this.#guard('onCreated', () => {
      const libraries = this.#host.loadLibraries(this.#request.libraries);
      return libraries instanceof Promise
        ? libraries.then((loaded) => this.#open(loaded))
        : this.#open(libraries);
    });
  }

  /** Calls onProcessing. */
  run(call: SandboxCall): MaybePromise<SandboxResult> {
    const startMs = this.#host.nowMs();
    return this.#guard(
      'onProcessing',
      () => {
        const inputs = decodeInputs(call.inputs);
        const { deltaTimeMs, triggers, masterTimeMs } = call;
        const raw = this.#loaded().process(deltaTimeMs, inputs, triggers, masterTimeMs);
        return raw instanceof Promise
          ? raw.then((result) => this.#result(result, startMs))
          : this.#result(raw, startMs);
      },
      (fault) => {
        const { source, inputs } = this.#request;
        const placed = explainDestructuring(fault, source.onProcessing);
        return explainThrow(placed, source.onProcessing, inputs, call.inputs);
      },
    );
  }

  /** Calls onHalted. */
  halt(): MaybePromise<void> {
    return this.#guard('onHalted', () => this.#loaded().call('onHalted'));
  }

  /** Calls onDestroyed and frees everything, also when the callback throws. */
  destroy(): MaybePromise<void> {
    const guarded = this.#guard('onDestroyed', () => {
      try {
        const called = this.#code?.call('onDestroyed');
        if (called instanceof Promise) return called.finally(() => this.free());
      } catch (thrown) {
        this.free();
        throw thrown;
      }
      this.free();
      return undefined;
    });
    return guarded;
  }

  /** Frees everything. */
  free(): void {
    const code = this.#code;
    this.#code = undefined;
    this.#isFree = true;
    code?.free();
  }

  /** Undefined when its engine does not know. */
  memoryBytes(): number | undefined {
    return this.#code?.memoryBytes?.();
  }

  #open(libraries: GivenParts): MaybePromise<void> {
    const { source, limits, outputs, previousFault } = this.#request;
    if (source.onProcessing.trim() === '') {
      const message = 'The module has no onProcessing, which every module needs.';
      throw new ModuleError(moduleFault('missing', 'onProcessing', message));
    }
    const outputNames = outputs.map(({ name }) => name);
    const { owner } = this.#host;
    const request = { source, limits, outputNames, previousFault, owner, ...libraries };
    const start = (code: EngineInstance): MaybePromise<void> => {
      if (this.#isFree) {
        code.free();
        return;
      }
      this.#code = code;
      return code.call('onCreated');
    };
    const opened = this.#host.engine.open(request, {
      ...this.#hooks,
      onLog: (level, text) => this.#log(level, text),
      onFailure: (thrown) => this.#hooks.onFailed(faultOf(thrown, '')),
    });
    return opened instanceof Promise ? opened.then(start) : start(opened);
  }

  #loaded(): EngineInstance {
    if (this.#code === undefined) throw new Error('the instance is not created');
    return this.#code;
  }

  #result(raw: Awaited<ReturnType<EngineInstance['process']>>, startMs: number): SandboxResult {
    const durationMs = this.#host.nowMs() - startMs;
    const { outputs, limits } = this.#request;
    const { outputs: encoded, faults } = encodeOutputs(outputs, raw.outputs, limits.outputBytes);
    for (const name of raw.undeclared ?? []) {
      const declared = outputs.map((output) => output.name);
      const message = undeclaredName('Output', name, declared);
      faults.push(moduleFault('output', 'onProcessing', message));
    }
    if (raw.problem !== undefined) {
      faults.unshift(moduleFault('output', 'onProcessing', raw.problem));
    }
    return { outputs: encoded, faults, durationMs };
  }

  /** A loop that logs must not fill the way to the host. */
  #log(level: string, text: string): void {
    this.#logLines++;
    if (this.#logLines <= MAX_LOG_LINES_PER_CALL) this.#hooks.onLog(level, cutText(text));
  }

  #guard<T>(
    phase: ModulePhase,
    call: () => MaybePromise<T>,
    explain = (fault: ModuleFault): ModuleFault => fault,
  ): MaybePromise<T> {
    const fail = (thrown: unknown): never => {
      // The port says that plain faults reject.
      throw explain(faultOf(thrown, phase));
    };
    this.#endLog();
    try {
      const returned = call();
      return returned instanceof Promise ? returned.catch(fail) : returned;
    } catch (thrown) {
      return fail(thrown);
    }
  }

  #endLog(): void {
    const left = this.#logLines - MAX_LOG_LINES_PER_CALL;
    this.#logLines = 0;
    if (left > 0) this.#hooks.onLog('warn', `${left} more log lines of this call are omitted.`);
  }
}
