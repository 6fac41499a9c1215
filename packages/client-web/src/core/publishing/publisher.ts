import type { DataFormat } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { Link } from '../connection/link.ts';
import type { MasterTime } from '../time/master-time.ts';
import { endingRecord, toWaitingRecord, waitingRecordOf } from './publication.ts';
import { PublishBuffer, type PublishOptions, type PublishSink } from './publish-buffer.ts';

/** What publishing works with. */
export interface PublisherContext {
  readonly clock: Clock;
  readonly masterTime: Pick<MasterTime, 'nowMs'>;
  /** Whether timestamps are in the time of the master unless a record says otherwise. [TS-9] */
  readonly stampsInMasterTime: boolean;
  /** Interval of the frames, milliseconds. */
  readonly intervalMs: number;
  /** Empty before the first connection. */
  readonly clientId: () => string;
  /** Undefined while there is no connection. */
  readonly link: () => Pick<Link, 'bufferedBytes' | 'sendBinary'> | undefined;
}

/** Publishes records of this client: stamps and encodes them, hands their frames to the link, and counts what left. */
export class Publisher {
  readonly #context: PublisherContext;
  readonly #buffer: PublishBuffer;
  #recordsOut = 0;
  #bytesOut = 0;

  constructor(context: PublisherContext) {
    this.#context = context;
    this.#buffer = new PublishBuffer(context.clock, this.#createSink(), context.intervalMs);
  }

  /** Records that were sent. */
  get recordsOut(): number {
    return this.#recordsOut;
  }

  /** Bytes of all frames that were sent. */
  get bytesOut(): number {
    return this.#bytesOut;
  }

  /** Records that were not sent. */
  get dropped(): number {
    return this.#buffer.dropped;
  }

  /** Bytes that have not left this machine yet. */
  get bufferedBytes(): number {
    return this.#buffer.waitingBytes + (this.#context.link()?.bufferedBytes ?? 0);
  }

  setIntervalMs(intervalMs: number): void {
    this.#buffer.setIntervalMs(intervalMs);
  }

  publish(topic: string, format: DataFormat, value: unknown, options: PublishOptions = {}): void {
    const { keepSeconds, expiryMs } = options;
    const timestampMs = options.timestampMs ?? this.#nowMs(options.stampInMasterTime);
    const clientId = this.#context.clientId();
    this.#buffer.add(
      toWaitingRecord({ topic, format, value, timestampMs, clientId, keepSeconds, expiryMs }),
      options.immediate === true,
    );
  }

  /** A complete record of a module. */
  publishEncoded(topic: string, record: Uint8Array, valueField: number): void {
    this.#buffer.add(waitingRecordOf(topic, record, valueField), false);
    this.#buffer.flushSoon();
  }

  /** [TD-48] */
  endTopic(topic: string): void {
    const clientId = this.#context.clientId();
    this.#buffer.add(endingRecord({ topic, timestampMs: this.#nowMs(), clientId }), true);
  }

  /** Sends a frame without records, after all published records. Returns false without a connection. */
  sendFrame(frame: Uint8Array): boolean {
    const link = this.#context.link();
    if (link === undefined) return false;
    this.#buffer.flush();
    link.sendBinary(frame);
    this.#bytesOut += frame.byteLength;
    return true;
  }

  /** Sends what waits, as far as the link takes it. */
  flush(): void {
    this.#buffer.flush();
  }

  /** Drops what waits and stops. */
  clear(): void {
    this.#buffer.clear();
  }

  #nowMs(inMasterTime = this.#context.stampsInMasterTime): number {
    const { masterTime, clock } = this.#context;
    return (inMasterTime ? masterTime : clock).nowMs(); // [TS-9]
  }

  #createSink(): PublishSink {
    const { link } = this.#context;
    return {
      get isOpen() {
        return link() !== undefined;
      },
      get bufferedBytes() {
        return link()?.bufferedBytes ?? 0;
      },
      send: (frame, recordCount) => {
        link()?.sendBinary(frame);
        this.#recordsOut += recordCount;
        this.#bytesOut += frame.byteLength;
      },
    };
  }
}
