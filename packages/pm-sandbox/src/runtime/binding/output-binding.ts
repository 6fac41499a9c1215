import { isMasterTopic, type IOMapping } from '@ubii/proto';
import type { ParsedIo } from '../../definition/parse-module.ts';
import type { SandboxOutput, SandboxValue } from '../../ports/sandbox.ts';
import { demuxTopic, parseDemuxFormat, type DemuxFormat } from './demux-topic.ts';
import type { RecordCompletion } from './record-completion.ts';

/** A record on its way to a topic. */
export interface OutputRecord {
  readonly topic: string;
  /** The complete encoded `TopicDataRecord`. */
  readonly bytes: Uint8Array;
  readonly valueField: number;
}

/** Receiver of the outputs of a run. */
export interface OutputSink {
  /** Takes a record's share of what is allowed. Returns what is used up, if it is. [PM-55] */
  overLimit(sizeBytes: number): string | undefined;
  /** A demuxer writes a topic. Returns why it may not, if it may not. [SE-61] */
  refuseTopic(topic: string): string | undefined;
  /** When a record of this value member expires, as encoded fields. [PM-37] */
  expiryOf(valueField: number): Uint8Array | undefined;
  onRecord(record: OutputRecord): void;
  /** @param reason a sentence; `count` records are refused for it */
  onRefused(reason: string, count: number): void;
  /** @param reason a sentence; `count` elements of the output would have made topics too many */
  onTopicsRefused(outputName: string, reason: string, count: number): void;
}

type Route =
  | {
      readonly kind: 'topic';
      readonly topic: string;
      readonly origin: Uint8Array;
      /** Why nothing can be published there. */
      readonly fault: string | undefined;
    }
  | { readonly kind: 'demux'; readonly format: DemuxFormat };

interface BoundOutput {
  readonly name: string;
  readonly routes: readonly Route[];
}

/** Elements of one output of one run that are reported one by one; the others only as a number. */
const MAX_REPORTED_ELEMENTS = 3;

/** Origins of topics of demuxers that are kept, in number. Some hundred bytes each. */
const MAX_KEPT_ORIGINS = 1024;

/** The mapped outputs of one instance. */
export class OutputBinding {
  readonly #declared: readonly ParsedIo[];
  readonly #completion: RecordCompletion;
  readonly #origins = new Map<string, Uint8Array>();
  #bound: readonly BoundOutput[] = [];

  constructor(declared: readonly ParsedIo[], mapping: IOMapping, completion: RecordCompletion) {
    this.#declared = declared;
    this.#completion = completion;
    this.rebind(mapping);
  }

  rebind(mapping: IOMapping): void {
    const names = new Set([
      ...this.#declared.map((output) => output.name),
      ...mapping.outputMappings.map(({ outputName }) => outputName),
    ]);
    this.#bound = [...names].flatMap((name) => {
      const routes = this.#routes(name, mapping);
      return routes.length === 0 ? [] : [{ name, routes }];
    });
  }

  /**
   * Takes what a run put out: mapped outputs in the order of the declared ones, the others are
   * dropped. [PM-35]
   *
   * @param nowMs epoch milliseconds
   */
  route(outputs: readonly SandboxOutput[], nowMs: number, sink: OutputSink): void {
    for (const { name, routes } of this.#bound) {
      const output = outputs.find((candidate) => candidate.name === name);
      if (output === undefined) continue;
      for (const route of routes) this.#routeOne(output, route, nowMs, sink);
    }
  }

  #routeOne(output: SandboxOutput, route: Route, nowMs: number, sink: OutputSink): void {
    if (route.kind === 'topic') {
      if (route.fault !== undefined) {
        return sink.onRefused(refusal(output.name, route.fault), 1);
      }
      if ('value' in output) {
        return this.#put(output.value, route.topic, route.origin, nowMs, sink, output.name);
      }
      const reason = 'is a single value: write it without { elements: [ … ] }';
      return sink.onRefused(`Output "${output.name}" ${reason}.`, output.elements.length);
    }
    if ('value' in output) {
      const reason = 'is a list: write { elements: [ … ] }, not a single value';
      return sink.onRefused(`Output "${output.name}" ${reason}.`, 1);
    }
    this.#spread(output, route.format, nowMs, sink);
  }

  #spread(
    output: Extract<SandboxOutput, { elements: unknown }>,
    format: DemuxFormat,
    nowMs: number,
    sink: OutputSink,
  ): void {
    let refused = 0;
    let tooMany = 0;
    let tooManyReason = '';
    for (const { value, params, identity, index } of output.elements) {
      const result = demuxTopic(format, params, identity);
      const fault = 'lacks' in result ? result.lacks : topicFault(result.topic);
      if ('topic' in result && fault === undefined) {
        const { topic } = result;
        const reason = sink.refuseTopic(topic);
        if (reason !== undefined) {
          tooMany++;
          tooManyReason = reason;
          continue;
        }
        this.#put(value, topic, this.#originOf(topic), nowMs, sink, output.name);
      } else if (++refused <= MAX_REPORTED_ELEMENTS) {
        sink.onRefused(`Output "${output.name}", element ${index}: ${fault}.`, 1);
      }
    }
    if (tooMany > 0) sink.onTopicsRefused(output.name, tooManyReason, tooMany);
    const more = refused - MAX_REPORTED_ELEMENTS;
    if (more > 0)
      sink.onRefused(`Output "${output.name}": ${more} more elements have no valid topic.`, more);
  }

  #put(
    value: SandboxValue,
    topic: string,
    origin: Uint8Array,
    nowMs: number,
    sink: OutputSink,
    outputName: string,
  ): void {
    const fault = sink.overLimit(value.bytes.length + origin.length);
    if (fault !== undefined) return sink.onRefused(refusal(outputName, fault), 1);
    const { valueField } = value;
    const expiry = sink.expiryOf(valueField);
    const bytes = this.#completion.complete(value, origin, nowMs, expiry);
    sink.onRecord({ topic, bytes, valueField });
  }

  #originOf(topic: string): Uint8Array {
    const kept = this.#origins.get(topic);
    if (kept !== undefined) return kept;
    if (this.#origins.size >= MAX_KEPT_ORIGINS) this.#origins.clear();
    const origin = this.#completion.origin(topic);
    this.#origins.set(topic, origin);
    return origin;
  }

  #routes(name: string, mapping: IOMapping): Route[] {
    const routes: Route[] = [];
    for (const { outputName, topic, topicDemux } of mapping.outputMappings) {
      if (outputName !== name) continue;
      if (topicDemux !== undefined) {
        routes.push({ kind: 'demux', format: parseDemuxFormat(topicDemux.outputTopicFormat) });
      } else if (topic) {
        const origin = this.#completion.origin(topic);
        routes.push({ kind: 'topic', topic, origin, fault: topicFault(topic) });
      }
    }
    return routes;
  }
}

function refusal(outputName: string, reason: string): string {
  return `Output "${outputName}": ${reason}.`;
}

/** Why a module cannot publish on a topic; undefined when it can. [PM-47] */
export function topicFault(topic: string): string | undefined {
  if (topic === '') return 'the topic is empty';
  if (isMasterTopic(topic)) return `only the master can publish on ${topic}`;
  return undefined;
}
