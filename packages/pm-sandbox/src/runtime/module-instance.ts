import {
  isSameValue,
  type IOMapping,
  type ModuleStatistics,
  type ProcessingMode,
} from '@ubii/proto';
import { parseMode, parseModule, type ParsedMode } from '../definition/parse-module.ts';
import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxResult } from '../ports/sandbox.ts';
import type { EncodedRecord } from '../ports/topic-port.ts';
import { InputBinding } from './binding/input-binding.ts';
import type { SlotContext, Snapshot } from './binding/input-slot.ts';
import type { OutputRecord } from './binding/output-binding.ts';
import { createDriver } from './drivers/create-driver.ts';
import type { ModeDriver, RunHost } from './drivers/mode-driver.ts';
import { InstanceLife } from './instance-life.ts';
import { InstanceOutputs } from './instance-outputs.ts';
import type { InstanceSpec } from './module-runtime.ts';
import { InstanceReports } from './reports/instance-reports.ts';
import { Runner, type RunCall } from './runner.ts';
import type { RuntimeContext } from './runtime-context.ts';

/** One module of a session: when it runs, what flows in and out, and how it lives. */
export class ModuleInstance {
  readonly #context: RuntimeContext;
  readonly #reports: InstanceReports;
  readonly #inputs: InputBinding;
  readonly #outputs: InstanceOutputs;
  readonly #runner: Runner;
  readonly #life: InstanceLife;
  readonly #host: RunHost;
  #mode: ParsedMode;
  /** Undefined only while the instance is made. */
  #driver: ModeDriver | undefined;

  constructor(spec: InstanceSpec, context: RuntimeContext) {
    const { module, mapping } = spec;
    const parsed = parseModule(module);
    const { clock, limits, nodeId } = context;
    this.#context = context;
    const { sessionId, id: moduleId, name: moduleName } = module;
    const subject = { sessionId, moduleId, moduleName, nodeId };
    this.#reports = new InstanceReports(subject, clock, limits, context.onEvent);
    this.#runner = new Runner(clock);
    this.#host = this.#createHost();
    this.#outputs = new InstanceOutputs(parsed.outputs, mapping, sessionId, context, this.#reports);
    this.#mode = parseMode(module.processingMode, limits.maxFrequencyHz);
    const inputContext: SlotContext = {
      topics: context.topics,
      patterns: context.patterns.of(sessionId),
      maxMuxElements: limits.maxMuxElements,
      nowMs: () => clock.nowMs(),
      maxWaitingEvents: () => (this.#keepsEvents ? limits.maxWaitingEvents : 0),
      onMark: () => this.#driver?.handleMark(),
      onProblem: (inputName, problem) => this.#reports.problem(`Input "${inputName}": ${problem}.`),
    };
    this.#inputs = new InputBinding(parsed.inputs, mapping, inputContext, this.#isListening);
    this.#driver = this.#createDriver();
    this.#life = new InstanceLife(spec, context, this.#reports, this.#runner, {
      onStart: () => this.#driver?.start(),
      onStop: () => this.#driver?.stop(),
      onEnd: () => {
        this.#inputs.close();
        this.#outputs.end();
      },
    });
  }

  /** Resolves with why it cannot start, or with nothing. */
  create(): Promise<ModuleFault | undefined> {
    return this.#life.create();
  }

  start(): void {
    this.#life.start();
  }

  halt(): Promise<void> {
    return this.#life.halt();
  }

  destroy(): Promise<void> {
    return this.#life.destroy();
  }

  remap(mapping: IOMapping): void {
    this.#inputs.rebind(mapping);
    this.#outputs.rebind(mapping);
  }

  setMode(mode: ProcessingMode | undefined): void {
    const next = parseMode(mode, this.#context.limits.maxFrequencyHz);
    if (isSameValue(next, this.#mode)) return;
    this.#driver?.stop();
    this.#mode = next;
    this.#inputs.listen(this.#isListening);
    this.#driver = this.#createDriver();
    if (this.#life.isProcessing) this.#driver.start();
  }

  /** The newest records of its inputs. [SE-40] */
  records(): Iterable<EncodedRecord> {
    return this.#inputs.records();
  }

  /**
   * Runs once on a snapshot, if it is in lockstep and free to run. [PM-27]
   *
   * @returns what it put out, not published; undefined when it did not run, or failed
   */
  runOnce(snapshot: Snapshot, deltaTimeMs: number): Promise<readonly OutputRecord[] | undefined> {
    const isReady = this.#life.isProcessing && this.#mode.kind === 'lockstep';
    if (!isReady || this.#runner.isBusy) return Promise.resolve(undefined);
    const inputs = this.#inputs.readFrom(snapshot);
    return new Promise((resolve) => {
      this.#run({ inputs, deltaTimeMs }, (records) => {
        this.#reports.countOutputs(records?.length ?? 0);
        resolve(records);
      });
    });
  }

  statistics(): ModuleStatistics {
    const waiting = this.#driver?.waiting ?? 0;
    const topics = this.#outputs.topicCount;
    return this.#reports.takeStatistics(this.#life.wireStatus, waiting, topics);
  }

  /** In lockstep, snapshots may bring all that the inputs need. */
  get #isListening(): boolean {
    return this.#context.lockstepInputs === 'own' || this.#mode.kind !== 'lockstep';
  }

  /** With a delay between runs, or with inputs that wait for each other, a run has the inputs of its moment. [PM-24] */
  get #keepsEvents(): boolean {
    const mode = this.#mode;
    return mode.kind === 'trigger' && mode.minDelayMs <= 0 && !mode.allInputsNeedUpdate;
  }

  /** @param deliver gets what the run put out, or nothing when it failed */
  #run(call: RunCall, deliver: (records: readonly OutputRecord[] | undefined) => void): void {
    const startMs = this.#context.clock.monotonicMs();
    this.#reports.countStart();
    this.#runner.start(call, {
      onResult: (result: SandboxResult) => {
        this.#reports.countEnd(result.durationMs);
        deliver(this.#outputs.collect(result, call.inputs));
      },
      onFault: (fault) => {
        this.#reports.countEnd(this.#context.clock.monotonicMs() - startMs);
        this.#life.handleFault(fault);
        deliver(undefined);
      },
      onLost: () => deliver(undefined),
      onEnd: () => this.#driver?.handleRunEnd(),
    });
  }

  readonly #publish = (records: readonly OutputRecord[] | undefined): void => {
    if (records !== undefined) this.#outputs.publish(records);
  };

  #createDriver(): ModeDriver {
    return createDriver(this.#mode, this.#host, this.#inputs, this.#context.limits.maxFreeHz);
  }

  #createHost(): RunHost {
    const { clock, endOfTurn } = this.#context;
    const runner = this.#runner;
    return {
      get isBusy() {
        return runner.isBusy;
      },
      get lastStartMs() {
        return runner.lastStartMs;
      },
      monotonicMs: () => clock.monotonicMs(),
      after: (delayMs, fn) => clock.after(delayMs, fn),
      atEndOfTurn: (task) => endOfTurn.add(task),
      run: (triggers) => this.#run({ inputs: this.#inputs.read(), triggers }, this.#publish),
      countOverrun: (intervalMs) => this.#reports.countOverrun(intervalMs),
    };
  }
}
