import type { IOMapping } from '@ubii/proto';
import { TokenBucket } from '@ubii/timing';
import type { RuntimeLimits } from '../limits.ts';
import type { TopicPort } from '../ports/topic-port.ts';
import type { ParsedIo } from '../definition/parse-module.ts';
import type { SandboxInput, SandboxResult } from '../ports/sandbox.ts';
import { OutputBinding, type OutputRecord, type OutputSink } from './binding/output-binding.ts';
import { expiryOf, isPicture } from './binding/record-completion.ts';
import type { InstanceReports } from './reports/instance-reports.ts';
import type { RuntimeContext } from './runtime-context.ts';

/**
 * The topics that the demuxers of one instance made. At the limit, a topic that was not written for a
 * while ends; when none rests, new topics are refused while the others go on. [SE-61]
 */
class MadeTopics {
  readonly #port: Pick<TopicPort, 'makeTopic' | 'endTopics'>;
  readonly #sessionId: string;
  readonly #limits: Pick<RuntimeLimits, 'maxTopics' | 'topicRestMs'>;
  /** When each was written last, monotonic milliseconds; those that rest longest come first. */
  readonly #writtenMs = new Map<string, number>();

  constructor(
    port: Pick<TopicPort, 'makeTopic' | 'endTopics'>,
    sessionId: string,
    limits: Pick<RuntimeLimits, 'maxTopics' | 'topicRestMs'>,
  ) {
    this.#port = port;
    this.#sessionId = sessionId;
    this.#limits = limits;
  }

  get count(): number {
    return this.#writtenMs.size;
  }

  /** A demuxer writes a topic. @returns why it may not, as a sentence without its end */
  write(topic: string, nowMs: number): string | undefined {
    if (!this.#writtenMs.delete(topic)) {
      const refusal = this.#make(topic, nowMs);
      if (refusal !== undefined) return refusal;
    }
    this.#writtenMs.set(topic, nowMs);
    return undefined;
  }

  /** Ends topics that are not written any more. [SE-62] */
  end(): void {
    const topics = [...this.#writtenMs.keys()];
    this.#writtenMs.clear();
    if (topics.length > 0) this.#port.endTopics?.(topics, this.#sessionId);
  }

  #make(topic: string, nowMs: number): string | undefined {
    const { maxTopics, topicRestMs } = this.#limits;
    if (this.#writtenMs.size >= maxTopics) {
      const [oldest] = this.#writtenMs;
      if (oldest === undefined || nowMs - oldest[1] < topicRestMs) {
        return `the demuxers of one module make at most ${maxTopics} topics`;
      }
      this.#writtenMs.delete(oldest[0]);
      this.#port.endTopics?.([oldest[0]], this.#sessionId);
    }
    return this.#port.makeTopic?.(topic, this.#sessionId);
  }
}

/** Outputs of an instance: completed, limited and counted. [PM-32] to [PM-35], [PM-55] */
export class InstanceOutputs {
  readonly #context: RuntimeContext;
  readonly #reports: InstanceReports;
  readonly #sessionId: string;
  readonly #binding: OutputBinding;
  readonly #made: MadeTopics;
  #demuxers: string;
  readonly #recordBudget: TokenBucket;
  readonly #byteBudget: TokenBucket;

  constructor(
    declared: readonly ParsedIo[],
    mapping: IOMapping,
    sessionId: string,
    context: RuntimeContext,
    reports: InstanceReports,
  ) {
    this.#context = context;
    this.#reports = reports;
    this.#sessionId = sessionId;
    this.#made = new MadeTopics(context.topics, sessionId, context.limits);
    this.#demuxers = demuxersOf(mapping);
    this.#binding = new OutputBinding(declared, mapping, context.completion);
    const nowMs = context.clock.monotonicMs();
    this.#recordBudget = new TokenBucket(context.limits.maxOutputsPerSecond, nowMs);
    this.#byteBudget = new TokenBucket(context.limits.maxOutputBytesPerSecond, nowMs);
  }

  /** Topics its demuxers made. */
  get topicCount(): number {
    return this.#made.count;
  }

  rebind(mapping: IOMapping): void {
    const demuxers = demuxersOf(mapping);
    // Topics of the previous demuxers may not be written any more. Topics still in use are created again.
    if (demuxers !== this.#demuxers) this.#made.end();
    this.#demuxers = demuxers;
    this.#binding.rebind(mapping);
  }

  /** Nothing is put out any more. [SE-62] */
  end(): void {
    this.#made.end();
  }

  /**
   * The complete records of a run. Refused ones are reported.
   *
   * @param inputs what the run was given: pictures stand no longer than those they were made of [PM-37]
   */
  collect(result: SandboxResult, inputs: readonly SandboxInput[]): OutputRecord[] {
    for (const fault of result.faults) this.#reports.countRefused(fault.message, fault.count ?? 1);
    if (result.outputs.length === 0) return [];
    const records: OutputRecord[] = [];
    const nowMs = this.#context.clock.monotonicMs();
    let expiry: Uint8Array | undefined;
    const sink: OutputSink = {
      overLimit: this.#overLimit,
      refuseTopic: (topic) => this.#made.write(topic, nowMs),
      expiryOf: (valueField) => (isPicture(valueField) ? (expiry ??= expiryOf(inputs)) : undefined),
      onRecord: (record) => void records.push(record),
      onRefused: (reason, count) => this.#reports.countRefused(reason, count),
      onTopicsRefused: (output, reason, count) =>
        this.#reports.countTopicsRefused(output, reason, count),
    };
    this.#binding.route(result.outputs, this.#context.clock.nowMs(), sink);
    return records;
  }

  /** Publishes them in one turn. [PM-35] */
  publish(records: readonly OutputRecord[]): void {
    for (const { topic, bytes, valueField } of records) {
      const refusal = this.#context.topics.publish(topic, bytes, valueField, this.#sessionId);
      if (refusal === undefined) this.#reports.countOutputs(1);
      else this.#reports.countRefused(`Cannot publish on ${topic}: ${refusal}`, 1);
    }
  }

  readonly #overLimit = (sizeBytes: number): string | undefined => {
    const { clock, limits } = this.#context;
    const nowMs = clock.monotonicMs();
    if (!this.#byteBudget.has(sizeBytes, nowMs)) {
      return `more than ${limits.maxOutputBytesPerSecond} bytes per second. Further records are dropped`;
    }
    if (!this.#recordBudget.take(1, nowMs)) {
      return `more than ${limits.maxOutputsPerSecond} records per second. Further records are dropped`;
    }
    this.#byteBudget.take(sizeBytes, nowMs);
    return undefined;
  };
}

function demuxersOf({ outputMappings }: IOMapping): string {
  return JSON.stringify(
    outputMappings.flatMap(({ outputName, topicDemux }) =>
      topicDemux === undefined ? [] : [outputName, topicDemux.outputTopicFormat],
    ),
  );
}
