import { INFO_TOPICS } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import { eventOf, FLIGHT_TARGET, isInternalTopic, type Recorder } from '@ubii/recording/recorder';
import type { RecordTaker, RecordTap } from '../topics/record-tap.ts';
import { isEventField, type TappedSource, type TopicEntry } from '../topics/topic-entry.ts';
import { MARKER_TOPIC_END, type Marking } from './marker-topics.ts';
import type { RecordingInterest } from './recording-interest.ts';
import { isImageField, type CompiledSelection } from './selection.ts';

/** What a collector works with. */
export interface CollectorContext {
  readonly clock: Clock;
  readonly recorder: Recorder;
  readonly tap: RecordTap;
  /** Asks the other masters for what is recorded here; undefined without a cluster. [CU-17] */
  readonly interest: RecordingInterest | undefined;
}

/** A recording of a node: the master sends it the publishers of what it records. [RC-61] */
export interface RemoteRecording {
  readonly selection: CompiledSelection;
  /** Called for each publisher on each topic, as often as it is looked up. */
  readonly onSource: (topic: string, clientId: string) => void;
}

/** Whether a recording may begin with the value of a topic. [ST-26] */
export type MayBeginWith = (entry: TopicEntry) => boolean;

/** Something that records here. */
interface Target {
  readonly selection: CompiledSelection;
  readonly startedMs: number;
  readonly mayBeginWith: MayBeginWith;
  /** Ends what it asks other masters for. */
  readonly endInterest: (() => void) | undefined;
}

/** From so many publishers on, they are all looked up again: those that are gone are forgotten. */
const MAX_SOURCES = 100_000;
/** Longest time that markers wait, milliseconds. */
const MARKING_MS = 50;
/** Markers that wait: more at once are too many for any recording. [RC-24] */
const MAX_MARKINGS = 100;
const SESSION_NEWS = '/info/session/';
const CLIENT_NEWS = '/ubii/client/';
const DEVICE_NEWS: ReadonlySet<string> = new Set([INFO_TOPICS.newDevice, INFO_TOPICS.deleteDevice]);

/** Hands records to the recorder, with what records them. [RC-50] */
export class RecordCollector implements RecordTaker {
  readonly #context: CollectorContext;
  readonly #targets = new Map<number, Target>();
  readonly #remotes = new Set<RemoteRecording>();
  #flight: 'off' | 'with images' | 'without images' = 'off';
  #sources = new WeakMap<TopicEntry, Map<string, TappedSource>>();
  #sourceCount = 0;
  #generation = 0;
  /** Called before the first record of the flight recorder: until then, no recorder is needed. */
  readonly onFirstOfFlight = new Hook<[]>();
  /** Called with each record whose text is a marker, [RC-24] */
  readonly onMarker = new Hook<[marking: Marking]>();
  #isFlightUsed = false;
  #cancel: Cancel | undefined = undefined;
  #markings: Marking[] = [];
  #areSelectionsStale = false;

  constructor(context: CollectorContext) {
    this.#context = context;
  }

  /** Bits of all that records. */
  get targets(): number {
    const flight = this.#flight === 'off' ? 0 : FLIGHT_TARGET;
    return [...this.#targets.keys()].reduce((bits, target) => bits | target, flight);
  }

  get #isUnused(): boolean {
    return this.#targets.size === 0 && !this.#isFlightUsed;
  }

  /** Records from now on what is selected, beginning with the values that topics have now. [RC-9] */
  add(
    target: number,
    selection: CompiledSelection,
    topics: Iterable<TopicEntry>,
    mayBeginWith: MayBeginWith = () => true,
  ): void {
    const startedMs = this.#context.clock.nowMs();
    const endInterest = this.#context.interest?.(selection.selection);
    const added = { selection, startedMs, mayBeginWith, endInterest };
    this.#change(() => this.#targets.set(target, added));
    for (const entry of topics) {
      if (mayBeginWith(entry)) this.#addValue(entry, target, startedMs);
    }
    this.flush();
  }

  remove(target: number): void {
    const removed = this.#targets.get(target);
    this.#change(() => this.#targets.delete(target));
    removed?.endInterest?.();
  }

  /** Looks from now on for what a node records. @returns ends it */
  watch(remote: RemoteRecording): () => void {
    this.#change(() => this.#remotes.add(remote));
    const endInterest = this.#context.interest?.(remote.selection.selection);
    return () => {
      this.#change(() => this.#remotes.delete(remote));
      endInterest?.();
    };
  }

  setFlight(isOn: boolean, withImages: boolean): void {
    const images = withImages ? 'with images' : 'without images';
    this.#change(() => (this.#flight = isOn ? images : 'off'));
  }

  take(entry: TopicEntry, record: Uint8Array): void {
    if (entry.isMasters) return this.#takeNews(entry, record);
    const { publisherId, publishedMs } = entry;
    const source = this.#sourceOf(entry, publisherId);
    const targets = isImageField(entry.valueField) ? source.targetsOfImages : source.targets;
    if (targets !== 0) this.#record(source, record, publishedMs, targets);
    if (source.isOfMarkers) this.#addMarking({ record, publisherId, timeMs: publishedMs });
  }

