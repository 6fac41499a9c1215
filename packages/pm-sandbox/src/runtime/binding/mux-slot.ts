import { MatchBudgetError } from '@ubii/patterns';
import { DATA_FORMATS, parseDataFormat, type DataFormat, type TopicMux } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { SandboxRecord, SandboxInput } from '../../ports/sandbox.ts';
import type { EncodedRecord, TopicListener, TopicSelector } from '../../ports/topic-port.ts';
import { type IdentityRule, identityRule } from './mux-identity.ts';
import { fieldFits } from './formats-fit.ts';
import type { InputSlot, SlotContext, SlotSpec, Snapshot } from './input-slot.ts';
import { muxSelector, selectorMatch } from './mux-selector.ts';

interface Element {
  record: EncodedRecord;
  receivedAtMs: number | undefined;
  readonly topicIdentity: string | undefined;
  /** As the module gets it; undefined when the record is newer. */
  handed: SandboxRecord | undefined;
}

/** The newest record of each topic a muxer selected, in order of first appearance. [PM-40] [PM-44] */
export class MuxList {
  readonly #rule: IdentityRule;
  readonly #maxElements: number;
  readonly #elements = new Map<string, Element>();
  #handed: readonly SandboxRecord[] | undefined = [];

  constructor(rule: IdentityRule, maxElements: number) {
    this.#rule = rule;
    this.#maxElements = maxElements;
  }

  get size(): number {
    return this.#elements.size;
  }

