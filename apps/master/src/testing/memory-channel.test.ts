import { settle } from '@ubii/timing/testing';

import { LOCAL_CALLER } from '../core/ports/index.ts';
import type { ClientClaim, ConnectionHost, ConnectionPeer } from '../core/ports/index.ts';
import {
  Inbox,
  clientConnectionSuite,
  pingText,
  readClose,
  readText,
  readTopicData,
  type ClientEnd,
  type Seen,
} from './acceptance/index.ts';
import { openMemoryChannel, type MemoryChannel, type MemoryPeer } from './memory-channel.ts';

const FACTS: ConnectionPeer = { program: 'Suite/1.0' };

clientConnectionSuite('openMemoryChannel', (host) => ({
  dial: (claim) => new MemoryEnd(host, claim),
  caller: LOCAL_CALLER,
  tells: { program: FACTS.program, token: true, reason: true, leaving: true },
  settle,
  close: () => undefined,
}));

/** A client that takes what comes at once, unless it is paused. */
class MemoryEnd implements ClientEnd, MemoryPeer {
  readonly #seen = new Inbox<Seen>();
  readonly #unread: Uint8Array[] = [];
  readonly #ended: Promise<void>;
  #end: () => void = () => undefined;
  #isPaused = false;
  readonly #channel: MemoryChannel | undefined;

  constructor(host: ConnectionHost, claim: ClientClaim) {
    this.#ended = new Promise((resolve) => (this.#end = resolve));
    this.#channel = openMemoryChannel(host, { claim, caller: LOCAL_CALLER, facts: FACTS }, this);
    if (this.#channel === undefined) this.#end();
  }

  get queuedBytes(): number {
    return this.#unread.reduce((sum, { byteLength }) => sum + byteLength, 0);
  }

  sendBinary(bytes: Uint8Array): void {
    if (this.#isPaused) this.#unread.push(bytes);
    else this.#seen.add(readTopicData(bytes));
  }

  sendText(text: string): void {
    this.#seen.add(readText(text));
  }

  /** The master closes. */
  close(code: number, reason: string): void {
    this.#seen.add(readClose(code, reason));
    this.#end();
  }

  next(): Promise<Seen> {
    return this.#seen.next();
  }

  ended(): Promise<void> {
    return this.#ended;
  }

  sendTopicData(bytes: Uint8Array): void {
    this.#channel?.handleBinary(bytes);
  }

  sendPing(timed?: Parameters<ClientEnd['sendPing']>[0]): void {
    this.#channel?.handleText(pingText(timed));
  }

  sendPong(): void {
    this.#channel?.handleText('PONG');
  }

  sendNonsense(): void {
    this.#channel?.handleText('neither PING nor PONG');
  }

  leave(): void {
    this.#channel?.handleClose(4000);
  }

  cut(): void {
    this.#channel?.handleClose();
  }

  pause(): void {
    this.#isPaused = true;
  }

  resume(): void {
    this.#isPaused = false;
    for (const bytes of this.#unread.splice(0)) this.sendBinary(bytes);
    this.#channel?.handleDrain();
  }
}
