import { ServiceError, type FlightRecords } from '@ubii/proto';
import type { Recorder, RecordSearch } from '@ubii/recording/recorder';
import type { LimitWatch } from '../counters/limit-watch.ts';

/** What they work with. */
export interface FlightReadsContext {
  readonly limits: LimitWatch;
  readonly recorder: Recorder;
}

/** More than the plots of a page. */
const MAX_TOPICS = 64;

/** Reads what the flight recorder holds. Each read looks through all of it, so that few run at the same time. [RC-36] */
export class FlightReads {
  readonly #context: FlightReadsContext;
  readonly #byClient = new Map<string, number>();
  #running = 0;

  constructor(context: FlightReadsContext) {
    this.#context = context;
  }

  /**
   * @param clientId whose read counts for its limit
   * @throws ServiceError when these are too many topics, or too many reads run
   */
  async read(
    clientId: string,
    { topics, sinceMs }: Pick<RecordSearch, 'topics' | 'sinceMs'>,
  ): Promise<FlightRecords> {
    const { limits, recorder } = this.#context;
    if (topics.length > MAX_TOPICS) throw tooManyTopics(topics.length);
    this.#begin(clientId);
    try {
      const maxBytes = limits.limits.flightReadBytes;
      return await recorder.find({ topics: [...new Set(topics)], sinceMs, maxBytes });
    } finally {
      this.#end(clientId);
    }
  }

  #begin(clientId: string): void {
    const { limits } = this.#context;
    const { flightReads, flightReadsPerClient } = limits.limits;
    const ofClient = this.#byClient.get(clientId) ?? 0;
    if (ofClient >= flightReadsPerClient) {
      const text = `more than ${flightReadsPerClient} reads of one client at the same time`;
      throw limits.refusal('flightReadsPerClient', text, clientId);
    }
    if (this.#running >= flightReads) {
      const text = `more than ${flightReads} reads at the same time`;
      throw limits.refusal('flightReads', text, clientId);
    }
    this.#running++;
    this.#byClient.set(clientId, ofClient + 1);
  }

  #end(clientId: string): void {
    this.#running--;
    const ofClient = this.#byClient.get(clientId)! - 1;
    if (ofClient === 0) this.#byClient.delete(clientId);
    else this.#byClient.set(clientId, ofClient);
  }
}

function tooManyTopics(count: number): ServiceError {
  return new ServiceError(
    'invalid_argument',
    `${count} topics are too many for one read; ask for at most ${MAX_TOPICS}.`,
  );
}
