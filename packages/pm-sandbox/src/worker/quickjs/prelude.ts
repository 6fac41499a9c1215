/** Functions that the engine calls inside; results are JSON text, or undefined while a promise is awaited. */
export interface PreludeApi {
  /** Keeps a callback. */
  load(phase: string, callback: (...args: unknown[]) => unknown): void;
  /** Calls onCreated, onHalted or onDestroyed. */
  call(phase: string): string | undefined;
  /** Calls onProcessing. `hasMarks`: the JSON holds marks for bytes and for what is no JSON number. */
  process(
    deltaTimeMs: number,
    masterTimeMs: number | undefined,
    inputs: string,
    triggers: string | undefined,
    hasMarks: boolean,
    ...blobs: ArrayBuffer[]
  ): string | undefined;
  /** The result of the call under way, once there is one. */
  poll(): string | undefined;
  /** Settles a call of a host's library. */
  settle(id: number, isFulfilled: boolean, json: string): void;
  /** Bytes of the result by their number in it. */
  blob(index: number): ArrayBuffer;
  /** The thrown error as JSON: name, message, stack. */
  describe(thrown: unknown): string;
}

/**
 * Runs inside QuickJS, before the author's code, and is the only code of ours there. It is sent as
 * text: it may use its parameters and what the language offers. What it needs of the language it
 * takes beforehand, so that a module which changes `JSON` or `Promise` breaks nothing but itself.
 *
 * @param outputNames in order
 * @param libraries methods of the host's libraries, by name
 * @param awaitAdvice what to do about a promise in a result, a sentence
 */
