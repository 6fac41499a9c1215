import { DATA_FORMATS, dataFormatOfField, decodeRecord } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';
import type { EncodedRecord, TopicListener } from '../../ports/topic-port.ts';
import type { SandboxInput } from '../../ports/sandbox.ts';
import { describeField, fieldFits } from './formats-fit.ts';
import type { InputSlot, SlotContext, SlotSpec, Snapshot } from './input-slot.ts';

/**
 * Whether a record tells something else than the one before it, so that it does not replace it: every
 * event does, and a `bool` that changed. Of other formats the newest value is all that matters. [PM-25]
 */
function isOtherEvent(before: EncodedRecord, next: EncodedRecord): boolean {
  const format = dataFormatOfField(next.valueField);
  if (format === undefined || before.valueField !== next.valueField) return false;
  if (format !== 'bool') return DATA_FORMATS[format].isEvent;
  return decodeRecord(before.bytes).value !== decodeRecord(next.bytes).value;
}

/** An input mapped to a topic: the newest record that fits, or the oldest event that no run had. [PM-30] [PM-31] [PM-25] */
export class TopicSlot implements InputSlot, TopicListener {
  readonly name: string;
  readonly isLive = true;
  isMarked = false;
  readonly #waiting: SandboxInput[] = [];
  readonly #topic: string;
  readonly #fits: (valueField: number) => boolean;
  readonly #spec: SlotSpec;
  readonly #context: SlotContext;
  #cancel: Cancel | undefined;
  #record: EncodedRecord | undefined;
  #input: SandboxInput;
  /** Of the newest run, if events after it wait. */
  #taken: SandboxInput | undefined;
  #isMisfitReported = false;
  #isLossReported = false;

  constructor(spec: SlotSpec, topic: string, context: SlotContext) {
    this.name = spec.name;
    this.#topic = topic;
    this.#fits = fieldFits(spec.format);
    this.#spec = spec;
    this.#context = context;
    this.#input = { name: spec.name, record: undefined };
  }

  get hasValue(): boolean {
    return this.#record !== undefined;
  }

  onRecord(record: EncodedRecord): void {
    if (!this.#fits(record.valueField)) return this.#reportMisfit(record);
    if (this.isMarked) this.#keep(this.#record, record);
    this.#record = record;
    this.#input = inputOf(this.name, record);
    this.isMarked = true;
    this.#context.onMark();
  }

  onGone(): void {
    this.#forgetWaiting();
    this.#record = undefined;
    this.#input = { name: this.name, record: undefined };
  }

  markValue(): void {
    this.#forgetWaiting();
    this.isMarked = this.hasValue;
  }

  takeMark(): void {
    this.#taken = this.#waiting.shift();
    this.isMarked = this.#taken !== undefined;
  }

  read(): SandboxInput {
    return this.#taken ?? this.#input;
  }

  readFrom(snapshot: Snapshot): SandboxInput {
    const record = snapshot.get(this.#topic);
    if (record !== undefined && this.#fits(record.valueField)) return inputOf(this.name, record);
    if (record !== undefined) this.#reportMisfit(record);
    return { name: this.name, record: undefined };
  }

  records(): Iterable<EncodedRecord> {
    return this.#record === undefined ? [] : [this.#record];
  }

  listen(isListening: boolean): void {
    this.close();
    if (!isListening) return;
    const { topics } = this.#context;
    this.#cancel = topics.subscribe({ kind: 'topic', topic: this.#topic }, this);
  }

  close(): void {
    this.#cancel?.();
    this.#cancel = undefined;
    this.onGone();
  }

  #keep(before: EncodedRecord | undefined, next: EncodedRecord): void {
    const maxWaitingEvents = this.#context.maxWaitingEvents();
    if (maxWaitingEvents === 0 || before === undefined || !isOtherEvent(before, next)) return;
    this.#waiting.push(this.#input);
    // The newest does not wait here.
    if (this.#waiting.length < maxWaitingEvents) return;
    this.#waiting.shift();
    if (this.#isLossReported) return;
    this.#isLossReported = true;
    this.#context.onProblem(
      this.name,
      `more than ${maxWaitingEvents} events waited for a run; the oldest are left out`,
    );
  }

  #forgetWaiting(): void {
    this.#waiting.length = 0;
    this.#taken = undefined;
  }

  #reportMisfit(record: EncodedRecord): void {
    if (this.#isMisfitReported) return;
    this.#isMisfitReported = true;
    const came = describeField(record.valueField);
    this.#context.onProblem(
      this.name,
      `a record on ${this.#topic} was left out: it has ${came}, but the input expects ${this.#spec.format}`,
    );
  }
}

// The buffer is not given away even if it could be: the next run may need the record again. [PM-36]
function inputOf(name: string, record: EncodedRecord): SandboxInput {
  return { name, record: { bytes: record.bytes } };
}
