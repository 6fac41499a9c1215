import { decodeRecord, type RecordingMarker } from '@ubii/proto';
import { TokenBucket } from '@ubii/timing';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { IdSource } from '../ports/id-source.ts';

/** Topics that end so are of markers, such as `/study/recording/marker`. [RC-24] */
export const MARKER_TOPIC_END = '/recording/marker';

const MARKERS_PER_SECOND = 10;
const MAX_TEXT = 500;

/** A record on such a topic. */
export interface Marking {
  readonly record: Uint8Array;
  /** Id of the client that published; empty for the master. */
  readonly publisherId: string;
  /** When it came, epoch milliseconds. */
  readonly timeMs: number;
}

/** What they work with. */
export interface MarkerContext {
  readonly ids: IdSource;
  readonly clients: Pick<ClientRegistry, 'get'>;
  readonly masterName: string;
}

/** Makes markers of what clients and outputs of sessions publish. [RC-24] */
export class MarkerTopics {
  readonly #context: MarkerContext;
  #rate: TokenBucket | undefined;

  constructor(context: MarkerContext) {
    this.#context = context;
  }

  /** Returns the marker that a record is; undefined when it is none, or one too many. */
  read({ record, publisherId, timeMs }: Marking): RecordingMarker | undefined {
    const { ids, clients, masterName } = this.#context;
    const { format, value } = decodeRecord(record);
    if (format !== 'string' || value.trim() === '') return undefined;
    this.#rate ??= new TokenBucket(MARKERS_PER_SECOND, timeMs);
    if (!this.#rate.take(1, timeMs)) return undefined;
    return {
      recordingId: '',
      id: ids.uuid(),
      timeMs,
      text: value.trim().slice(0, MAX_TEXT),
      author: clients.get(publisherId)?.label ?? masterName,
      clientId: publisherId,
      isRemoved: false,
    };
  }
}