export function prelude(
  outputNames: readonly string[],
  libraries: Readonly<Record<string, readonly string[]>>,
  levels: Readonly<Record<string, string>>,
  silent: readonly string[],
  log: (level: string, text: string) => void,
  callHost: (id: number, library: string, method: string, args: string) => void,
  awaitAdvice: string,
): PreludeApi {
  const { parse, stringify } = JSON;
  const { apply, defineProperty, ownKeys } = Reflect;
  const { freeze, keys } = Object;
  const { isArray, from } = Array;
  const { isView } = ArrayBuffer;
  const { isFinite } = Number;
  const { slice: sliceBuffer } = ArrayBuffer.prototype;
  const { slice: sliceText } = String.prototype;
  const { then } = Promise.prototype;
  const resolve = Promise.resolve.bind(Promise);
  const toText = String;
  const Bytes = Uint8Array;
  const ClampedBytes = Uint8ClampedArray;
  const Buffer = ArrayBuffer;
  const AnyError = Error;
  const Later = Promise;
  const MAX_TEXT_LENGTH = 4000;
  const MAX_UNDECLARED = 5;
  const MAX_SHOWN = 4;

  const callbacks = new Map<string, (...args: unknown[]) => unknown>();
  const getCallback = callbacks.get.bind(callbacks);
  const pendingCalls = new Map<
    number,
    { settle: (isFulfilled: boolean, value: unknown) => void }
  >();
  const takePending = (id: number) => {
    const pending = apply(Map.prototype.get, pendingCalls, [id]) as
      | { settle: (isFulfilled: boolean, value: unknown) => void }
      | undefined;
    pendingCalls.delete(id);
    return pending;
  };
  const self = {};
  let state: Record<string, unknown> = {};
  let done: string | undefined;
  let blobs: ArrayBuffer[] = [];
  let lastCallId = 0;

  const describe = (thrown: unknown): string => {
    const read = (member: string): string => {
      try {
        const value = (thrown as Record<string, unknown>)[member];
        return typeof value === 'string' ? apply(sliceText, value, [0, MAX_TEXT_LENGTH]) : '';
      } catch {
        return '';
      }
    };
    const shown = (): string => {
      try {
        return apply(sliceText, toText(thrown), [0, MAX_TEXT_LENGTH]) as string;
      } catch {
        return 'a value that cannot be shown';
      }
    };
    const isObject = typeof thrown === 'object' && thrown !== null;
    const message = isObject ? read('message') : '';
    return stringify([
      isObject ? read('name') : '',
      isObject && (message !== '' || read('name') !== '') ? message : shown(),
      isObject ? read('stack') : '',
    ]);
  };
  const failure = (thrown: unknown): string => `{"error":${describe(thrown)}}`;

  /** JSON knows no bytes, no NaN and no undefined: marks stand for them, objects with the one member `$`. */
  const replace = (_key: string, value: unknown): unknown => {
    switch (typeof value) {
      case 'number':
        if (isFinite(value)) return value === 0 && 1 / value < 0 ? { $: '-0' } : value;
        return { $: toText(value) };
      case 'undefined':
      case 'function':
      case 'symbol':
      case 'bigint':
        return { $: typeof value };
      case 'object': {
        if (value === null || isArray(value)) return value;
        if (value instanceof Buffer) return addBlob(value, 0, value.byteLength);
        if (!isView(value)) return value instanceof Later ? { $: 'promise' } : value;
        if (value instanceof Bytes || value instanceof ClampedBytes) {
          return addBlob(value.buffer as ArrayBuffer, value.byteOffset, value.byteLength);
        }
        return from(value as unknown as ArrayLike<number>);
      }
      default:
        return value;
    }
  };
  const addBlob = (buffer: ArrayBuffer, start: number, length: number): object => {
    if (length === 0) return { $: -1 };
    const isWhole = start === 0 && length === buffer.byteLength;
    const index = blobs.length;
    blobs[index] = isWhole
      ? buffer
      : (apply(sliceBuffer, buffer, [start, start + length]) as ArrayBuffer);
    return { $: index };
  };

  const revive = (value: unknown, given: readonly ArrayBuffer[]): unknown => {
    if (typeof value !== 'object' || value === null) return value;
    if (isArray(value)) {
      for (let i = 0; i < value.length; i++) value[i] = revive(value[i], given);
      return value;
    }
    const object = value as Record<string, unknown>;
    const mark = object['$'];
    if (mark !== undefined) return typeof mark === 'number' ? new Bytes(given[mark]!) : NaN;
    const names = keys(object);
    for (let i = 0; i < names.length; i++) {
      const name = names[i]!;
      const revived = revive(object[name], given);
      defineProperty(object, name, {
        value: revived,
        writable: true,
        enumerable: true,
        configurable: true,
      });
    }
    return object;
  };

  const modules: Record<string, object> = {};
  for (const library of ownKeys(libraries) as string[]) {
    const methods: Record<string, unknown> = {};
    for (const method of libraries[library]!) {
      methods[method] = (...args: unknown[]) =>
        new Later((good, bad) => {
          const id = ++lastCallId;
          const json = stringify(args, replace);
          pendingCalls.set(id, {
            settle: (isFulfilled, value) =>
              isFulfilled ? good(value) : bad(new AnyError(toText(value))),
          });
          callHost(id, library, method, json);
        });
    }
    modules[library] = freeze(methods);
  }
  freeze(modules);

  /** A state that cannot take the libraries is copied into one that can. [PM-12] */
  const withModules = (given: Record<string, unknown>): Record<string, unknown> => {
    const property = { value: modules, enumerable: false, writable: false };
    if (defineProperty(given, 'modules', property)) return given;
    const copy: Record<string, unknown> = {};
    for (const name of keys(given)) if (name !== 'modules') copy[name] = given[name];
    defineProperty(copy, 'modules', property);
    return copy;
  };
  state = withModules(state);

  const takeNothing = (): string => '{}';
  const problem = (sentence: string): string => `{"problem":${stringify(sentence)}}`;
  const misfit = (returned: unknown): string => {
    let what = isArray(returned) ? 'an array' : `a ${typeof returned}`;
    if (typeof returned === 'object' && !isArray(returned)) {
      const names = keys(returned!);
      what = '{ ';
      for (let i = 0; i < names.length && i < MAX_SHOWN; i++) {
        what += (i === 0 ? '' : ', ') + (apply(sliceText, names[i]!, [0, 40]) as string);
      }
      what += names.length > MAX_SHOWN ? ', … }' : ' }';
    }
    return problem(`onProcessing must return { outputs: { … } }, not ${what}.`);
  };
  const takeResult = (returned: unknown): string => {
    blobs = [];
    if (returned === undefined || returned === null) return '{}';
    if (typeof returned !== 'object' || isArray(returned)) return misfit(returned);
    const { outputs, state: next } = returned as { outputs?: unknown; state?: unknown };
    const isOther = returned !== state && !('outputs' in returned || 'state' in returned);
    if (isOther && keys(returned).length > 0) return misfit(returned);
    if (typeof next === 'object' && next !== null && next !== state) {
      state = withModules(next as Record<string, unknown>);
    }
    if (outputs === undefined || outputs === null) return '{}';
    if (outputs instanceof Later)
      return problem(`The value of outputs is a promise. ${awaitAdvice}`);
    if (typeof outputs !== 'object') {
      return problem(
        `outputs must be an object with a member for each output, not a ${typeof outputs}.`,
      );
    }
    let text = '';
    for (let i = 0; i < outputNames.length; i++) {
      let part: string | undefined;
      try {
        const value = (outputs as Record<string, unknown>)[outputNames[i]!];
        const json = value === undefined ? undefined : stringify(value, replace);
        if (json !== undefined) part = `[${i},${json}]`;
      } catch (thrown) {
        part = `[${i},null,${describe(thrown)}]`;
      }
      if (part !== undefined) text += text === '' ? part : `,${part}`;
    }
    const undeclared: string[] = [];
    for (const name of keys(outputs)) {
      let isDeclared = false;
      for (let i = 0; i < outputNames.length; i++) if (outputNames[i] === name) isDeclared = true;
      if (!isDeclared && undeclared.length < MAX_UNDECLARED) {
        undeclared[undeclared.length] = apply(sliceText, name, [0, MAX_TEXT_LENGTH]) as string;
      }
    }
    if (undeclared.length > 0) return `{"outputs":[${text}],"undeclared":${stringify(undeclared)}}`;
    return `{"outputs":[${text}]}`;
  };

  const invoke = (
    callback: (...args: unknown[]) => unknown,
    args: unknown[],
    take: (returned: unknown) => string,
  ): string | undefined => {
    done = undefined;
    try {
      const returned = apply(callback, self, args) as { then?: unknown } | undefined;
      const isObject = typeof returned === 'object' && returned !== null;
      if (!isObject || typeof returned.then !== 'function') return take(returned);
      const finish = (value: unknown): void => {
        try {
          done = take(value);
        } catch (thrown) {
          done = failure(thrown);
        }
      };
      const fail = (thrown: unknown): void => {
        done = failure(thrown);
      };
      void apply(then, resolve(returned), [finish, fail]);
      return undefined;
    } catch (thrown) {
      return failure(thrown);
    }
  };

  const formatValue = (value: unknown): string => {
    if (typeof value === 'string') return value;
    try {
      if (value instanceof AnyError) {
        const { name, message } = value;
        return name === '' || name === 'Error' ? message : `${name}: ${message}`;
      }
      return (typeof value === 'object' ? stringify(value) : undefined) ?? toText(value);
    } catch {
      return '[a value that cannot be shown]';
    }
  };
  const console: Record<string, unknown> = {};
  for (const method of silent) console[method] = () => undefined;
  for (const method of keys(levels)) {
    const level = levels[method]!;
    console[method] = (...values: unknown[]) => {
      let text = '';
      for (let i = 0; i < values.length; i++) text += (i === 0 ? '' : ' ') + formatValue(values[i]);
      log(level, apply(sliceText, text, [0, MAX_TEXT_LENGTH]) as string);
    };
  }
  defineProperty(globalThis, 'console', {
    value: freeze(console),
    writable: true,
    configurable: true,
  });

  // There is no other thread to share memory with.
  Reflect.deleteProperty(globalThis, 'SharedArrayBuffer');

  return {
    load: (phase, callback) => void callbacks.set(phase, callback),
    call(phase) {
      const callback = getCallback(phase);
      return callback === undefined ? '{}' : invoke(callback, [state], takeNothing);
    },
    process(deltaTimeMs, masterTimeMs, inputs, triggers, hasMarks, ...given) {
      const values = parse(inputs) as unknown;
      if (hasMarks) revive(values, given);
      state['masterTimeMs'] = masterTimeMs;
      if (triggers !== undefined) state['inputTriggerNames'] = parse(triggers);
      else delete state['inputTriggerNames'];
      return invoke(getCallback('onProcessing')!, [deltaTimeMs, values, state], takeResult);
    },
    poll: () => done,
    settle(id, isFulfilled, json) {
      takePending(id)?.settle(isFulfilled, parse(json));
    },
    blob: (index) => blobs[index]!,
    describe,
  };
}
