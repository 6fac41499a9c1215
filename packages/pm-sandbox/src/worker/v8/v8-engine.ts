import type { NodeState } from '../../definition/define-processing-module.ts';
import type { ModulePhase } from '../../ports/module-fault.ts';
import type { RawOutput } from '../encode-outputs.ts';
import type {
  Engine,
  EngineHooks,
  EngineInstance,
  EngineRequest,
  MaybePromise,
  RawResult,
} from '../engine.ts';
import { createModuleConsole } from '../module-console.ts';
import { describeThrown, ModuleError, moduleFault } from '../module-error.ts';
import type { InputValues } from '../module-records.ts';
import { AWAIT_ADVICE, isThenable, shownMembers } from '../value-words.ts';
import { evaluateCallback, FIRST_LINE_OFFSET } from './evaluate-callback.ts';
import { createHostModules } from './host-modules.ts';

type Phase = Exclude<ModulePhase, ''>;
type Callback = (this: object, ...args: unknown[]) => unknown;
type State = Record<string, unknown>;

/** A place in a callback's source, both from 1. */
export interface SourcePosition {
  readonly line: number;
  readonly column: number;
}

/** Functions that a platform adds to the engine. */
export interface V8EngineOptions {
  /** Returns the position of a syntax error, which engines do not report by themselves. */
  readonly locateSyntaxError?: (text: string) => SourcePosition | undefined;
}

/** Undeclared outputs of one run that are told. */
const MAX_UNDECLARED = 5;
const PHASES: readonly Phase[] = ['onCreated', 'onProcessing', 'onHalted', 'onDestroyed'];

/** Runs trusted code in the engine that runs this program: full speed, and no wall around it. [PM-51] */
export function createV8Engine(options: V8EngineOptions = {}): Engine {
  let opened = 0;
  return { open: (request, hooks) => new V8Instance(request, hooks, ++opened, options) };
}

class V8Instance implements EngineInstance {
  readonly #callbacks = new Map<Phase, Callback>();
  /** `this` of the callbacks. */
  readonly #self = {};
  readonly #outputNames: readonly string[];
  readonly #modules: object;
  readonly #assets: object;
  readonly #loadAssets: NodeState['loadAssets'];
  readonly #previousFault: NodeState['previousFault'];
  readonly #urlOf: (phase: Phase) => string;
  #state: State;