  /**
   * Takes a record. Returns false when the list is full.
   * @param receivedAtMs milliseconds since the Unix epoch, master's clock; undefined: not known
   */
  set(record: EncodedRecord, receivedAtMs?: number): boolean {
    const element = this.#elements.get(record.topic);
    if (element !== undefined) {
      element.record = record;
      element.receivedAtMs = receivedAtMs;
      element.handed = undefined;
    } else {
      if (this.#elements.size >= this.#maxElements) return false;
      const topicIdentity = this.#rule.ofTopic(record.topic);
      this.#elements.set(record.topic, { record, receivedAtMs, topicIdentity, handed: undefined });
    }
    this.#handed = undefined;
    return true;
  }

  /** The value of a topic is gone. */
  delete(topic: string): void {
    if (this.#elements.delete(topic)) this.#handed = undefined;
  }

  clear(): void {
    this.#elements.clear();
    this.#handed = undefined;
  }

  get(topic: string): EncodedRecord | undefined {
    return this.#elements.get(topic)?.record;
  }

  /** The records, as they came. */
  *records(): Iterable<EncodedRecord> {
    for (const { record } of this.#elements.values()) yield record;
  }

  /** As the module gets them: the same objects until something changes. */
  read(): readonly SandboxRecord[] {
    this.#handed ??= this.#hand();
    return this.#handed;
  }

  #hand(): SandboxRecord[] {
    const handed: SandboxRecord[] = [];
    for (const element of this.#elements.values()) {
      const { record, receivedAtMs, topicIdentity } = element;
      element.handed ??= {
        bytes: record.bytes,
        identity: this.#rule.ofRecord(record) ?? topicIdentity,
        receivedAtMs,
      };
      handed.push(element.handed);
    }
    return handed;
  }
}

/** An input mapped to a muxer: the newest records of many topics. [PM-40] to [PM-44] */
export class MuxSlot implements InputSlot, TopicListener {
  readonly name: string;
  readonly isLive = true;
  isMarked = false;
  readonly #fits: (valueField: number) => boolean;
  readonly #context: SlotContext;
  readonly #rule: IdentityRule;
  readonly #selector: TopicSelector;
  readonly #list: MuxList;
  #cancel: Cancel | undefined;
  #selects: ((topic: string) => boolean) | undefined;
  #input: SandboxInput & { readonly elements: readonly unknown[] };

  /** @throws Error with a sentence when the muxer selects nothing, or an expression is refused */
  constructor(spec: SlotSpec, mux: TopicMux, context: SlotContext) {
    this.name = spec.name;
    this.#context = context;
    this.#fits = muxFits(mux, spec.format);
    const selector = muxSelector(mux);
    if (selector === undefined) throw new Error('the muxer selects no topics');
    this.#selector = selector;
    this.#rule = identityRule(mux, context.patterns);
    this.#list = new MuxList(this.#rule, context.maxMuxElements);
    this.#input = { name: spec.name, elements: this.#list.read() };
  }

  get hasValue(): boolean {
    return this.#list.size > 0;
  }

  onRecord(record: EncodedRecord): void {
    // [PM-42] A muxer selects; what it does not select is no mistake.
    if (!this.#fits(record.valueField)) return;
    const isListed = this.#withinBudget(() => this.#list.set(record, this.#context.nowMs?.()));
    if (isListed === undefined) return;
    if (!isListed) {
      const { maxMuxElements } = this.#context;
      return this.#context.onProblem(
        this.name,
        `more than ${maxMuxElements} topics match; the others are left out`,
      );
    }
    this.isMarked = true;
    this.#context.onMark();
  }

  onGone(topic: string): void {
    this.#list.delete(topic);
  }

  markValue(): void {
    this.isMarked = this.hasValue;
  }

  takeMark(): void {
    this.isMarked = false;
  }

  read(): SandboxInput {
    const elements = this.#list.read();
    if (elements !== this.#input.elements) this.#input = { name: this.name, elements };
    return this.#input;
  }

  /** In the order known here, then what the snapshot has beyond that. */
  readFrom(snapshot: Snapshot): SandboxInput {
    const list = new MuxList(this.#rule, this.#context.maxMuxElements);
    for (const known of this.#list.records()) {
      const record = snapshot.get(known.topic);
      if (record === undefined || !this.#fits(record.valueField)) continue;
      // A snapshot that came over the wire does not say all that is known here.
      const publisherId = record.publisherId || known.publisherId;
      const deviceId = record.deviceId || known.deviceId;
      const complete = { ...record, publisherId, ...(deviceId === undefined ? {} : { deviceId }) };
      this.#withinBudget(() => list.set(complete));
    }
    for (const record of snapshot.values()) {
      if (this.#list.get(record.topic) !== undefined || !this.#fits(record.valueField)) continue;
      this.#withinBudget(() => this.#selects?.(record.topic) === true && list.set(record));
    }
    return { name: this.name, elements: list.read() };
  }

  records(): Iterable<EncodedRecord> {
    return this.#list.records();
  }

  listen(isListening: boolean): void {
    // Only the component subscription provides the topics of components.
    if (!isListening && this.#selector.kind === 'component' && this.#cancel !== undefined) return;
    this.close();
    this.#selects ??= selectorMatch(this.#selector, this.#context.patterns);
    if (isListening || this.#selects === undefined) {
      this.#cancel = this.#context.topics.subscribe(this.#selector, this);
    }
  }

  close(): void {
    this.#cancel?.();
    this.#cancel = undefined;
    this.#list.clear();
  }

  /** A topic that there was no time for is left out, until its next record. [PM-71] */
  #withinBudget<T>(find: () => T): T | undefined {
    try {
      return find();
    } catch (error) {
      if (!(error instanceof MatchBudgetError)) throw error;
      this.#context.onProblem(this.name, `${error.message}; topics are left out`);
      return undefined;
    }
  }
}

/** The muxer's own data format is exact; in its place the input takes what it can read. [PM-42] */
function muxFits(
  { dataType }: TopicMux,
  declared: DataFormat | undefined,
): (valueField: number) => boolean {
  const format = parseDataFormat(dataType);
  if (format === undefined) return fieldFits(declared);
  const { fieldNumber } = DATA_FORMATS[format];
  return (valueField) => valueField === fieldNumber;
}