  takeValue(entry: TopicEntry, record: Uint8Array): void {
    if (isEventField(entry.valueField)) return;
    const source = this.#sourceOf(entry, entry.publisherId);
    let targets = isImageField(entry.valueField) ? source.targetsOfImages : source.targets;
    for (const [target, { startedMs, mayBeginWith }] of this.#targets) {
      if (entry.stamp < startedMs && !mayBeginWith(entry)) targets &= ~target;
    }
    if (targets !== 0) this.#record(source, record, entry.publishedMs, targets);
  }

  /** Hands over what waits. */
  flush(): void {
    this.#cancel?.();
    this.#cancel = undefined;
    this.#context.recorder.flush();
    const markings = this.#markings;
    this.#markings = [];
    for (const marking of markings) this.onMarker.emit(marking);
  }

  /** A topic has no value any more. [RC-33] */
  handleEnd({ topic, isMasters }: TopicEntry): void {
    if (!isMasters && this.#isFlightUsed) this.#context.recorder.endTopic(topic);
  }

  /** Ends the timer. */
  close(): void {
    this.flush();
    this.#context.tap.taker = undefined;
  }

  /** What a recording that starts now takes of a topic. An event is over. [RC-9] */
  #addValue(entry: TopicEntry, target: number, timeMs: number): void {
    const { record, valueField, publisherId, isMasters } = entry;
    if (record === undefined || isMasters || isEventField(valueField)) return;
    const source = this.#sourceOf(entry, publisherId);
    const targets = isImageField(valueField) ? source.targetsOfImages : source.targets;
    if ((targets & target) !== 0) this.#record(source, record, timeMs, target);
  }

  #record(source: TappedSource, record: Uint8Array, timeMs: number, targets: number): void {
    if (!this.#isFlightUsed && (targets & FLIGHT_TARGET) !== 0) this.#useFlight();
    this.#context.recorder.add(source, record, timeMs, targets);
  }

  #addMarking(marking: Marking): void {
    if (this.#markings.length < MAX_MARKINGS) this.#markings.push(marking);
    this.#cancel ??= this.#context.clock.after(MARKING_MS, () => this.flush());
  }

  /** What came before belongs to what recorded then. */
  #change(change: () => void): void {
    this.flush();
    change();
    this.#forgetSources();
    const isOn = this.targets !== 0 || this.#remotes.size > 0;
    this.#context.tap.taker = isOn ? this : undefined;
  }

  /** [RC-11] [RC-12] */
  #takeNews({ topic, publishedMs }: TopicEntry, record: Uint8Array): void {
    const isOfSession = topic.startsWith(SESSION_NEWS);
    const isOfClient = topic.startsWith(CLIENT_NEWS);
    if (!isOfSession && !isOfClient && !DEVICE_NEWS.has(topic)) return;
    if (this.#targets.size > 0 || this.#remotes.size > 0) {
      this.#areSelectionsStale = true;
      this.#forgetSources();
    }
    const event = eventOf(topic, record, publishedMs);
    if (event !== undefined && !this.#isUnused)
      this.#context.recorder.addEvent(event, this.targets);
  }

  #useFlight(): void {
    this.#isFlightUsed = true;
    this.onFirstOfFlight.emit();
  }

  #sourceOf(entry: TopicEntry, clientId: string): TappedSource {
    const last = entry.recordSource;
    if (last?.clientId === clientId && last.generation === this.#generation) return last;
    return (entry.recordSource = this.#source(entry, clientId));
  }

  #source(entry: TopicEntry, clientId: string): TappedSource {
    let ofTopic = this.#sources.get(entry);
    if (ofTopic === undefined) this.#sources.set(entry, (ofTopic = new Map()));
    let source = ofTopic.get(clientId);
    if (source === undefined) {
      ofTopic.set(clientId, (source = this.#find(entry.topic, clientId)));
      if (++this.#sourceCount > MAX_SOURCES) this.#forgetSources();
    }
    return source;
  }

  #forgetSources(): void {
    this.#sources = new WeakMap();
    this.#sourceCount = 0;
    this.#generation++;
  }

  #refreshSelections(): void {
    for (const { selection } of this.#targets.values()) selection.refresh();
    for (const { selection } of this.#remotes) selection.refresh();
    this.#areSelectionsStale = false;
  }

  #find(topic: string, clientId: string): TappedSource {
    if (this.#areSelectionsStale) this.#refreshSelections();
    const flight = isInternalTopic(topic, clientId) ? 'off' : this.#flight;
    let targets = flight === 'off' ? 0 : FLIGHT_TARGET;
    let targetsOfImages = flight === 'with images' ? FLIGHT_TARGET : 0;
    for (const [target, { selection }] of this.#targets) {
      if (!selection.selects(topic, clientId)) continue;
      targets |= target;
      if (!selection.withoutImages) targetsOfImages |= target;
    }
    for (const { selection, onSource } of this.#remotes) {
      if (selection.selects(topic, clientId)) onSource(topic, clientId);
    }
    const isOfMarkers = topic.endsWith(MARKER_TOPIC_END);
    return {
      topic,
      clientId,
      targets,
      targetsOfImages,
      isOfMarkers,
      generation: this.#generation,
      channel: undefined,
    };
  }
}
