import { ServiceError, type RecordingMarker } from '@ubii/proto';
import { MAX_TIME_MS, type Recorder } from '@ubii/recording/recorder';
import type { Clock } from '@ubii/timing';
import type { FlightOrders } from './flight-orders.ts';
import { MarkerTopics, type MarkerContext, type Marking } from './marker-topics.ts';
import type { NodeRecordings } from './node-recordings.ts';
import type { RecordCollector } from './record-collector.ts';

/** What markers work with. */
export interface RecordingMarksContext extends MarkerContext {
  readonly clock: Clock;
  readonly recorder: Recorder;
  readonly collector: RecordCollector;
  readonly atNodes: NodeRecordings;
  readonly flight: FlightOrders;
}

/** Brings markers to what is recorded here and at nodes: those that clients ask for, and those that they publish. */
export class RecordingMarks {
  readonly #context: RecordingMarksContext;

  constructor(context: RecordingMarksContext) {
    this.#context = context;
    const markerTopics = new MarkerTopics(context);
    context.collector.onMarker.add((marking) => this.#handleMarking(markerTopics, marking));
  }

  /** [RC-20] @param author name of the client that asks */
  async mark(
    wanted: RecordingMarker,
    author: string,
    mayChangeAll: boolean,
  ): Promise<RecordingMarker> {
    const { clock, ids, recorder, collector, atNodes, flight } = this.#context;
    const { timeMs } = wanted;
    if (!(timeMs >= 0 && timeMs <= MAX_TIME_MS)) {
      throw new ServiceError(
        'invalid_argument',
        `The member time_ms is ${timeMs}, but a marker has a time in milliseconds since the Unix epoch, or 0 for now.`,
      );
    }
    collector.flush();
    const id = wanted.id === '' ? ids.uuid() : wanted.id;
    const marker = { ...wanted, id, author, timeMs: timeMs === 0 ? clock.nowMs() : timeMs };
    const isMarked = await atNodes.mark({ marker, mayChangeAll });
    if (isMarked && wanted.recordingId !== '') return marker;
    try {
      flight.sendOrders();
      return await recorder.mark({ marker, mayChangeAll });
    } catch (cause) {
      // Nothing is recorded here, but a node has the marker.
      if (isMarked) return marker;
      throw cause;
    }
  }

  /** [RC-24] */
  #handleMarking(markerTopics: MarkerTopics, marking: Marking): void {
    const { recorder, atNodes } = this.#context;
    const marker = markerTopics.read(marking);
    if (marker === undefined) return;
    // A recording that has all its markers keeps the text as a record.
    const job = { marker, kind: 'topic', mayChangeAll: false } as const;
    void recorder.mark(job).catch(() => undefined);
    void atNodes.mark(job);
  }
}
