import { MessageChannel, receiveMessageOnPort, type MessagePort } from 'node:worker_threads';
import { ServiceError } from '@ubii/proto';
import type { ServiceRequest } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { openThread, transfer, type Thread } from '@ubii/worker-rpc/node';

import type { Log } from '../../../core/ports/index.ts';
import { FORMATS, type FormatName } from '../service-format.ts';
import type { DecodeThread, DecodeThreadData } from './decode-messages.ts';
import { JoinedMessage, type MessagePiece } from './decode-messages.ts';
import type { ReceivedBody } from './receive-body.ts';

/** Largest body that is decoded on this thread, bytes and values: some milliseconds at worst. */
const SMALL_BYTES = 64 * 1024;
const SMALL_VALUES = 2_048;

/** Time for which pieces of a request are added before yielding to the event loop, milliseconds. */
const TURN_MS = 4;
/** The largest body takes a tenth of it. */
const JOB_TIMEOUT_MS = 5_000;
/** Heap of the thread. The largest body takes a quarter of it. */
const HEAP_MIB = 256;
/** A thread that has nothing to do for this long is ended. */
const IDLE_MS = 60_000;

export interface BodyDecoderContext {
  /** The decoding thread, as the build makes it; undefined: everything is decoded on this thread. */
  readonly workerFile: URL | undefined;
  readonly clock: Clock;
  readonly log: Log;
}

interface Job {
  readonly format: FormatName;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly resolve: (request: ServiceRequest) => void;
  readonly reject: (error: ServiceError) => void;
}

interface Decoder {
  readonly thread: Thread<DecodeThread>;
  readonly pieces: MessagePort;
}

/**
 * Decodes bodies: small ones at once, large ones on a thread of their own, one after the other, each
 * caller in turn. What comes back is taken in pieces, so that no body holds this thread. [SV-44]
 */
export class BodyDecoder {
  readonly #context: BodyDecoderContext;
  /** Jobs that wait, by caller; the next one is of the first caller. */
  readonly #waiting = new Map<unknown, Job[]>();
  #current: Job | undefined = undefined;
  #decoder: Decoder | undefined = undefined;
  #cancelTimer: Cancel = () => undefined;
  #isClosed = false;

  constructor(context: BodyDecoderContext) {
    this.#context = context;
  }

  /**
   * @param caller whose turn it takes
   * @throws ServiceError when it is no request
   */
  async decode(body: ReceivedBody, format: FormatName, caller: unknown): Promise<ServiceRequest> {
    const { bytes, values } = body;
    const isSmall = bytes.byteLength <= SMALL_BYTES && values <= SMALL_VALUES;
    if (isSmall || this.#context.workerFile === undefined) {
      return FORMATS[format].decodeRequest(bytes);
    }
    return new Promise((resolve, reject) => {
      const job = { format, bytes, resolve, reject };
      const jobs = this.#waiting.get(caller);
      if (jobs === undefined) this.#waiting.set(caller, [job]);
      else jobs.push(job);
      this.#startNext();
    });
  }

  /** Ends the thread; what waits is refused. */
  close(): void {
    this.#isClosed = true;
    this.#endThread('the master ends');
    for (const job of [...this.#waiting.values()].flat()) job.reject(failure('the master ends'));
    this.#waiting.clear();
  }

  #startNext(): void {
    if (this.#current !== undefined) return;
    const job = this.#nextJob();
    this.#cancelTimer();
    const { clock } = this.#context;
    if (job === undefined) {
      if (this.#decoder !== undefined) {
        this.#cancelTimer = clock.after(IDLE_MS, () => this.#endThread('it was idle'));
      }
      return;
    }
    this.#current = job;
    this.#cancelTimer = clock.after(JOB_TIMEOUT_MS, () =>
      this.#endThread(`it took longer than ${JOB_TIMEOUT_MS} ms`),
    );
    this.#decoder ??= this.#startThread(this.#context.workerFile!);
    void this.#run(job, this.#decoder);
  }

  #nextJob(): Job | undefined {
    if (this.#isClosed) return undefined;
    for (const [caller, jobs] of this.#waiting) {
      const job = jobs.shift();
      this.#waiting.delete(caller);
      if (jobs.length > 0) this.#waiting.set(caller, jobs);
      return job;
    }
    return undefined;
  }

  #startThread(workerFile: URL): Decoder {
    const { port1, port2 } = new MessageChannel();
    const workerData: DecodeThreadData = { pieces: port2 };
    const thread = openThread<DecodeThread>(
      {
        workerFile,
        name: 'ubii request decoder',
        workerData,
        transferList: [port2],
        heapMib: HEAP_MIB,
        onEnd: (reason) => this.#endThread(reason),
        lost: failure,
      },
      {},
    );
    return { thread, pieces: port1 };
  }

  async #run(job: Job, { thread, pieces }: Decoder): Promise<void> {
    const { format, bytes } = job;
    const reason = await thread.calls.decode(format, transfer(bytes, [bytes.buffer])).then(
      () => undefined,
      (error: Error) => error.message,
    );
    const request = reason === undefined ? await this.#takePieces(pieces) : undefined;
    // The thread ended meanwhile, and the job with it.
    if (this.#current !== job) return;
    if (reason !== undefined) job.reject(new ServiceError('invalid_argument', `${reason}.`));
    else job.resolve(request as unknown as ServiceRequest);
    this.#current = undefined;
    this.#startNext();
  }

  async #takePieces(pieces: MessagePort): Promise<Record<string, unknown>> {
    const { clock } = this.#context;
    const joined = new JoinedMessage();
    let startMs = clock.monotonicMs();
    for (;;) {
      const next = receiveMessageOnPort(pieces) as { readonly message: MessagePiece } | undefined;
      if (next === undefined) return joined.message;
      joined.add(next.message);
      if (clock.monotonicMs() - startMs < TURN_MS) continue;
      await new Promise<void>((resolve) => clock.after(0, resolve));
      startMs = clock.monotonicMs();
    }
  }

  /** Ends the thread and refuses what it decodes; the next job starts another. */
  #endThread(reason: string): void {
    const decoder = this.#decoder;
    const job = this.#current;
    this.#decoder = undefined;
    this.#current = undefined;
    this.#cancelTimer();
    decoder?.pieces.close();
    void decoder?.thread.end(reason);
    if (job === undefined) return;
    this.#context.log.warn('a request could not be decoded', { reason });
    job.reject(failure(reason));
    this.#startNext();
  }
}

function failure(reason: string): ServiceError {
  return new ServiceError(
    'unavailable',
    `The request could not be decoded: ${reason}. Send it again, or in smaller parts.`,
  );
}
