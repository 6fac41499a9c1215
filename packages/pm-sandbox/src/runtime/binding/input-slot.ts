import type { MeteredPatterns } from '@ubii/patterns';
import type { DataFormat, TopicInputMapping } from '@ubii/proto';
import type { SandboxInput } from '../../ports/sandbox.ts';
import type { EncodedRecord, TopicPort } from '../../ports/topic-port.ts';

/** The records of a lockstep pass, by topic. */
export type Snapshot = ReadonlyMap<string, EncodedRecord>;

/** One mapped input of an instance. */
export interface InputSlot {
  readonly name: string;
  /** True: it waits for records; false: it has what it ever gets. */
  readonly isLive: boolean;
  readonly hasValue: boolean;
  /** It was updated since the run before, or has an update that no run had. [PM-23] [PM-25] */
  readonly isMarked: boolean;
  /** Marks it if it has a value, the newest alone. [PM-26] */
  markValue(): void;
  /** A run starts with the oldest update that no run had, and without an update with the newest value. */
  takeMark(): void;
  /** Input of a run that starts now: the same object until it changes. */
  read(): SandboxInput;
  /** Input of a run in a pass. [PM-27] */
  readFrom(snapshot: Snapshot): SandboxInput;
  /** The newest records of its topics. [SE-40] */
  records(): Iterable<EncodedRecord>;
  /**
   * Subscribes to its topics, or no longer; without, it is filled from snapshots only.
   *
   * @throws Error with a sentence when the port refuses
   */
  listen(isListening: boolean): void;
  close(): void;
}

/** Dependencies and callbacks of slots. */
export interface SlotContext {
  readonly topics: TopicPort;
  readonly patterns: MeteredPatterns;
  readonly maxMuxElements: number;
  /** Milliseconds since the Unix epoch, master's clock; undefined where nobody asks when a record came. */
  readonly nowMs?: () => number;
  /** Events of one input that wait for a run; 0: the newest replaces what came before it. [PM-25] */
  readonly maxWaitingEvents: () => number;
  /** A slot was marked. */
  onMark(): void;
  /** Something does not fit; a sentence without the name of the input. */
  onProblem(inputName: string, problem: string): void;
}

/** Dependencies of one slot. */
export interface SlotSpec {
  readonly name: string;
  /** Undefined: any record. */
  readonly format: DataFormat | undefined;
  readonly mapping: TopicInputMapping;
}
