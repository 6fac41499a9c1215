import type { IOMapping, TopicInputMapping } from '@ubii/proto';
import type { ParsedIo } from '../../definition/parse-module.ts';
import type { SandboxInput } from '../../ports/sandbox.ts';
import type { EncodedRecord } from '../../ports/topic-port.ts';
import type { InputMarks } from '../drivers/trigger-driver.ts';
import { constantRecord } from './constant-record.ts';
import { ConstantSlot } from './constant-slot.ts';
import type { InputSlot, SlotContext, SlotSpec, Snapshot } from './input-slot.ts';
import { MuxSlot } from './mux-slot.ts';
import { TopicSlot } from './topic-slot.ts';

interface BoundSlot {
  /** Says what it is mapped to: a mapping with an equal key needs no other slot. */
  readonly key: string;
  readonly slot: InputSlot;
}

/** The mapped inputs of one instance, kept up to date. */
export class InputBinding implements InputMarks {
  readonly #inputs: readonly ParsedIo[];
  readonly #context: SlotContext;
  #isListening: boolean;
  #isClosed = false;
  #bound: readonly BoundSlot[] = [];
  #slots: readonly InputSlot[] = [];
  /** By the name of the input. [PM-5] */
  readonly #defaults: ReadonlyMap<string, SandboxInput>;
  #unmapped: readonly SandboxInput[] = [];

  /** @param isListening false: it subscribes to nothing that a snapshot can bring */
  constructor(
    inputs: readonly ParsedIo[],
    mapping: IOMapping,
    context: SlotContext,
    isListening = true,
  ) {
    this.#inputs = inputs;
    this.#context = context;
    this.#isListening = isListening;
    this.#defaults = defaultInputs(inputs, context);
    this.rebind(mapping);
  }

  /** Maps the inputs otherwise. What did not change keeps its value and its subscription. */
  rebind(mapping: IOMapping): void {
    if (this.#isClosed) return;
    const before = new Map(this.#bound.map((bound) => [bound.key, bound]));
    const bound: BoundSlot[] = [];
    for (const spec of slotSpecs(this.#inputs, mapping)) {
      const key = slotKey(spec);
      const kept = before.get(key);
      before.delete(key);
      const slot = kept?.slot ?? this.#open(spec);
      if (slot !== undefined) bound.push({ key, slot });
    }
    this.#bound = bound;
    this.#slots = bound.map(({ slot }) => slot);
    const mapped = new Set(this.#slots.map(({ name }) => name));
    this.#unmapped = [...this.#defaults.values()].filter(({ name }) => !mapped.has(name));
    // After the new ones are open, so that a topic used by both is not given up in between.
    for (const { slot } of before.values()) slot.close();
  }

  /** Subscribes to the topics, or leaves that to the snapshots. */
  listen(isListening: boolean): void {
    if (this.#isListening === isListening) return;
    this.#isListening = isListening;
    for (const slot of this.#slots) this.#listen(slot);
  }

  /** Values of all inputs that are mapped or have a default, for a run that starts now. */
  read(): SandboxInput[] {
    return this.#withDefaults(this.#slots.map((slot) => slot.read()));
  }

  /** Values of all inputs that are mapped or have a default, for a run of a pass. */
  readFrom(snapshot: Snapshot): SandboxInput[] {
    return this.#withDefaults(this.#slots.map((slot) => slot.readFrom(snapshot)));
  }

  /** The newest records of all topics that are mapped. */
  *records(): Iterable<EncodedRecord> {
    for (const slot of this.#slots) yield* slot.records();
  }

  markValues(): void {
    for (const slot of this.#slots) slot.markValue();
  }

  /** Constants are marked at the start only, and never waited for. */
  isDue(allInputsNeedUpdate: boolean): boolean {
    let isAnyMarked = false;
    for (const slot of this.#slots) {
      if (slot.isMarked) isAnyMarked = true;
      else if (allInputsNeedUpdate && slot.isLive) return false;
    }
    return isAnyMarked;
  }

  takeMarks(): string[] {
    const names: string[] = [];
    for (const slot of this.#slots) {
      if (slot.isMarked) names.push(slot.name);
      slot.takeMark();
    }
    return names;
  }

  /** Ends all subscriptions, permanently. */
  close(): void {
    this.#isClosed = true;
    for (const slot of this.#slots) slot.close();
    this.#bound = [];
    this.#slots = [];
  }

  #withDefaults(inputs: SandboxInput[]): SandboxInput[] {
    if (this.#defaults.size === 0) return inputs;
    const filled = inputs.map((input) =>
      'record' in input && input.record === undefined
        ? (this.#defaults.get(input.name) ?? input)
        : input,
    );
    return [...filled, ...this.#unmapped];
  }

  #open(spec: SlotSpec): InputSlot | undefined {
    try {
      const slot = createSlot(spec, this.#context);
      return slot !== undefined && this.#listen(slot) ? slot : undefined;
    } catch (error) {
      this.#handleRefused(spec.name, error);
      return undefined;
    }
  }

  #listen(slot: InputSlot): boolean {
    try {
      slot.listen(this.#isListening);
      return true;
    } catch (error) {
      this.#handleRefused(slot.name, error);
      return false;
    }
  }

  #handleRefused(inputName: string, error: unknown): void {
    this.#context.onProblem(inputName, error instanceof Error ? error.message : String(error));
  }
}

/** Encodes the defaults, once. Reports those that do not fit their input. */
function defaultInputs(
  inputs: readonly ParsedIo[],
  context: SlotContext,
): ReadonlyMap<string, SandboxInput> {
  const found = new Map<string, SandboxInput>();
  for (const { name, format, isList, defaultJson } of inputs) {
    if (isList || defaultJson === '') continue;
    const record = constantRecord(defaultJson, format);
    if ('problem' in record) {
      context.onProblem(name, record.problem.replace('the constant', 'the default'));
    } else found.set(name, { name, record: { bytes: record.bytes } });
  }
  return found;
}

/** @throws Error with a sentence when the mapping cannot be followed */
function createSlot(spec: SlotSpec, context: SlotContext): InputSlot | undefined {
  const { topic, topicMux, constantJson } = spec.mapping;
  if (topicMux !== undefined) return new MuxSlot(spec, topicMux, context);
  if (topic) return new TopicSlot(spec, topic, context);
  return constantJson === '' ? undefined : new ConstantSlot(spec, context);
}

/** One for each input that is mapped; of two mappings of one input the first counts. */
function slotSpecs(inputs: readonly ParsedIo[], mapping: IOMapping): SlotSpec[] {
  const specs = new Map<string, SlotSpec>();
  for (const inputMapping of mapping.inputMappings) {
    const name = inputMapping.inputName;
    if (specs.has(name)) continue;
    const format = inputs.find((input) => input.name === name)?.format;
    specs.set(name, { name, format, mapping: inputMapping });
  }
  return [...specs.values()];
}

/** Ids and names of muxers say nothing of what they select. */
function slotKey({ name, mapping }: SlotSpec): string {
  return JSON.stringify([name, sourceOf(mapping)]);
}

function sourceOf({ topicMux, topic, constantJson }: TopicInputMapping): unknown {
  if (topicMux !== undefined) return { ...topicMux, id: '', name: '' };
  return topic ? topic : { constantJson };
}
