import { decode, encode } from '@ubii/proto';
import type { Init, ServiceReply, ServiceRequest } from '@ubii/proto';
import { ConnectionError } from '../core/connection/connection-error.ts';
import type { ServiceTransport } from '../core/ports/service-transport.ts';
import type {
  TopicDataHandler,
  TopicDataQuery,
  TopicDataTransport,
} from '../core/ports/topic-data-transport.ts';

/** The client's end of a socket, as a master in the same process sees it. */
export interface MemoryPeer {
  sendBinary(bytes: Uint8Array): void;
  sendText(text: string): void;
  close(code: number, reason: string): void;
  /** Bytes the client has not been given yet. */
  readonly queuedBytes: number;
}

/** The master's end of a socket: what it does with what the client sends. */
export interface MemoryConnection {
  handleBinary(bytes: Uint8Array): void;
  handleText(text: string): void;
  /** The client closed, or the link was cut. @param code what the client closed with */
  handleClose(code?: number): void;
}

/** A master in the same process. */
export interface MemoryMaster {
  /** Answers one request. A rejection is what a master that cannot be reached looks like. */
  handleServiceRequest(request: ServiceRequest, bearer?: string): Promise<Init<ServiceReply>>;
  /** Takes an open socket; `undefined` when it closed the peer, or when there is no master. */
  openConnection(query: TopicDataQuery, peer: MemoryPeer): MemoryConnection | undefined;
}

/**
 * Services of a master in the same process. Requests and replies are encoded and decoded as on a
 * wire, so that nothing is shared between the two sides.
 */
export function createMemoryServices(master: MemoryMaster): ServiceTransport {
  return {
    send(request, bearer) {
      const bytes = encode('ubii.services.ServiceRequest', request);
      let cancel = (): void => undefined;
      const cancelled = new Promise<never>((_, reject) => {
        cancel = () => reject(new ConnectionError('closed', 'The request was cancelled'));
      });
      return { reply: Promise.race([cancelled, exchange(bytes, bearer)]), cancel: () => cancel() };
    },
  };

  async function exchange(bytes: Uint8Array, bearer?: string): Promise<ServiceReply> {
    await Promise.resolve(); // answer only after the caller has the promise
    let reply: Init<ServiceReply>;
    try {
      const request = decode('ubii.services.ServiceRequest', bytes);
      reply = await master.handleServiceRequest(request, bearer);
    } catch (cause) {
      throw new ConnectionError('refused', 'The master cannot be reached', { cause });
    }
    return decode('ubii.services.ServiceReply', encode('ubii.services.ServiceReply', reply));
  }
}

/**
 * Topic data to and from a master in the same process. Frames are copied, and arrive in their order
 * in later microtasks, as nothing arrives within the call that sent it on a real socket.
 */
export function createMemoryTopicData(master: MemoryMaster): TopicDataTransport {
  return {
    open(query, handler) {
      const inbox = new Inbox(handler);
      const outbox: (() => void)[] = [];
      let connection: MemoryConnection | undefined;
      let isOpen = false;
      const handleOpenOnce = (): void => {
        if (isOpen || inbox.isClosed) return;
        isOpen = true;
        inbox.deliver(() => handler.handleOpen(), 0);
      };
      const peer: MemoryPeer = {
        sendBinary(bytes) {
          handleOpenOnce();
          const copy = bytes.slice();
          inbox.deliver(() => handler.handleBinary(copy), bytes.byteLength);
        },
        sendText(text) {
          handleOpenOnce();
          inbox.deliver(() => handler.handleText(text), text.length);
        },
        close(code, reason) {
          handleOpenOnce(); // a refusal, too, comes over an open socket
          isOpen = false;
          inbox.close(code, reason);
        },
        get queuedBytes() {
          return inbox.queuedBytes;
        },
      };
      const post = (deliver: (to: MemoryConnection) => void): void => {
        if (!isOpen) return;
        outbox.push(() => {
          if (connection !== undefined) deliver(connection);
        });
        void Promise.resolve().then(() => outbox.shift()?.());
      };

      void Promise.resolve().then(() => {
        if (inbox.isClosed) return;
        connection = master.openConnection(query, peer);
        if (connection === undefined) inbox.close(1006, ''); // unless it was closed with a code
        else handleOpenOnce();
      });

      return {
        sendBinary: (borrowedBytes) => {
          const bytes = borrowedBytes.slice();
          post((to) => to.handleBinary(bytes));
        },
        sendText: (text) => post((to) => to.handleText(text)),
        bufferedBytes: 0,
        close: (code = 1000, reason = '') => {
          if (inbox.isClosed) return;
          post((to) => to.handleClose(code));
          isOpen = false;
          inbox.close(code, reason);
        },
      };
    },
  };
}

/** Frames and the close on their way to the client, in order. */
class Inbox {
  readonly #handler: TopicDataHandler;
  readonly #deliveries: (() => void)[] = [];
  #queuedBytes = 0;
  #isClosed = false;

  constructor(handler: TopicDataHandler) {
    this.#handler = handler;
  }

  get isClosed(): boolean {
    return this.#isClosed;
  }

  get queuedBytes(): number {
    return this.#queuedBytes;
  }

  deliver(delivery: () => void, bytes: number): void {
    if (this.#isClosed) return;
    this.#queuedBytes += bytes;
    this.#post(() => {
      this.#queuedBytes -= bytes;
      delivery();
    });
  }

  close(code: number, reason: string): void {
    if (this.#isClosed) return;
    this.#isClosed = true;
    this.#post(() => this.#handler.handleClose(code, reason));
  }

  #post(delivery: () => void): void {
    this.#deliveries.push(delivery);
    void Promise.resolve().then(() => this.#deliveries.shift()?.());
  }
}