  constructor(
    request: EngineRequest,
    hooks: EngineHooks,
    number: number,
    { locateSyntaxError }: V8EngineOptions,
  ) {
    this.#outputNames = request.outputNames;
    this.#modules = Object.freeze({ ...request.modules, ...createHostModules(request, hooks) });
    this.#assets = Object.freeze({ ...request.assets });
    this.#previousFault = Object.freeze(request.previousFault);
    this.#loadAssets = async (name) => {
      try {
        return await hooks.loadAssets(String(name));
      } finally {
        hooks.onResume();
      }
    };
    this.#urlOf = (phase) => `ubii-module-${number}-${phase}.js`;
    const console = createModuleConsole((level, text) => hooks.onLog(level, text));
    for (const phase of PHASES) {
      const source = request.source[phase];
      if (source === undefined || source.trim() === '') continue;
      this.#callbacks.set(phase, this.#load(phase, source, console, locateSyntaxError));
    }
    this.#state = this.#withGiven({});
  }

  call(phase: Exclude<Phase, 'onProcessing'>): MaybePromise<void> {
    if (!this.#callbacks.has(phase)) return;
    return this.#invoke(phase, [this.#state], () => undefined);
  }

  process(
    deltaTimeMs: number,
    inputs: InputValues,
    triggers: readonly string[] | undefined,
    masterTimeMs: number | undefined,
  ): MaybePromise<RawResult> {
    Reflect.set(this.#state, 'masterTimeMs', masterTimeMs);
    if (triggers !== undefined) Reflect.set(this.#state, 'inputTriggerNames', [...triggers]);
    // Names of before mean nothing in another mode.
    else Reflect.deleteProperty(this.#state, 'inputTriggerNames');
    return this.#invoke('onProcessing', [deltaTimeMs, inputs, this.#state], (returned) =>
      this.#take(returned),
    );
  }

  free(): void {
    this.#callbacks.clear();
  }

  #load(
    phase: Phase,
    source: string,
    console: object,
    locate: V8EngineOptions['locateSyntaxError'],
  ): Callback {
    let callback: unknown;
    try {
      callback = evaluateCallback(source, this.#urlOf(phase), console);
    } catch (thrown) {
      const kind = thrown instanceof SyntaxError ? 'syntax' : 'threw';
      const position = this.#positionOf(thrown) ?? locate?.(`(${source}\n)`);
      throw new ModuleError(moduleFault(kind, phase, describeThrown(thrown), position));
    }
    if (typeof callback === 'function') return callback as Callback;
    const message = `The source of ${phase} must be a function, not ${callback === null ? 'null' : typeof callback}.`;
    throw new ModuleError(moduleFault('missing', phase, message));
  }

  #invoke<T>(phase: Phase, args: unknown[], take: (returned: unknown) => T): MaybePromise<T> {
    const fail = (thrown: unknown): never => {
      if (thrown instanceof ModuleError) throw thrown;
      const message = describeThrown(thrown);
      throw new ModuleError(moduleFault('threw', phase, message, this.#positionOf(thrown)));
    };
    try {
      const returned = Reflect.apply(this.#callbacks.get(phase)!, this.#self, args) as unknown;
      if (!isThenable(returned)) return take(returned);
      return Promise.resolve(returned).then(take).catch(fail);
    } catch (thrown) {
      return fail(thrown);
    }
  }

  /** [PM-11] [PM-12] */
  #take(returned: unknown): RawResult {
    if (returned === undefined || returned === null) return { outputs: [], problem: undefined };
    if (typeof returned !== 'object' || Array.isArray(returned)) return misfit(returned);
    const { outputs, state } = returned as { outputs?: unknown; state?: unknown };
    const isOther = returned !== this.#state && !('outputs' in returned || 'state' in returned);
    if (isOther && Object.keys(returned).length > 0) return misfit(returned);
    if (typeof state === 'object' && state !== null && state !== this.#state) {
      this.#state = this.#withGiven(state as State);
    }
    if (outputs === undefined || outputs === null) return { outputs: [], problem: undefined };
    if (isThenable(outputs)) {
      return { outputs: [], problem: `The value of outputs is a promise. ${AWAIT_ADVICE}` };
    }
    if (typeof outputs !== 'object') {
      const problem = `outputs must be an object with a member for each output, not a ${typeof outputs}.`;
      return { outputs: [], problem };
    }
    return {
      outputs: this.#outputNames.flatMap((name) => readOutput(outputs, name)),
      problem: undefined,
      undeclared: Object.keys(outputs)
        .filter((name) => !this.#outputNames.includes(name))
        .slice(0, MAX_UNDECLARED),
    };
  }

  /** A state that cannot take the libraries and asset sets is copied into one that can. [PM-12] */
  #withGiven(state: State): State {
    const given = {
      modules: { value: this.#modules, enumerable: false, writable: false },
      assets: { value: this.#assets, enumerable: false, writable: false },
      loadAssets: { value: this.#loadAssets, enumerable: false, writable: false },
      previousFault: { value: this.#previousFault, enumerable: false, writable: false },
    };
    const isTaken = Object.entries(given).every(([name, property]) =>
      Reflect.defineProperty(state, name, property),
    );
    if (isTaken) return state;
    const copy = { ...state };
    for (const name of Object.keys(given)) Reflect.deleteProperty(copy, name);
    return Object.defineProperties(copy, given);
  }

  /** The innermost place in the author's text that a stack tells of. [PM-13] */
  #positionOf(thrown: unknown): SourcePosition | undefined {
    const stack = stackOf(thrown);
    for (const [, phase, lineText, columnText] of stack.matchAll(
      /ubii-module-\d+-(\w+)\.js:(\d+):(\d+)/g,
    )) {
      if (!stack.includes(`${this.#urlOf(phase as Phase)}:${lineText}`)) continue;
      const line = Number(lineText);
      const column = Number(columnText) - (line === 1 ? FIRST_LINE_OFFSET : 0);
      if (column > 0) return { line, column };
    }
    return undefined;
  }
}

function misfit(returned: object | string | number | boolean | symbol | bigint): RawResult {
  const isPlain = typeof returned === 'object' && !Array.isArray(returned);
  const what = isPlain
    ? shownMembers(Object.keys(returned))
    : Array.isArray(returned)
      ? 'an array'
      : `a ${typeof returned}`;
  return { outputs: [], problem: `onProcessing must return { outputs: { … } }, not ${what}.` };
}

function readOutput(outputs: object, name: string): RawOutput[] {
  try {
    const value = (outputs as Record<string, unknown>)[name];
    return value === undefined ? [] : [{ name, value }];
  } catch (thrown) {
    return [{ name, problem: describeThrown(thrown) }];
  }
}

function stackOf(thrown: unknown): string {
  try {
    const { stack } = thrown as { stack?: unknown };
    return typeof stack === 'string' ? stack : '';
  } catch {
    return '';
  }
}
