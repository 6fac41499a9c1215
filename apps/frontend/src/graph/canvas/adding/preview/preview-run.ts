import type { PatternCompiler } from '@ubii/patterns';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import {
  decodeRecord,
  encodeRecord,
  fromJson,
  type DataFormat,
  type TopicRecord,
} from '@ubii/proto';
import { SteppedRun } from '../../../../modules/cases/stepped-run.ts';
import type { RecordLog } from '../../../../topics/history/record-log.ts';
import { sparkNumbers } from '../../../../topics/values/value-series.ts';
import { PREVIEW_MS, type NumbersAt } from './preview-lines.ts';
import type { PreviewTask } from './preview-task.ts';

/** Most records of the input in it: 100 a second. Of more, the newest are given to the module. */
const MAX_RECORDS = 500;
/** Most values kept of each output. */
const MAX_OUTPUTS = 1000;
/** Values may arrive so long after they were measured: until then the clock of the module waits, milliseconds. */
const MAX_LATE_MS = 500;
/** Longest work at a time, milliseconds; what is left over of it is left out. */
const MAX_WORK_MS = 1000;

/** What a module put out at one output. */
export interface PreviewOutput {
  readonly name: string;
  readonly newest: TopicRecord;
  /** Oldest first; empty for values without numbers. */
  readonly numbers: readonly NumbersAt[];
}

/** Values of the input, and what the module made of them. */
export interface PreviewValues {
  /** Data format of the input. */
  readonly format: DataFormat;
  readonly input: readonly NumbersAt[];
  readonly outputs: readonly PreviewOutput[];
}

/** Runs a module on the last values of a topic, then on those that come. Nothing reaches the master. */
export class PreviewRun {
  readonly #run: SteppedRun;
  readonly #startMs: number;
  readonly #topic: string;
  readonly #outputs = new Map<string, { newest: TopicRecord; numbers: NumbersAt[] }>();
  #format: DataFormat = 'double';
  #input: NumbersAt[] = [];
  /** Number of the last record given to the module; those before the topic was opened have 0 and less. */
  #given = -Infinity;
  #isBusy = false;
  #isOver = false;

  /** @param startMs time of its first value, this computer's clock, epoch milliseconds */
  constructor(
    { module, input, topic }: PreviewTask,
    sandboxes: SandboxFactory,
    patterns: PatternCompiler,
    startMs: number,
  ) {
    this.#startMs = startMs;
    this.#topic = topic;
    const mapping = fromJson('ubii.sessions.IOMapping', {
      inputMappings: [{ inputName: input, topic }],
      outputMappings: module.outputs.map(({ internalName, isRecordList }) =>
        isRecordList
          ? {
              outputName: internalName,
              topicDemux: { outputTopicFormat: outputTopic(internalName) },
            }
          : { outputName: internalName, topic: outputTopic(internalName) },
      ),
    });
    this.#run = new SteppedRun({
      module,
      mapping,
      sandboxes,
      patterns,
      startMs: this.#startMs,
      onOutput: (output, bytes, atMs) => this.#take(output, bytes, this.#startMs + atMs),
    });
  }

  /** Why it gives no values: an error of the module. */
  get fault(): string | undefined {
    return this.#run.fault;
  }

  get values(): PreviewValues {
    const outputs = [...this.#outputs].map(([topic, output]) => ({
      name: topic.slice(outputTopic('').length),
      ...output,
    }));
    return { format: this.#format, input: this.#input, outputs };
  }

  async open(): Promise<void> {
    await this.#run.open();
    this.#run.beginPasses();
  }

  /**
   * Gives the module what came since the last call, each value at its time.
   *
   * @returns false when the call before has not ended
   */
  async advance(log: RecordLog, nowMs: number): Promise<boolean> {
    if (this.#isBusy) return false;
    this.#isBusy = true;
    const untilMs = performance.now() + MAX_WORK_MS;
    try {
      const { count, firstNumber } = log;
      const from = Math.max(firstNumber, this.#given + 1, count - MAX_RECORDS + 1);
      this.#given = count;
      for (let number = from; number <= count && performance.now() < untilMs; number++) {
        const kept = log.at(number);
        const isOld = (log.at(number + 1)?.localMs ?? Infinity) <= this.#startMs;
        if (kept?.value === undefined || isOld || this.#isOver) continue;
        const { format, value, clientId } = kept;
        // The value that the topic had at the beginning is one of it.
        const localMs = Math.max(kept.localMs, this.#startMs);
        await this.#run.moveTo(localMs - this.#startMs);
        const bytes = encodeRecord({ topic: this.#topic, format, value } as never);
        this.#run.put(this.#topic, bytes, clientId);
        await this.#run.rest();
        this.#format = format;
        const numbers = sparkNumbers(format, value);
        if (numbers.length > 0) this.#input.push({ atMs: localMs, numbers });
      }
      if (!this.#isOver) await this.#run.moveTo(nowMs - MAX_LATE_MS - this.#startMs);
    } finally {
      this.#isBusy = false;
    }
    this.#forget(nowMs - PREVIEW_MS);
    return true;
  }

  close(): Promise<void> {
    this.#isOver = true;
    return this.#run.close();
  }

  #take(topic: string, bytes: Uint8Array, atMs: number): void {
    const newest = decodeRecord(bytes);
    if (newest.format === undefined) return;
    const numbers = sparkNumbers(newest.format, newest.value);
    const before = this.#outputs.get(topic)?.numbers ?? [];
    const kept =
      numbers.length === 0 ? before : [...before.slice(1 - MAX_OUTPUTS), { atMs, numbers }];
    this.#outputs.set(topic, { newest, numbers: kept });
  }

  #forget(beforeMs: number): void {
    const isKept = ({ atMs }: NumbersAt): boolean => atMs >= beforeMs;
    this.#input = this.#input.filter(isKept);
    for (const output of this.#outputs.values()) output.numbers = output.numbers.filter(isKept);
  }
}

const outputTopic = (name: string): string => `/preview/${name}`;
