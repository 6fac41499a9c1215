import type { LimitWatch } from '../counters/limit-watch.ts';

/** Bytes that uploads may bring between two looks at the files. */
const STEP_BYTES = 16 * 1024 * 1024;

/** What upload space works with. */
export interface UploadSpaceContext {
  readonly limits: LimitWatch;
  /** Returns the bytes that are left for recordings beyond so many. @throws ServiceError when there are none */
  readonly roomBeyond: (bytes: number) => Promise<number>;
}

/** Checks uploads while they arrive, as their size may be unknown before their end. [RC-41] */
export class UploadSpace {
  readonly #context: UploadSpaceContext;
  /** Of all uploads that arrive now. */
  #bytes = 0;

  constructor(context: UploadSpaceContext) {
    this.#context = context;
  }

  /**
   * Receives an upload.
   *
   * @param declared size that it claims, bytes; 0 when it is unknown
   * @param receive stores it, and calls `take` for each part before it does so
   * @throws ServiceError when the upload is too large; what `receive` throws
   */
  async hold(
    declared: number,
    receive: (take: (bytes: number) => Promise<void>) => Promise<void>,
  ): Promise<void> {
    const { roomBeyond } = this.#context;
    let received = 0;
    let next = 0;
    this.#requireSize(declared);
    await roomBeyond(this.#bytes + declared);
    try {
      await receive(async (bytes) => {
        received += bytes;
        this.#bytes += bytes;
        this.#requireSize(received);
        if (received < next) return;
        next = received + Math.min(STEP_BYTES, await roomBeyond(this.#bytes));
      });
    } finally {
      this.#bytes -= received;
    }
  }

  #requireSize(bytes: number): void {
    const { limits } = this.#context;
    const { recordingUploadBytes } = limits.limits;
    if (bytes <= recordingUploadBytes) return;
    const text = `an upload of more than ${recordingUploadBytes} bytes`;
    throw limits.refusal('recordingUploadBytes', text);
  }
}
