import type { LimitWatch } from '../counters/limit-watch.ts';

/** Bytes that uploads may bring between two looks at the files. */
const STEP_BYTES = 16 * 1024 * 1024;

/** What upload space works with. */
export interface UploadSpaceContext {
  readonly limits: LimitWatch;
  /** Returns the bytes that are left for recordings beyond so many. @throws ServiceError when there are none */
  readonly roomBeyond: (bytes: number) => Promise<number>;
}

/** An upload that asks for space. */
export interface HeldUpload {
  /** Size that it claims, bytes; 0 when it is unknown. */
  readonly declaredBytes: number;
  /** Whose it is: uploads of the same sender count together. */
  readonly sender: string;
  /** Id of the client; empty when it is none. */
  readonly clientId: string;
  /** Stores it, and calls `take` for each part before it does so. */
  readonly receive: (take: (bytes: number) => Promise<void>) => Promise<void>;
}

/** What a sender uploads now. */
interface Sender {
  uploads: number;
  /** That arrived or were declared. */
  bytes: number;
}

/** Checks uploads while they arrive, as their size may be unknown before their end. [RC-41] */
export class UploadSpace {
  readonly #context: UploadSpaceContext;
  readonly #senders = new Map<string, Sender>();
  /** Of all uploads that are under way. */
  #bytes = 0;

  constructor(context: UploadSpaceContext) {
    this.#context = context;
  }

  /**
   * Receives an upload, and takes it in. It has its space until then.
   *
   * @throws ServiceError when the upload is too large, or its sender uploads too much; what `receive` and `takeIn` throw
   */
  async hold<T>(upload: HeldUpload, takeIn: () => Promise<T>): Promise<T> {
    const { declaredBytes: declared, receive } = upload;
    const { roomBeyond } = this.#context;
    this.#requireSize(declared);
    const sender = this.#begin(upload);
    let received = 0;
    let reserved = declared;
    let next = 0;
    try {
      await roomBeyond(this.#bytes + declared);
      await receive(async (bytes) => {
        received += bytes;
        this.#bytes += bytes;
        if (received > reserved) {
          sender.bytes += received - reserved;
          reserved = received;
        }
        this.#requireSize(received);
        this.#requireBytes(upload, sender.bytes);
        if (received < next) return;
        next = received + Math.min(STEP_BYTES, await roomBeyond(this.#bytes));
      });
      return await takeIn();
    } finally {
      this.#bytes -= received;
      sender.bytes -= reserved;
      sender.uploads--;
      if (sender.uploads === 0) this.#senders.delete(upload.sender);
    }
  }

  /** [RC-47] */
  #begin(upload: HeldUpload): Sender {
    const { limits } = this.#context;
    const { uploadsPerClient } = limits.limits;
    const sender = this.#senders.get(upload.sender) ?? { uploads: 0, bytes: 0 };
    if (sender.uploads >= uploadsPerClient) {
      const text = `more than ${uploadsPerClient} uploads of one client at the same time`;
      throw limits.refusal('uploadsPerClient', text, upload.clientId);
    }
    this.#requireBytes(upload, sender.bytes + upload.declaredBytes);
    sender.uploads++;
    sender.bytes += upload.declaredBytes;
    this.#senders.set(upload.sender, sender);
    return sender;
  }

  #requireBytes({ clientId }: HeldUpload, bytes: number): void {
    const { limits } = this.#context;
    const { uploadBytesPerClient } = limits.limits;
    if (bytes <= uploadBytesPerClient) return;
    const text = `more than ${uploadBytesPerClient} bytes in all uploads of one client`;
    throw limits.refusal('uploadBytesPerClient', text, clientId);
  }

  #requireSize(bytes: number): void {
    const { limits } = this.#context;
    const { recordingUploadBytes } = limits.limits;
    if (bytes <= recordingUploadBytes) return;
    const text = `an upload of more than ${recordingUploadBytes} bytes`;
    throw limits.refusal('recordingUploadBytes', text);
  }
}
