import { INFO_TOPICS } from '@ubii/proto';
import type { RecordingEvent } from '@ubii/recording';
import type { Cancel, Clock } from '@ubii/timing';
import { Hook } from '../hooks/hook.ts';
import type { Limits } from '../limits/index.ts';
import { FLIGHT_TARGET, type Recorder, type RecordToKeep } from '../ports/recorder.ts';
import type { RecordTap, TappedRecord } from '../topics/record-tap.ts';
import type { TappedSource, TopicEntry } from '../topics/topic-entry.ts';
import { eventOf, gapEvent } from './present-facts.ts';
import { MARKER_TOPIC_END } from './marker-topics.ts';
import { isImageField, isInternalTopic, type CompiledSelection } from './selection.ts';

/** What a collector works with. */
export interface CollectorContext {
  readonly clock: Clock;
  readonly limits: Limits;
  readonly recorder: Recorder;
  readonly tap: RecordTap;
}

interface Loss {
  readonly fromMs: number;
  untilMs: number;
  records: number;
}

/** From so many publishers on, they are all looked up again: those that are gone are forgotten. */
const MAX_SOURCES = 100_000;
/** Longest time that records wait, milliseconds. */
const BATCH_MS = 50;
const SESSION_NEWS = '/info/session/';
const CLIENT_NEWS = '/ubii/client/';
const DEVICE_NEWS: ReadonlySet<string> = new Set([INFO_TOPICS.newDevice, INFO_TOPICS.deleteDevice]);

/** Hands records to the recorder, some at a time, with what records them. [RC-50] */
export class RecordCollector {
  readonly #context: CollectorContext;
  readonly #selections = new Map<number, CompiledSelection>();
  #flight: 'off' | 'with images' | 'without images' = 'off';
  #sources = new WeakMap<TopicEntry, Map<string, TappedSource>>();
  #sourceCount = 0;
  #generation = 0;
  /** Records that the recorder could not take, by what should have recorded them. [RC-19] */
  readonly #losses = new Map<number, Loss>();
  /** Called before the first record of the flight recorder: until then, no recorder is needed. */
  readonly onFirstOfFlight = new Hook<[]>();
  /** Called with each record whose text is a marker, [RC-24] */
  readonly onMarker = new Hook<[marking: TappedRecord]>();
  #isFlightUsed = false;
  #cancel: Cancel | undefined = undefined;
  /** Topics that lost their value before the records that wait. */
  #ended: string[] = [];

  constructor(context: CollectorContext) {
    this.#context = context;
    context.tap.onWaiting.add((isFull) => {
      if (isFull) return this.flush();
      this.#startTimer();
    });
  }

  /** Bits of all that records. */
  get targets(): number {
    const flight = this.#flight === 'off' ? 0 : FLIGHT_TARGET;
    return [...this.#selections.keys()].reduce((bits, target) => bits | target, flight);
  }

  get #isUnused(): boolean {
    return this.#selections.size === 0 && !this.#isFlightUsed;
  }

  /** Records from now on what is selected. */
  add(target: number, selection: CompiledSelection): void {
    this.#change(() => this.#selections.set(target, selection));
  }

  remove(target: number): void {
    this.#change(() => this.#selections.delete(target));
  }

  setFlight(isOn: boolean, withImages: boolean): void {
    const images = withImages ? 'with images' : 'without images';
    this.#change(() => (this.#flight = isOn ? images : 'off'));
  }

  /** Hands over what waits. */
  flush(): void {
    this.#cancel?.();
    this.#cancel = undefined;
    if (this.#ended.length > 0) this.#context.recorder.endTopics(this.#ended);
    this.#ended = [];
    let batch: RecordToKeep[] = [];
    const send = (): void => {
      if (batch.length > 0) this.#send(batch);
      batch = [];
    };
    for (const tapped of this.#context.tap.drain()) {
      if (tapped.entry.isMasters) {
        const event = this.#handleNews(tapped);
        if (event === undefined || this.#isUnused) continue;
        send();
        this.#context.recorder.addEvent(event, this.targets);
        continue;
      }
      const { entry, record, publisherId, valueField, timeMs } = tapped;
      const source = this.#sourceOf(entry, publisherId);
      const targets = isImageField(valueField) ? source.targetsOfImages : source.targets;
      if ((targets & FLIGHT_TARGET) !== 0) this.#useFlight();
      if (targets !== 0) batch.push({ source, record, timeMs, targets });
      if (source.isOfMarkers) this.onMarker.emit(tapped);
    }
    send();
  }

  /** A topic has no value any more. [RC-33] */
  handleEnd({ topic, isMasters }: TopicEntry): void {
    if (isMasters || this.#flight === 'off') return;
    if (!this.#context.tap.isEmpty) this.flush(); // What waits came before.
    if (!this.#isFlightUsed) return;
    this.#ended.push(topic);
    this.#startTimer();
  }

  /** Ends the timer. */
  close(): void {
    this.flush();
    this.#context.tap.isOn = false;
  }

  #startTimer(): void {
    this.#cancel ??= this.#context.clock.after(BATCH_MS, () => this.flush());
  }

  /** What came before belongs to what recorded then. */
  #change(change: () => void): void {
    this.flush();
    change();
    this.#forgetSources();
    this.#context.tap.isOn = this.targets !== 0;
  }

  /** [RC-11] [RC-12] */
  #handleNews({ entry: { topic }, record, timeMs }: TappedRecord): RecordingEvent | undefined {
    const isOfSession = topic.startsWith(SESSION_NEWS);
    const isOfClient = topic.startsWith(CLIENT_NEWS);
    if ((isOfSession || isOfClient || DEVICE_NEWS.has(topic)) && this.#selections.size > 0) {
      for (const selection of this.#selections.values()) selection.refresh();
      this.#forgetSources();
    }
    return isOfSession || isOfClient ? eventOf(record, timeMs) : undefined;
  }

  #useFlight(): void {
    if (this.#isFlightUsed) return;
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

  #find(topic: string, clientId: string): TappedSource {
    const flight = isInternalTopic(topic, clientId) ? 'off' : this.#flight;
    let targets = flight === 'off' ? 0 : FLIGHT_TARGET;
    let targetsOfImages = flight === 'with images' ? FLIGHT_TARGET : 0;
    for (const [target, selection] of this.#selections) {
      if (!selection.selects(topic, clientId)) continue;
      targets |= target;
      if (!selection.withoutImages) targetsOfImages |= target;
    }
    const isOfMarkers = topic.endsWith(MARKER_TOPIC_END);
    return { topic, clientId, targets, targetsOfImages, isOfMarkers, generation: this.#generation };
  }

  #send(batch: readonly RecordToKeep[]): void {
    const { recorder, limits } = this.#context;
    if (recorder.waitingBytes > limits.recorderQueueBytes) return this.#lose(batch);
    for (const [targets, { fromMs, untilMs, records }] of this.#losses) {
      recorder.addEvent(gapEvent(fromMs, untilMs, records), targets);
    }
    this.#losses.clear();
    recorder.add(batch);
  }

  /** [RC-19] */
  #lose(batch: readonly RecordToKeep[]): void {
    for (const { targets, timeMs } of batch) {
      const loss = this.#losses.get(targets);
      if (loss === undefined) {
        this.#losses.set(targets, { fromMs: timeMs, untilMs: timeMs, records: 1 });
      } else {
        loss.untilMs = timeMs;
        loss.records++;
      }
    }
  }
}
