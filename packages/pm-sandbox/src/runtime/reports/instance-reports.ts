import {
  ModuleEventKind,
  ProcessingModuleStatus,
  type ModuleEvent,
  type ModuleStatistics,
} from '@ubii/proto';
import { TokenBucket, type Clock } from '@ubii/timing';
import type { AssetProgress } from '../../assets/asset-store.ts';
import type { RuntimeLimits } from '../../limits.ts';
import type { ModuleFault } from '../../ports/module-fault.ts';
import { EventThrottle } from './event-throttle.ts';
import { RunDurations } from './run-statistics.ts';
import { RunRate } from './run-statistics.ts';

/** The instance that the reports describe. */
export interface ReportSubject {
  readonly sessionId: string;
  readonly moduleId: string;
  readonly moduleName: string;
  readonly nodeId: string;
}

/** Characters of one event's text; the rest is cut. A stack of calls or a small object fits. */
const MAX_MESSAGE_LENGTH = 4096;

/** Counters and events of one instance. [PM-80] [PM-81] */
export class InstanceReports {
  readonly #subject: ReportSubject;
  readonly #clock: Clock;
  readonly #throttle: EventThrottle;
  readonly #logLines: TokenBucket;
  readonly #maxLogLines: number;
  readonly #durations = new RunDurations();
  #runs = 0;
  #overruns = 0;
  /** The interval that the run under way exceeded, milliseconds. */
  #exceededMs: number | undefined;
  #errors = 0;
  #restarts = 0;
  #outputs = 0;
  #refused = 0;
  #topicsRefused = 0;
  #refusedOutput = '';
  #memoryBytes = 0;
  #loading: AssetProgress | undefined = undefined;
  readonly #runRate: RunRate;

  constructor(
    subject: ReportSubject,
    clock: Clock,
    limits: RuntimeLimits,
    onEvent: (event: ModuleEvent) => void,
  ) {
    this.#subject = subject;
    this.#clock = clock;
    this.#throttle = new EventThrottle(clock, limits.maxEventsPerSecond, onEvent);
    this.#runRate = new RunRate(clock.monotonicMs());
    this.#maxLogLines = limits.maxLogLinesPerSecond;
    this.#logLines = new TokenBucket(limits.maxLogLinesPerSecond, clock.monotonicMs());
  }

  countStart(): void {
    this.#runs++;
  }

  /** A run ended by itself, well or not. */
  countEnd(durationMs: number): void {
    this.#durations.add(durationMs);
    this.#reportOverrun(durationMs);
  }

  countError(fault: ModuleFault): void {
    this.#errors++;
    this.fault(ModuleEventKind.ERROR, fault);
  }

  /** A run ended with its sandbox. */
  countLostRun(): void {
    this.#errors++;
    this.#reportOverrun(Infinity);
  }

  countOutputs(count: number): void {
    this.#outputs += count;
  }

  /**
   * A run was still under way when the next one was due. Its end tells why.
   *
   * @param intervalMs between two runs
   */
  countOverrun(intervalMs: number): void {
    this.#overruns++;
    this.#exceededMs = intervalMs;
  }

  /** @param count records that were not published */
  countRefused(message: string, count: number): void {
    this.#refused += count;
    this.#tell({ kind: ModuleEventKind.REFUSED, phase: 'onProcessing', message });
  }

  /** @param count elements of an output that would have made topics too many [SE-61] */
  countTopicsRefused(output: string, reason: string, count: number): void {
    this.#topicsRefused += count;
    this.#refusedOutput = output;
    const message = `Output "${output}": elements on new topics are dropped, ${reason}. Existing topics continue.`;
    this.#refused += count;
    // No fault of a run, which continues with the topics there are.
    this.#tell({ kind: ModuleEventKind.REFUSED, message });
  }

  /** It has so much memory now. */
  noteMemory(bytes: number): void {
    this.#memoryBytes = bytes;
  }

  /** @param progress of its asset sets; `undefined`: nothing loads any more [PM-94] */
  noteLoading(progress: AssetProgress | undefined): void {
    this.#loading = progress;
  }

  countRestart(): void {
    this.#restarts++;
    const message = 'The module restarted with an empty state.';
    this.#tell({ kind: ModuleEventKind.RESTARTED, message });
  }

  /** The module stays ended: the cause first. Flushes what is held back. [PM-54] */
  reportFailed(fault: ModuleFault): void {
    this.#throttle.flush();
    const message = `${fault.message} The module stopped after too many restarts.`;
    this.fault(ModuleEventKind.FAILED, { ...fault, message });
  }

  /** Something does not fit that is no error of the code. */
  problem(message: string): void {
    this.#tell({ kind: ModuleEventKind.ERROR, message });
  }

  fault(kind: ModuleEventKind, { phase, message, line, column }: ModuleFault): void {
    this.#tell({ kind, phase, message, line: line ?? 0, column: column ?? 0 });
  }

  /** [PM-14] [PM-55] */
  log(level: string, text: string): void {
    if (this.#logLines.take(1, this.#clock.monotonicMs())) {
      return this.#tell({ kind: ModuleEventKind.LOG, level, message: text });
    }
    const message = `More than ${this.#maxLogLines} log lines per second. Further lines are dropped.`;
    this.#tell({ kind: ModuleEventKind.REFUSED, message });
  }

  /** Since the call before. */
  takeStatistics(
    status: ModuleStatistics['status'],
    waiting: number,
    topics: number,
  ): ModuleStatistics {
    const { p50Ms, p95Ms } = this.#durations.take();
    const runsPerSecond = this.#runRate.take(this.#runs, this.#clock.monotonicMs());
    const isHalted = status === ProcessingModuleStatus.HALTED;
    return {
      moduleId: this.#subject.moduleId,
      moduleName: this.#subject.moduleName,
      nodeId: this.#subject.nodeId,
      status,
      runs: this.#runs,
      runsPerSecond: isHalted ? 0 : runsPerSecond,
      runP50Ms: isHalted ? 0 : p50Ms,
      runP95Ms: isHalted ? 0 : p95Ms,
      overruns: this.#overruns,
      errors: this.#errors,
      restarts: this.#restarts,
      outputs: this.#outputs,
      outputsRefused: this.#refused,
      waiting,
      topics,
      topicsRefused: this.#topicsRefused,
      refusedOutput: this.#refusedOutput,
      memoryBytes: this.#memoryBytes,
      loadingSet: this.#loading?.name ?? '',
      loadedBytes: this.#loading?.loadedBytes ?? 0,
      loadingBytes: this.#loading?.totalBytes ?? 0,
    };
  }

  /** Tells what was left out so far. */
  close(): void {
    this.#throttle.close();
  }

  /** The module was slow, or its node, which started the run or took its result late. [PM-22] */
  #reportOverrun(durationMs: number): void {
    if (this.#exceededMs === undefined) return;
    const message =
      durationMs >= this.#exceededMs
        ? 'A run was skipped because the previous run had not finished.'
        : 'A run was skipped because the computer it runs on was too busy to start it on time.';
    this.#exceededMs = undefined;
    this.#tell({ kind: ModuleEventKind.OVERRUN, phase: 'onProcessing', message });
  }

  #tell(event: Partial<ModuleEvent> & Pick<ModuleEvent, 'kind' | 'message'>): void {
    this.#throttle.push({
      ...this.#subject,
      timeMs: this.#clock.nowMs(),
      phase: '',
      line: 0,
      column: 0,
      level: '',
      suppressed: 0,
      ...event,
      message: event.message.slice(0, MAX_MESSAGE_LENGTH),
    });
  }
}
