import {
  DATA_FORMATS,
  decodeRecord,
  encode,
  type DataFormat,
  type DataFormatValues,
  type Init,
} from '@ubii/proto';
import type { ModuleFault } from '../ports/module-fault.ts';
import type {
  Sandbox,
  SandboxCall,
  SandboxEvents,
  SandboxFactory,
  SandboxOutput,
  SandboxRequest,
  SandboxResult,
  SandboxValue,
} from '../ports/sandbox.ts';

type Answer<T> = T | ModuleFault | 'pending';

/** A call that waits for the test. */
interface PendingCall {
  resolve(result: SandboxResult): void;
  reject(fault: ModuleFault): void;
}

/** A sandbox without code: the test says what each call comes to, and when. */
export class FakeSandbox implements Sandbox {
  readonly request: SandboxRequest;
  readonly events: SandboxEvents;
  /** Names of the callbacks that were called, in order; `run` for onProcessing. */
  readonly journal: string[] = [];
  /** All runs so far. */
  readonly calls: SandboxCall[] = [];
  isTerminated = false;
  #pending: PendingCall | undefined;
  readonly #factory: FakeSandboxes;

  constructor(factory: FakeSandboxes, request: SandboxRequest, events: SandboxEvents) {
    this.#factory = factory;
    this.request = request;
    this.events = events;
  }

  get isRunning(): boolean {
    return this.#pending !== undefined;
  }

  /** The newest run. */
  get lastCall(): SandboxCall | undefined {
    return this.calls.at(-1);
  }

  create(): Promise<void> {
    return this.#call('create', this.#factory.onCreate());
  }

  run(call: SandboxCall): Promise<SandboxResult> {
    if (this.#pending !== undefined) throw new Error('a callback is under way'); // [PM-10]
    this.journal.push('run');
    this.calls.push(call);
    const answer = this.#factory.onRun(call, this);
    if (answer === 'pending') {
      return new Promise((resolve, reject) => {
        this.#pending = { resolve, reject };
      });
    }
    return isFault(answer) ? Promise.reject(asReason(answer)) : Promise.resolve(answer);
  }

  halt(): Promise<void> {
    return this.#call('halt', this.#factory.onHalt());
  }

  destroy(): Promise<void> {
    return this.#call('destroy', this.#factory.onDestroy());
  }

  terminate(): void {
    this.isTerminated = true;
    this.#take()?.reject({ kind: 'crashed', phase: 'onProcessing', message: 'terminated' });
  }

  /** Ends the run under way. */
  finish(result: Partial<SandboxResult> = {}): void {
    this.#take()?.resolve({ ...EMPTY_RESULT, ...result });
  }

  /** Lets the run under way throw. */
  fail(fault: Partial<ModuleFault> = {}): void {
    this.#take()?.reject({ kind: 'threw', phase: 'onProcessing', message: 'boom', ...fault });
  }

  /** Ends the instance from inside, as a limit does. */
  kill(fault: Partial<ModuleFault> = {}): void {
    const whole: ModuleFault = {
      kind: 'timeout',
      phase: 'onProcessing',
      message: 'it took too long',
      ...fault,
    };
    this.#take()?.reject(whole);
    this.events.onKilled(whole);
  }

  #take(): PendingCall | undefined {
    const pending = this.#pending;
    this.#pending = undefined;
    return pending;
  }

  #call(name: string, answer: Answer<void>): Promise<void> {
    if (this.#pending !== undefined) throw new Error('a callback is under way'); // [PM-10]
    this.journal.push(name);
    if (answer === 'pending') return new Promise(() => {});
    return answer === undefined ? Promise.resolve() : Promise.reject(asReason(answer));
  }
}

/** Result of a run without outputs. */
export const EMPTY_RESULT: SandboxResult = { outputs: [], faults: [], durationMs: 1 };

/** Sandboxes under the control of a test. Runs wait for `finish` unless `onRun` is replaced. */
export class FakeSandboxes implements SandboxFactory {
  readonly opened: FakeSandbox[] = [];
  onCreate: () => Answer<void> = () => {};
  onRun: (call: SandboxCall, sandbox: FakeSandbox) => Answer<SandboxResult> = () => 'pending';
  onHalt: () => Answer<void> = () => {};
  onDestroy: () => Answer<void> = () => {};

  /** The newest. */
  get last(): FakeSandbox {
    const sandbox = this.opened.at(-1);
    if (sandbox === undefined) throw new Error('no sandbox was opened');
    return sandbox;
  }

  /** The newest of an instance. */
  of(instanceId: string): FakeSandbox {
    const found = this.opened.findLast(({ request }) => request.instanceId === instanceId);
    if (found === undefined) throw new Error(`no sandbox was opened for ${instanceId}`);
    return found;
  }

  open(request: SandboxRequest, events: SandboxEvents): Sandbox {
    const sandbox = new FakeSandbox(this, request, events);
    this.opened.push(sandbox);
    return sandbox;
  }

  check(): Promise<undefined> {
    return Promise.resolve(undefined);
  }

  close(): Promise<void> {
    for (const sandbox of this.opened) sandbox.terminate();
    return Promise.resolve();
  }
}

/** A value as a sandbox gives it. */
export function sandboxValue<F extends DataFormat>(
  format: F,
  value: Init<DataFormatValues[F]>,
): SandboxValue {
  const bytes = encode('ubii.topicData.TopicDataRecord', { [format]: value });
  return { bytes, valueField: DATA_FORMATS[format].fieldNumber, hasTimestamp: false };
}

/** An output as a sandbox gives it. */
export function sandboxOutput<F extends DataFormat>(
  name: string,
  format: F,
  value: Init<DataFormatValues[F]>,
): SandboxOutput {
  return { name, value: sandboxValue(format, value) };
}

/** The decoded values of a call's inputs by name: a value, a list of `[identity, value]`, or undefined. */
export function inputValues(call: SandboxCall | undefined): Record<string, unknown> {
  const values: Record<string, unknown> = {};
  for (const input of call?.inputs ?? []) {
    if ('elements' in input) {
      values[input.name] = input.elements.map(({ bytes, identity }) => [
        identity,
        decodeRecord(bytes).value,
      ]);
    } else {
      values[input.name] =
        input.record === undefined ? undefined : decodeRecord(input.record.bytes).value;
    }
  }
  return values;
}

function isFault(answer: SandboxResult | ModuleFault): answer is ModuleFault {
  return 'kind' in answer;
}

/** Faults are values; what rejects with them is meant to. */
function asReason(fault: ModuleFault): Error {
  return fault as unknown as Error;
}
